// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_walker_h
#define thalweg_particles_walker_h

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <array>
#include <cstdint>
#include <map>

namespace Thalweg
{
  /// What a boundary does to a particle that reaches it.
  enum class WallKind
  {
    /// the particle slides along
    wall,
    /// the particle leaves
    open
  };

  /// The integrators along streamlines.
  enum class StreamlineScheme
  {
    /// midpoint rule, second order
    rk2,
    /// classical, fourth order
    rk4
  };

  /// How a velocity goes on between the nodes of a cell.
  enum class VelocityShape
  {
    multilinear,
    /// with what makes its divergence the same at every point of the cell
    evenly_divergent
  };

  /// What has become of a walker.
  enum class Fate : std::uint8_t
  {
    /// its time is not yet spent
    under_way,
    /// its time is spent
    arrived,
    /// it stands in a ghost cell, from where the owner has to go on
    elsewhere,
    /// it came to an open boundary
    left,
    /// a drop or a bubble that met its own fluid
    landed,
    /// its velocity or its position became undefined
    lost
  };

  /**
   * @brief Something that follows a streamline.
   *
   * Plain memory, so that it can be sent to other ranks as it is.
   */
  template <int dim>
  struct Walker
  {
    /// Reference coordinates in the cell.
    std::array<double, dim> reference;
    /// Where the last straight piece of the way began, in the reference
    /// coordinates of the cell; used if `reference` is outside the cell.
    std::array<double, dim> piece_begin;
    /// The time that is left, in s.
    double time;
    /// The part of the time already counted that the last straight piece
    /// took, in s.
    double piece_time;
    /// Number of the cell in the CellGraph.
    unsigned int cell;
    /// The boundary where the walker left, and the face of its cell.
    dealii::types::boundary_id boundary;
    std::uint8_t               face;
    Fate                       fate;

    dealii::Point<dim>
    reference_point() const
    {
      dealii::Point<dim> point;
      for (unsigned int d = 0; d < dim; ++d)
        point[d] = reference[d];
      return point;
    }

    /// One that is to walk for the time @p time from a point of a cell.
    static Walker
    start(const unsigned int        cell,
          const dealii::Point<dim> &reference,
          const double              time)
    {
      Walker walker;
      for (unsigned int d = 0; d < dim; ++d)
        walker.reference[d] = reference[d];
      walker.piece_begin = walker.reference;
      walker.time        = time;
      walker.piece_time  = 0;
      walker.cell        = cell;
      walker.boundary    = dealii::numbers::invalid_boundary_id;
      walker.face        = 0;
      walker.fate        = Fate::under_way;
      return walker;
    }
  };

  /// A walker that sums up the acceleration that it meets.
  template <int dim>
  struct PathWalker : Walker<dim>
  {
    /// The integral of the acceleration over the time walked, in m/s.
    std::array<double, dim> integral;
    /// The part of it that the last straight piece of the way brought.
    std::array<double, dim> piece_integral;

    /// One that is to walk for the time @p time from a point of a cell.
    static PathWalker
    start(const unsigned int        cell,
          const dealii::Point<dim> &reference,
          const double              time)
    {
      PathWalker walker{Walker<dim>::start(cell, reference, time), {}, {}};
      return walker;
    }
  };

  /// A drop or a bubble, which has a velocity of its own.
  template <int dim>
  struct DispersedWalker : PathWalker<dim>
  {
    std::array<double, dim> first_velocity; ///< m/s
    std::array<double, dim> acceleration;   ///< m/s^2
    bool                    is_bubble;

    /// One that is to go for the time @p time from a point of a cell.
    static DispersedWalker
    start(const unsigned int        cell,
          const dealii::Point<dim> &reference,
          const double              time)
    {
      return {PathWalker<dim>::start(cell, reference, time), {}, {}, false};
    }
  };

  /// Counters of the work that was done.
  struct WalkEffort
  {
    std::uint64_t n_substeps      = 0;
    std::uint64_t n_cells_crossed = 0;
  };

  /// What all walks of a run have in common.
  struct WalkSettings
  {
    StreamlineScheme scheme = StreamlineScheme::rk2;
    /// The greatest way of a substep in parts of the cell.
    double substep = 0.5;
    /// Boundaries that are not listed are walls.
    std::map<dealii::types::boundary_id, WallKind> walls;
  };
} // namespace Thalweg

#endif
