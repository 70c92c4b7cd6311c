// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/interface/phase_field.h>
#include <thalweg/mesh/round_off.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Thalweg
{
  void
  InterfaceParameters::declare(const Section &root)
  {
    const Section section = root.enter("Interface");
    section.add(
      "Hold volume",
      hold_volume,
      "",
      "Shift the level set so that each connected body of the first "
      "fluid, and each pocket of the second that has no way out, has "
      "the volume that its particles carry; by no more than a quarter "
      "of the shortest edge. The statistics show the volume before and "
      "after, and what is left on the particles.");
    section.add("Redistance",
                redistance,
                "",
                "Make the level set the signed distance to its zero contour "
                "near the interface each step. Without it the pressure's kink "
                "varies along the interface as the slope of the projected "
                "level set does, and drives the lighter fluid (only to show "
                "the difference).");
    section.add(
      "Enrichment",
      enrichment,
      "",
      "How the pressure is enriched in cells that the interface "
      "cuts: with a kink in its gradient; with jumps, as fluids whose "
      "friction differs have them (`discontinuous`, for "
      "'Fluid solver/Model = monolithic' and meshes without hanging "
      "nodes at the interface; for studies: exact while no side has "
      "less than a thousandth of a cell, and many iterations); or "
      "not at all (only to show the difference).",
      dealii::Patterns::Selection("discontinuous|gradient|none"));
    surface_tension.declare(section.enter("Surface tension"));
  }



  template <int dim>
  PhaseField<dim>::PhaseField(const NodeSpace<dim>      &space,
                              const Fluids              &fluids,
                              const InterfaceParameters &parameters)
    : space(space)
    , fluids(fluids)
    , parameters(parameters)
    , redistance(space)
  {
    space.initialize_scalar(phi);
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      domain_volume += graph.cell(c).measure;
    const MPI_Comm communicator =
      space.mesh().triangulation().get_communicator();
    domain_volume = dealii::Utilities::MPI::sum(domain_volume, communicator);
    shortest_edge_ =
      dealii::Utilities::MPI::min(graph.minimal_extent(), communicator);
  }



  template <int dim>
  double
  PhaseField<dim>::volume_with_shift(const CellField<dim, 1> &values,
                                     const double             c) const
  {
    const CellGraph<dim> &graph  = space.mesh().graph();
    double                volume = 0;
    for (unsigned int cell = 0; cell < graph.n_owned_cells(); ++cell)
      {
        auto shifted = values[cell];
        for (double &value : shifted)
          value += c;
        volume += negative_volume<dim>(graph.cell(cell), shifted);
      }
    return dealii::Utilities::MPI::sum(
      volume, space.mesh().triangulation().get_communicator());
  }



  template <int dim>
  double
  PhaseField<dim>::find_shift(const CellField<dim, 1> &values) const
  {
    const double tolerance = 1e-13 * domain_volume;
    double left = 0., f_left = volume_with_shift(values, 0.) - target_volume;
    if (std::abs(f_left) <= tolerance)
      return 0.;

    // The volume falls as the shift grows: bracket the root, then close in
    // on it by regula falsi with the Illinois modification.
    const double largest = phi.linfty_norm();
    double       right = 0., f_right = f_left;
    for (double step = std::copysign(.05 * largest, f_left);
         f_right * f_left > 0 && std::abs(step) < 4. * largest;
         step *= 2.)
      {
        left    = right;
        f_left  = f_right;
        right   = step;
        f_right = volume_with_shift(values, right) - target_volume;
      }
    if (f_right * f_left > 0)
      return 0.;
    double middle = right;
    for (unsigned int iteration = 0; iteration < 100; ++iteration)
      {
        middle         = (left * f_right - right * f_left) / (f_right - f_left);
        const double f = volume_with_shift(values, middle) - target_volume;
        if (std::abs(f) <= tolerance ||
            std::abs(right - left) <= 1e-15 * largest)
          break;
        if (f * f_right < 0)
          {
            left   = right;
            f_left = f_right;
          }
        else
          f_left *= .5;
        right   = middle;
        f_right = f;
      }
    return middle;
  }



  template <int dim>
  void
  PhaseField<dim>::find_distance(const Vector &level_set)
  {
    phi.copy_locally_owned_data_from(level_set);
    for (unsigned int n = 0; n < phi.locally_owned_size(); ++n)
      phi.local_element(n) = without_round_off(phi.local_element(n),
                                               shortest_edge_,
                                               space.position(n));
    space.interpolate(phi, 1);
    unshifted_volume = domain_volume;
    if (fluids.size() == 1)
      return;
    CellField<dim, 1> values;
    space.copy_to_cells(phi, values);
    unshifted_volume = volume_with_shift(values, 0.);
    if (parameters.redistance)
      redistance.apply(phi);
  }



  template <int dim>
  void
  PhaseField<dim>::hold_volume(const bool shifts)
  {
    last_shift     = 0;
    debts          = {};
    shifted_volume = domain_volume;
    if (fluids.size() == 2)
      {
        CellField<dim, 1> values;
        space.copy_to_cells(phi, values);
        if (shifts && parameters.hold_volume)
          correct(values);
        shifted_volume = volume_with_shift(values, 0.);
      }
    build_cells();
  }



  template <int dim>
  void
  PhaseField<dim>::rebuild(const Vector &level_set, const bool shifts)
  {
    find_distance(level_set);
    hold_volume(shifts);
  }



  template <int dim>
  void
  PhaseField<dim>::carry(
    std::function<typename VolumeCorrection<dim>::Carried()> volumes,
    const BoundaryNodes<dim>                                &boundary)
  {
    carried    = std::move(volumes);
    correction = std::make_unique<VolumeCorrection<dim>>(space, boundary);
  }



  template <int dim>
  void
  PhaseField<dim>::correct(CellField<dim, 1> &values)
  {
    if (correction)
      shift_bodies();
    else
      {
        last_shift = find_shift(values);
        if (last_shift == 0.)
          return;
        phi.zero_out_ghost_values();
        phi.add(last_shift);
        space.interpolate(phi, 1);
      }
    space.copy_to_cells(phi, values);
  }



  template <int dim>
  void
  PhaseField<dim>::shift_bodies()
  {
    const double length =
      parameters.redistance ? shortest_edge_ : phi.linfty_norm();
    correction->apply(phi, carried(), .25 * length);
    last_shift = correction->shift();
    debts      = correction->debt();
  }



  template <int dim>
  void
  PhaseField<dim>::build_cells()
  {
    const CellGraph<dim> &graph = space.mesh().graph();
    cut_of_cell.assign(graph.n_owned_cells(), -1);
    fluid_of_cell.assign(graph.n_owned_cells(), 0);
    level_sets.clear();
    cuts.clear();
    if (fluids.size() == 1)
      return;

    Vector absolute;
    space.initialize_scalar(absolute);
    for (unsigned int i = 0; i < absolute.locally_owned_size(); ++i)
      absolute.local_element(i) = std::abs(phi.local_element(i));
    space.interpolate(absolute, 1);

    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        std::array<double, (1 << dim)> values, w;
        bool                           is_cut = false;
        double                         sum    = 0;
        for (unsigned int v = 0; v < values.size(); ++v)
          {
            values[v] = phi.local_element(space.nodes(c)[v]);
            w[v]      = absolute.local_element(space.nodes(c)[v]);
            sum += values[v];
            is_cut = is_cut || w[v] > std::abs(values[v]) * (1. + 1e-12);
          }
        const auto [smallest, largest] =
          std::minmax_element(values.begin(), values.end());
        is_cut           = is_cut || (*smallest < 0 && *largest > 0);
        fluid_of_cell[c] = sum < 0 ? 0 : 1;
        if (is_cut)
          {
            cut_of_cell[c] = level_sets.size();
            level_sets.push_back({c, values, w});
          }
      }
  }



  template <int dim>
  void
  PhaseField<dim>::refuse_hanging_nodes() const
  {
    for (const CutLevelSet &level_set : level_sets)
      for (const unsigned int node : space.nodes(level_set.cell))
        {
          const auto [first, end] = space.hanging_masters(node);
          if (first == end)
            continue;
          std::ostringstream message;
          message << "The interface passes a cell with a hanging node near ("
                  << space.position(node)
                  << "), where the pressure of 'Interface/Enrichment = "
                     "discontinuous' cannot jump. Refine the mesh evenly "
                     "around the interface, or write 'gradient'.";
          throw dealii::ExcMessage(message.str());
        }
  }



  template <int dim>
  void
  PhaseField<dim>::integrate_cuts() const
  {
    cuts.reserve(level_sets.size());
    const PressureEnrichment enrichment =
      parameters.enrichment == "none"       ? PressureEnrichment::none
      : parameters.enrichment == "gradient" ? PressureEnrichment::gradient
                                            : PressureEnrichment::discontinuous;
    if (enrichment == PressureEnrichment::discontinuous)
      refuse_hanging_nodes();
    for (const CutLevelSet &level_set : level_sets)
      cuts.push_back(
        integrate_cut_cell<dim>(level_set.cell,
                                space.mesh().graph().cell(level_set.cell),
                                level_set.values,
                                level_set.absolute,
                                shortest_edge_,
                                fluids,
                                enrichment));
  }



  THALWEG_INSTANTIATE(PhaseField)
} // namespace Thalweg
