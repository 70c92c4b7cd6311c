// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_streamline_walk_h
#define thalweg_particles_streamline_walk_h

#include <thalweg/mesh/cell_graph.h>
#include <thalweg/particles/cell_maps.h>
#include <thalweg/particles/steady_field.h>
#include <thalweg/particles/walker.h>

#include <array>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Follows the streamlines, or the paths, of a velocity that is given
   * cell by cell, from cell to cell without any search (Eq. 64).
   *
   * A walker knows its cell and its reference coordinates. It is moved by
   * substeps in which no point of its cell would move by more than a given
   * part of the cell; when a reference coordinate leaves [0,1], it goes on in
   * the cell behind that face. Stages of the integrator that fall outside the
   * cell are evaluated with the cell's own polynomial. An acceleration is
   * integrated by the same stages.
   *
   * A constructed object is constant and holds a reference to the graph,
   * which has to outlive it.
   *
   * @tparam Field what moves the walkers: SteadyField, a PathField, or
   *   DispersedField. It has
   *   - `WalkerType`, Walker or one derived from it;
   *   - `accelerates`, whether there is an acceleration;
   *   - `disperses`, whether walkers are drops or bubbles;
   *   - `has_bubbles`, whether `add_bubbles(walker, reference, stretch, rate)`
   *     adds to the rate of the reference coordinates;
   *   - `longest_substep(walker)`, in s;
   *   - `velocity(walker, reference, time_left)`: on axis-parallel cells that
   *     of the reference coordinates in 1/s, else that of the position in m/s;
   *   - `acceleration(walker, reference, time_left)`, if any, in m/s^2;
   *   - if they are, `way(walker, time)` of a drop in m,
   *     `hit(walker, normal)` for walls, and `lands(walker)`,
   *     whether its way ends where it is.
   */
  template <int dim, typename Field = SteadyField<dim>>
  class StreamlineWalk
  {
  public:
    using WalkerType = typename Field::WalkerType;

    /**
     * @param graph the cells
     * @param field on all owned and ghost cells
     * @param settings see there
     */
    StreamlineWalk(const CellGraph<dim> &graph,
                   Field                 field,
                   const WalkSettings   &settings);

    /**
     * @brief Lets a walker walk in locally owned cells until its fate is
     * decided.
     *
     * If its reference coordinates are outside its cell, it goes first to the
     * cell where they belong.
     */
    void
    walk(WalkerType &walker, WalkEffort &effort) const;

    /// The place of a walker in space, in m.
    dealii::Point<dim>
    position(const Walker<dim> &walker) const;

    const CellGraph<dim> &
    graph() const
    {
      return cell_graph;
    }

    const Field &
    field() const
    {
      return field_;
    }

  private:
    using Coordinates = std::array<double, dim>;

    /// Where a piece of way leaves its cell.
    struct Exit
    {
      static constexpr unsigned int none = 2 * dim;
      unsigned int                  face;
      double                        fraction;
    };

    template <bool axis_parallel>
    Coordinates
    rate(const WalkerType  &walker,
         const Coordinates &reference,
         const double       time_left) const;

    template <StreamlineScheme scheme, bool axis_parallel>
    Coordinates
    substep(const WalkerType &walker,
            const double      time,
            Coordinates      &gain) const;

    template <StreamlineScheme scheme>
    Coordinates
    careful_substep(const WalkerType &walker,
                    double           &time,
                    Coordinates      &gain) const;

    /// The end of a drop's substep in a general cell, exactly.
    Coordinates
    flight(const WalkerType &walker, double &time, Coordinates &gain) const;

    template <StreamlineScheme scheme>
    void
    walk_with(WalkerType &walker, WalkEffort &effort) const;

    void
    cross(WalkerType &walker, WalkEffort &effort) const;

    /// Lets a walker that is beyond a wall slide along it.
    void
    meet_wall(WalkerType &walker, const unsigned int face) const;

    /// Normal to the face of the walker's cell that bounds a reference
    /// coordinate, of any length.
    Coordinates
    normal(const WalkerType &walker, const unsigned int direction) const;

    static Exit
    find_exit(const Coordinates &begin, Coordinates &end);

    bool
    enter(const typename CellGraph<dim>::Face &face,
          const double                         fraction,
          WalkerType                          &walker) const;

    /// What counts of the last piece is only the given part of it.
    static void
    shorten_piece(WalkerType &walker, const double factor);

    /// Gives back what the last piece took.
    static void
    undo_piece(WalkerType &walker);

    bool
    is_open(const dealii::types::boundary_id boundary) const
    {
      return boundary < open.size() && open[boundary];
    }

    const CellGraph<dim>  &cell_graph;
    const CellMaps<dim>    maps;
    const Field            field_;
    const StreamlineScheme scheme;
    std::vector<bool>      open;
  };
} // namespace Thalweg

#endif
