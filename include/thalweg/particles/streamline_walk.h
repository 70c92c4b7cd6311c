#ifndef thalweg_particles_streamline_walk_h
#define thalweg_particles_streamline_walk_h

#include <thalweg/mesh/cell_field.h>
#include <thalweg/mesh/cell_graph.h>

#include <array>
#include <cstdint>
#include <map>
#include <vector>

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
    /// The boundary where the walker left.
    dealii::types::boundary_id boundary;
    Fate                       fate;

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
      walker.fate        = Fate::under_way;
      return walker;
    }
  };

  /// Counters of the work that was done.
  struct WalkEffort
  {
    std::uint64_t n_substeps      = 0;
    std::uint64_t n_cells_crossed = 0;
  };

  /**
   * @brief Follows streamlines of a velocity that is given cell by cell,
   * from cell to cell without any search (Eq. 64).
   *
   * A walker knows its cell and its reference coordinates. It is moved by
   * substeps in which no point of its cell would move by more than a given
   * part of the cell; when a reference coordinate leaves [0,1], it goes on in
   * the cell behind that face. Stages of the integrator that fall outside the
   * cell are evaluated with the cell's own polynomial.
   *
   * A constructed object is constant and holds references to its arguments,
   * which have to outlive it.
   */
  template <int dim>
  class StreamlineWalk
  {
  public:
    static constexpr unsigned int n_vertices = 1 << dim;

    /// What all walks of a run have in common.
    struct Settings
    {
      StreamlineScheme scheme = StreamlineScheme::rk2;
      /// The greatest way of a substep in parts of the cell.
      double substep = 0.5;
      /// Boundaries that are not listed are walls.
      std::map<dealii::types::boundary_id, WallKind> walls;
    };

    /**
     * @param graph the cells
     * @param velocity nodal values of all owned and ghost cells, in m/s
     * @param settings see there
     * @param direction 1 to go with the velocity, -1 against it
     */
    StreamlineWalk(const CellGraph<dim>    &graph,
                   const CellVelocity<dim> &velocity,
                   const Settings          &settings,
                   const double             direction);

    /**
     * @brief Lets a walker walk in locally owned cells until its fate is
     * decided.
     *
     * If its reference coordinates are outside its cell, it goes first to the
     * cell where they belong.
     */
    void
    walk(Walker<dim> &walker, WalkEffort &effort) const;

    /// The place of a walker in space, in m.
    dealii::Point<dim>
    position(const Walker<dim> &walker) const;

    const CellGraph<dim> &
    graph() const
    {
      return cell_graph;
    }

  private:
    using Coordinates = std::array<double, dim>;
    /// Coefficients of 1, x, y, xy, z, ... for each component.
    using Polynomial = std::array<double, dim * n_vertices>;

    /// The velocity in a cell.
    struct Flow
    {
      /// Axis-parallel cells: that of the reference coordinates in 1/s; else
      /// that of the position in m/s.
      Polynomial velocity;
      /// The longest substep in s.
      double longest_substep;
    };

    /// Where a piece of way leaves its cell.
    struct Exit
    {
      static constexpr unsigned int none = 2 * dim;
      unsigned int                  face;
      double                        fraction;
    };

    Flow
    prepare(const unsigned int cell, const Polynomial &nodal_velocity) const;

    template <bool axis_parallel>
    Coordinates
    rate(const unsigned int cell, const Coordinates &reference) const;

    template <StreamlineScheme scheme, bool axis_parallel>
    Coordinates
    substep(const unsigned int cell,
            const Coordinates &begin,
            const double       time) const;

    template <StreamlineScheme scheme>
    Coordinates
    careful_substep(const unsigned int cell,
                    const Coordinates &begin,
                    double            &time) const;

    template <StreamlineScheme scheme>
    void
    walk_with(Walker<dim> &walker, WalkEffort &effort) const;

    void
    cross(Walker<dim> &walker, WalkEffort &effort) const;

    static Exit
    find_exit(const Coordinates &begin, Coordinates &end);

    bool
    enter(const typename CellGraph<dim>::Face &face,
          const double                         fraction,
          Walker<dim>                         &walker) const;

    Coordinates
    to_space(const unsigned int cell, const Coordinates &reference) const;

    bool
    to_reference(const unsigned int cell,
                 const Coordinates &position,
                 Coordinates       &reference) const;

    bool
    find_reference(const unsigned int cell,
                   const Coordinates &position,
                   Coordinates       &reference) const;

    unsigned int
    nearest_child(const std::array<int, CellGraph<dim>::n_face_children> &,
                  const Coordinates &position) const;

    bool
    is_open(const dealii::types::boundary_id boundary) const
    {
      return boundary < open.size() && open[boundary];
    }

    const CellGraph<dim>   &cell_graph;
    const StreamlineScheme  scheme;
    const double            greatest_way;
    const double            direction;
    std::vector<bool>       open;
    std::vector<Flow>       flow;
    std::vector<Polynomial> shape;
  };
} // namespace Thalweg

#endif
