// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_streamline_convection_h
#define thalweg_particles_streamline_convection_h

#include <thalweg/core/section.h>
#include <thalweg/mesh/cell_field.h>
#include <thalweg/particles/population.h>
#include <thalweg/particles/streamline_walk.h>
#include <thalweg/particles/walker.h>

#include <array>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace Thalweg
{
  /// How particles follow the streamlines.
  struct ConvectionParameters
  {
    /// Declares the parameters in @p section.
    void
    declare_parameters(const Section &section);

    /// "rk2" or "rk4".
    std::string integrator = "rk2";
    /// The greatest way of a substep in parts of the cell.
    double substep_courant_number = 0.5;
  };

  /// One of the particles that were lost.
  struct LostParticle
  {
    /// Above all others if there is none; Open MPI's minimum of unsigned
    /// numbers takes what is still greater for negative.
    ParticleId id = std::numeric_limits<std::int64_t>::max();
    /// The centre of the cell in which it was when its way became undefined,
    /// in m; in two dimensions the last coordinate is zero.
    std::array<double, 3> place{};
  };

  /// A volume of fluid that particles took out of the domain.
  struct Exit
  {
    unsigned int cell; ///< an owned one of the graph
    unsigned int face; ///< its face at the boundary
    unsigned int fluid;
    double       volume; ///< m^dim
  };

  /// What became of the particles in one step, on this rank.
  struct ConvectionReport
  {
    /// Particles that ended their step on this rank.
    std::uint64_t n_moved = 0;
    /// Removed because their velocity was not a number, or because they could
    /// not be located.
    std::uint64_t n_lost = 0;
    /// Of these the one with the lowest id.
    LostParticle first_lost;
    /// Left through an open boundary: with a negative and with another level
    /// set value.
    std::map<dealii::types::boundary_id, std::array<std::uint64_t, 2>> left;
    /// Where they left and what they carried; of this rank only.
    std::vector<Exit> exits;
    /// The same of drops and bubbles.
    std::vector<Exit> dispersed_exits;
    /// What those that were lost carried of both fluids, m^dim.
    std::array<double, 2> lost_volume{};
    std::uint64_t         n_substeps      = 0;
    std::uint64_t         n_cells_crossed = 0;

    /// Counts what became of other particles of this rank, too.
    void
    add(const ConvectionReport &other);

    /// All that left, through whichever boundary.
    std::uint64_t
    n_left() const;

    /// The report for all ranks together. Collective.
    ConvectionReport
    sum(const MPI_Comm communicator) const;
  };

  /// Where a streamline began a time step ago, and what was there.
  template <int dim>
  struct Foot
  {
    /// In m; on the boundary, if the streamline came from there.
    dealii::Point<dim> position;
    /// In m/s.
    std::array<double, dim> velocity;
    double                  level_set;
    /// The open boundary through which the streamline came in, otherwise
    /// dealii::numbers::invalid_boundary_id.
    dealii::types::boundary_id boundary;
    /// How long it takes from there to the head, s.
    double way;
    /// Whether the foot was found; if not, position, velocity and level set
    /// are those of the head.
    bool found;
  };

  /// A particle that is to appear.
  template <int dim>
  struct NewParticle
  {
    unsigned int        cell; ///< an owned one of the graph
    dealii::Point<dim>  reference;
    double              time;       ///< how long it goes on from there, s
    std::vector<double> properties; ///< a row of the population's
  };

  /**
   * @brief Moves particles along the streamlines of a velocity field
   * (Eq. 64), at any Courant number and across ranks.
   */
  template <int dim>
  class StreamlineConvection
  {
  public:
    /**
     * @param mesh its cell graph must be up to date at each call
     * @param parameters the integrator
     * @param walls what particles do at which boundary; those that are not
     *   listed are walls
     * @param shape of the velocity inside the cells
     * @throws dealii::ExcMessage for parameters that make no sense
     */
    StreamlineConvection(
      const Mesh<dim>                                      &mesh,
      const ConvectionParameters                           &parameters,
      const std::map<dealii::types::boundary_id, WallKind> &walls,
      const VelocityShape shape = VelocityShape::multilinear);

    /**
     * @brief Moves all particles by the time @p dt. Collective.
     *
     * Afterwards the particles of each cell are ordered by id, whatever their
     * order was before.
     * Velocity and level set of the particles stay as they are.
     *
     * @param population each particle's reference coordinates must be those
     *   in its cell
     * @param velocity at the nodes of all owned and ghost cells, in m/s
     * @param dt in s, not negative
     */
    ConvectionReport
    move(Population<dim>         &population,
         const CellVelocity<dim> &velocity,
         const double             dt) const;

    /**
     * @brief Inserts particles that each go on for a time of their own.
     * Collective; ranks may insert any number of particles.
     *
     * @param population gets the particles
     * @param particles of this rank
     * @param velocity at the nodes of all owned and ghost cells, in m/s
     * @return what became of them, on the ranks where their ways ended
     */
    ConvectionReport
    insert(Population<dim>                     &population,
           const std::vector<NewParticle<dim>> &particles,
           const CellVelocity<dim>             &velocity) const;

    /**
     * @brief Follows the streamlines through given points backwards in time.
     * Collective; ranks may ask for any number of points.
     *
     * @param cells numbers of owned cells in the cell graph, one a point
     * @param reference_points coordinates in these cells
     * @param velocity at the nodes of all owned and ghost cells, in m/s
     * @param level_set at the nodes of all owned and ghost cells
     * @param dt in s, not negative
     * @return one foot a point, with velocity and level set interpolated there
     */
    std::vector<Foot<dim>>
    trace_back(const std::vector<unsigned int>       &cells,
               const std::vector<dealii::Point<dim>> &reference_points,
               const CellVelocity<dim>               &velocity,
               const CellField<dim, 1>               &level_set,
               const double                           dt) const;

    /// For others that go along. @param direction 1, or -1 against the velocity
    StreamlineWalk<dim>
    walk(const CellVelocity<dim> &velocity, const double direction) const;

    const Mesh<dim> &
    mesh() const
    {
      return mesh_;
    }

  private:
    /// Whether no rank has any of something, of which this one has @p n.
    /// Collective.
    bool
    are_none(const std::size_t n) const;

    const Mesh<dim>    &mesh_;
    const WalkSettings  settings;
    const VelocityShape shape;
  };
} // namespace Thalweg

#endif
