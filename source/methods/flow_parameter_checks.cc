// SPDX-License-Identifier: LGPL-2.1-or-later
// What is wrong with the parameters of a flow before a run.
#include <thalweg/core/errors.h>
#include <thalweg/fields/expression.h>
#include <thalweg/fields/flux_balance.h>
#include <thalweg/methods/flow_parameters.h>
#include <thalweg/methods/missing_fluid.h>

#include <tuple>

namespace Thalweg
{
  namespace
  {
    const std::string initial = "Initial conditions/";



    /// Lets a function refuse what it is at the vertices.
    template <int dim>
    void
    evaluate_at_vertices(const dealii::Function<dim> &function,
                         const Mesh<dim>             &mesh)
    {
      dealii::Vector<double> value(function.n_components);
      for (unsigned int c = 0; c < mesh.graph().n_owned_cells(); ++c)
        for (const auto &vertex : mesh.graph().cell(c).vertices)
          function.vector_value(vertex, value);
    }



    /// Lets the functions of boundaries refuse what they are at vertices there.
    template <int dim>
    void
    evaluate_at_boundaries(const BoundaryConditions<dim> &conditions,
                           const Mesh<dim>               &mesh)
    {
      dealii::Vector<double> value;
      const CellGraph<dim>  &graph = mesh.graph();
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        for (unsigned int f = 0; f < graph.n_faces; ++f)
          if (graph.at_boundary(c, f))
            {
              const auto  face = graph.iterator(c)->face(f);
              const auto &function =
                conditions.at(face->boundary_id()).function;
              if (function == nullptr)
                continue;
              value.reinit(function->n_components);
              for (const unsigned int v : face->vertex_indices())
                function->vector_value(face->vertex(v), value);
            }
    }
  } // namespace



  template <int dim>
  void
  FlowParameters<dim>::check(std::vector<std::string> &faults) const
  {
    collect_fault(faults, [this]() { fluids.check(); });
    collect_fault(faults, [this]() {
      AssertThrow(
        interface.enrichment != "discontinuous" || fluid_solver->takes_jumps(),
        dealii::ExcMessage("'Interface/Enrichment' is 'discontinuous', but the "
                           "pressure of 'Fluid solver/Model = " +
                           fluid_solver.model_name() +
                           "' has no jumps. Write 'gradient', or choose "
                           "'monolithic'."));
    });
    collect_fault(faults, [this]() {
      AssertThrow(heeds_viscosities || !computes_flow ||
                    !fluids.depend_on_shear(),
                  dealii::ExcMessage(
                    "'Fluids/.../Rheology/Model' says that a viscosity depends "
                    "on the shear rate, which 'single fluid pfem2' does not "
                    "heed. Choose the method 'pfem2', with 'Fluids/Number = 1' "
                    "for one fluid, or the model 'newton'."));
    });
    collect_fault(faults, [this]() {
      interface.surface_tension.template check<dim>(fluids.size());
      AssertThrow(computes_flow || !interface.surface_tension.acts(),
                  dealii::ExcMessage(
                    "'Interface/Surface tension/Coefficient' is not 0, but the "
                    "velocity is given. Write 0, or choose the method "
                    "'pfem2'."));
    });
    collect_fault(faults, [this]() {
      parse_expression<dim>(initial_velocity, dim, initial + "Velocity");
    });
    collect_fault(faults, [this]() {
      parse_expression<dim>(initial_level_set, 1, initial + "Level set");
    });
    collect_fault(faults, [this]() { population.check(); });
    collect_fault(faults, [this]() { check_distance_band(); });
  }



  template <int dim>
  void
  FlowParameters<dim>::check_on_mesh(const Mesh<dim>          &coarse,
                                     std::vector<std::string> &faults) const
  {
    collect_fault(faults, [&]() {
      BoundaryConditions<dim> conditions(boundary_conditions, coarse);
      for (const auto &[id, condition] : conditions.all())
        if (!condition.inflow_fluid.empty())
          fluids.index(condition.inflow_fluid);
      interface.surface_tension.angles(coarse);
      evaluate_at_boundaries(conditions, coarse);
      if (computes_flow)
        check_flux_balance(conditions, coarse, 0.);
    });
    for (const auto &[text, n_components, where] :
         {std::make_tuple(initial_velocity, dim, "Velocity"),
          std::make_tuple(initial_level_set, 1, "Level set")})
      collect_fault(faults,
                    [&, text = text, n = n_components, where = where]() {
                      if (is_expression<dim>(text, n))
                        evaluate_at_vertices(
                          *parse_expression<dim>(text, n, initial + where),
                          coarse);
                    });
  }



  template <int dim>
  std::string
  FlowParameters<dim>::missing_fluid(const Mesh<dim> &coarse,
                                     const double     n_cells) const
  {
    if (fluids.size() < 2 || !computes_flow)
      return "";
    return Thalweg::missing_fluid<dim>(
      coarse,
      fluids,
      *parse_expression<dim>(initial_level_set, 1, initial + "Level set"),
      particles_per_cell() * n_cells);
  }



  template <int dim>
  void
  FlowParameters<dim>::check_distance_band() const
  {
    AssertThrow(fluids.size() == 1 || particles_carry == "sign" ||
                  distance_band > 0.,
                dealii::ExcMessage(
                  "'Particles/Distance band' is 0, but the particles carry "
                  "the distance from the interface up to there, and would "
                  "carry 0 and no fluid. Make it 1 or more, or set "
                  "'Particles/Carry = sign'."));
  }



#define THALWEG_INSTANTIATE_CHECKS(dim)                                        \
  template void FlowParameters<dim>::check(std::vector<std::string> &) const;  \
  template void FlowParameters<dim>::check_on_mesh(const Mesh<dim> &,          \
                                                   std::vector<std::string> &) \
    const;                                                                     \
  template std::string FlowParameters<dim>::missing_fluid(const Mesh<dim> &,   \
                                                          const double) const;
  THALWEG_INSTANTIATE_CHECKS(2)
  THALWEG_INSTANTIATE_CHECKS(3)
#undef THALWEG_INSTANTIATE_CHECKS
} // namespace Thalweg
