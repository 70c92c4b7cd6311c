// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_interface_phase_field_h
#define thalweg_interface_phase_field_h

#include <thalweg/core/section.h>
#include <thalweg/fields/boundary_nodes.h>
#include <thalweg/fields/node_space.h>
#include <thalweg/interface/cut_cell.h>
#include <thalweg/interface/redistance.h>
#include <thalweg/interface/surface_tension.h>
#include <thalweg/interface/volume_correction.h>
#include <thalweg/materials/fluids.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace Thalweg
{
  /// The parameters of the section "Interface".
  struct InterfaceParameters
  {
    /// Declares the section below @p root.
    void
    declare(const Section &root);

    bool        hold_volume = true;
    bool        redistance  = true;
    std::string enrichment  = "gradient";

    SurfaceTensionParameters surface_tension;
  };

  /**
   * @brief Where the two fluids are: the level set on the mesh, the cut
   * cells with their integrals, and the volumes.
   */
  template <int dim>
  class PhaseField
  {
  public:
    PhaseField(const NodeSpace<dim>      &space,
               const Fluids              &fluids,
               const InterfaceParameters &parameters);

    /**
     * @brief Takes the projected level set, makes it a distance, shifts it so
     * that fluid 0 keeps its volume, and builds the cut cells.
     * @param level_set owned values; negative in fluid 0
     * @param shifts whether to shift; the parameter must allow it too
     */
    void
    rebuild(const Vector &level_set, const bool shifts = true);

    /// The first half of rebuild(): level_set() is the distance then, and not
    /// yet shifted.
    void
    find_distance(const Vector &level_set);

    /// The second half. @param shifts as for rebuild()
    void
    hold_volume(const bool shifts = true);

    /// The volume that fluid 0 is to have in all, m^dim, if nothing carries
    /// it.
    double target_volume = 0;

    /**
     * @brief From now on rebuild() gives each body of fluid the volume that
     * is carried there.
     * @param volumes returns what is carried in each owned cell of both
     *   fluids, m^dim
     * @param boundary must outlive this object
     */
    void
    carry(std::function<typename VolumeCorrection<dim>::Carried()> volumes,
          const BoundaryNodes<dim>                                &boundary);

    /// What is carried of both fluids, but not shown by the mesh, m^dim.
    const std::array<double, 2> &
    debt() const
    {
      return debts;
    }

    /// Ghosted level set after the shift.
    const Vector &
    level_set() const
    {
      return phi;
    }

    /// Between both fluids.
    const SurfaceTensionParameters &
    surface_tension() const
    {
      return parameters.surface_tension;
    }

    /// Whether that is the distance to the interface near it.
    bool
    is_distance() const
    {
      return fluids.size() == 2 && parameters.redistance;
    }

    /// The index of a cell's cut_cells() entry, or -1.
    int
    cut_index(const unsigned int cell) const
    {
      return cut_of_cell[cell];
    }

    /// The cut cells, and those beside cut hanging faces; integrated when
    /// they are first asked for.
    const std::vector<CutCell<dim>> &
    cut_cells() const
    {
      if (cuts.size() < level_sets.size())
        integrate_cuts();
      return cuts;
    }

    /// The fluid that fills the locally owned, uncut cell @p cell.
    const Fluid &
    fluid(const unsigned int cell) const
    {
      return fluids[fluid_of_cell[cell]];
    }

    /// Whether the pressure may jump at the interface.
    bool
    has_jumps() const
    {
      return fluids.size() == 2 && parameters.enrichment == "discontinuous";
    }

    /// What the phases are.
    const Fluids &
    both_fluids() const
    {
      return fluids;
    }

    /// The number of the fluid in an uncut cell.
    unsigned int
    fluid_number(const unsigned int cell) const
    {
      return fluid_of_cell[cell];
    }

    /// Volume of fluid 0 in the projected level set, before it was made a
    /// distance and shifted, m^dim.
    double
    volume_before_shift() const
    {
      return unshifted_volume;
    }

    /// Volume of fluid 0, m^dim.
    double
    volume() const
    {
      return shifted_volume;
    }

    /// Volume of the whole domain, m^dim.
    double
    total_volume() const
    {
      return domain_volume;
    }

    /// The last shift, in units of the level set; the largest one of those of
    /// all bodies.
    double
    shift() const
    {
      return last_shift;
    }

    /// Of the mesh, m.
    double
    shortest_edge() const
    {
      return shortest_edge_;
    }

    /// The last shifts at the nodes, ghosted; nullptr if nothing was shifted
    /// body by body.
    const Vector *
    shifts_at_nodes() const
    {
      return correction && last_shift != 0 ? &correction->shifts_at_nodes()
                                           : nullptr;
    }

  private:
    double
    volume_with_shift(const CellField<dim, 1> &values, const double c) const;

    double
    find_shift(const CellField<dim, 1> &values) const;

    /// Shifts the level set as a whole for target_volume, or body by body.
    void
    correct(CellField<dim, 1> &values);

    void
    shift_bodies();

    void
    build_cells();

    /// Refuses cut cells with hanging nodes. @throws dealii::ExcMessage
    void
    refuse_hanging_nodes() const;

    void
    integrate_cuts() const;

    /// The level set of a cell that is cut.
    struct CutLevelSet
    {
      unsigned int                   cell;
      std::array<double, (1 << dim)> values;
      std::array<double, (1 << dim)> absolute; ///< of the nodes it depends on
    };

    const NodeSpace<dim>                                    &space;
    const Fluids                                            &fluids;
    const InterfaceParameters                               &parameters;
    Redistance<dim>                                          redistance;
    Vector                                                   phi;
    std::vector<int>                                         cut_of_cell;
    std::vector<unsigned char>                               fluid_of_cell;
    std::vector<CutLevelSet>                                 level_sets;
    mutable std::vector<CutCell<dim>>                        cuts;
    std::function<typename VolumeCorrection<dim>::Carried()> carried;
    std::unique_ptr<VolumeCorrection<dim>>                   correction;
    std::array<double, 2>                                    debts{};
    double                                                   shortest_edge_ = 0;
    double                                                   domain_volume  = 0;
    double unshifted_volume                                                 = 0;
    double shifted_volume                                                   = 0;
    double last_shift                                                       = 0;
  };
} // namespace Thalweg

#endif
