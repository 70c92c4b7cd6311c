// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_interface_volume_correction_h
#define thalweg_interface_volume_correction_h

#include <thalweg/interface/fluid_bodies.h>

#include <array>
#include <functional>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Moves the interface so that each connected body of fluid 0, and
   * each pocket of fluid 1 that has no way out of the domain, has the volume
   * that the particles in and beside it carry.
   *
   * All nodes around the interface of one body are shifted by the same
   * amount, so that a plane remains a plane, and by no more than the given
   * bound: what is lost farther away than that, the level set is not
   * to invent. The rest stays on the particles: the debt. What particles carry
   * that no body is near (spray) belongs to the nearest one.
   */
  template <int dim>
  class VolumeCorrection
  {
  public:
    /// What particles carry in each owned cell of both fluids, m^dim.
    using Carried = std::vector<std::array<double, 2>>;

    VolumeCorrection(const NodeSpace<dim>     &space,
                     const BoundaryNodes<dim> &boundary);

    /**
     * @brief Shifts @p phi. Collective.
     * @param phi distance to the interface, ghosted; so it is left
     * @param carried what particles carry
     * @param largest_shift in units of @p phi
     */
    void
    apply(Vector &phi, const Carried &carried, const double largest_shift);

    /// What particles carried of each fluid when it was last applied, that
    /// the mesh does not show, m^dim; negative if it shows too much.
    const std::array<double, 2> &
    debt() const
    {
      return debts;
    }

    /// The shift with the largest absolute value.
    double
    shift() const
    {
      return largest;
    }

    /// The shifts at the nodes, ghosted; of no meaning if shift() is zero.
    const Vector &
    shifts_at_nodes() const
    {
      return field;
    }

    /// The number of bodies of each fluid.
    const std::array<unsigned int, 2> &
    n_bodies() const
    {
      return counts;
    }

  private:
    /// A body whose volume is held.
    struct Goal
    {
      int    body;
      double target; ///< m^dim
      /// Where the volume is too large and too small, and by how much.
      double above = 0, f_above = 0, below = 0, f_below = 0;
      double shift          = 0;
      bool   last_was_above = false;
      bool   is_done        = false;
    };

    /// The bodies of fluid 0 that are nearest to the given owned cells,
    /// counted in cells. Collective.
    std::vector<int>
    nearest_bodies(const FluidBodies<dim>          &bodies,
                   const std::vector<unsigned int> &cells) const;

    void
    find_targets(const FluidBodies<dim> &bodies, const Carried &carried);

    /// Which bodies of fluid 1 have no way out.
    void
    mark_pockets(const FluidBodies<dim>    &bodies,
                 const std::vector<double> &volumes);

    /// The pockets, or the bodies of fluid 0.
    std::vector<Goal>
    choose(const FluidBodies<dim> &bodies, const bool pockets) const;

    /// Which body each owned node is shifted for.
    void
    assign_nodes(const FluidBodies<dim> &bodies);

    /// Finds the cells whose volumes shifts can change, and what the others
    /// have.
    void
    find_active_cells(const FluidBodies<dim> &bodies,
                      const Vector           &phi,
                      const double            largest_shift);

    /// Finds the shifts of @p goals by regula falsi, all at once.
    void
    reach(std::vector<Goal>      &goals,
          const FluidBodies<dim> &bodies,
          const Vector           &phi,
          const double            largest_shift);

    /// The volumes of all bodies with the present shifts.
    std::vector<double>
    volumes(const FluidBodies<dim> &bodies, const Vector &phi);

    const NodeSpace<dim>       &space;
    const BoundaryNodes<dim>   &boundary;
    double                      tolerance = 0; ///< m^dim
    std::vector<double>         targets;       ///< of all bodies, with spray
    std::vector<bool>           is_pocket;
    std::vector<int>            body_of_node;
    std::vector<double>         shifts; ///< of all bodies
    Vector                      field;  ///< of the shifts at the nodes
    std::vector<unsigned int>   active_cells;
    std::vector<double>         passive_volumes;
    std::array<double, 2>       debts{};
    std::array<unsigned int, 2> counts{};
    double                      largest = 0;
  };
} // namespace Thalweg

#endif
