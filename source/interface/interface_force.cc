// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/expression.h>
#include <thalweg/interface/interface_force.h>

#include <deal.II/base/numbers.h>

namespace Thalweg
{
  template <int dim>
  void
  InterfaceForce<dim>::initialize(const NodeSpace<dim>           &space_,
                                  const BoundaryConditions<dim>  &conditions,
                                  const PhaseField<dim>          &phase_,
                                  const SurfaceTensionParameters &parameters_)
  {
    space      = &space_;
    phase      = &phase_;
    parameters = &parameters_;
    index.clear();
    list.clear();
    given.reset();
    if (!parameters->acts())
      return;
    if (!parameters->curvature.empty())
      given = parse_expression<dim>(parameters->curvature,
                                    1,
                                    "Interface/Surface tension/Curvature");
    auto angles = parameters->angles(space->mesh());
    for (const auto &[id, condition] : conditions.all())
      if (condition.kind == BoundaryKind::slip ||
          condition.kind == BoundaryKind::no_slip)
        angles.emplace(id, .5 * dealii::numbers::PI);
    finder = std::make_unique<Curvature<dim>>(*space, angles);
  }



  template <int dim>
  void
  InterfaceForce<dim>::update()
  {
    if (!parameters->acts())
      return;
    index.assign(space->mesh().graph().n_owned_cells(), -1);
    list.clear();
    find_forces();
  }



  template <int dim>
  void
  InterfaceForce<dim>::add(const unsigned int cell, const CellForce &force)
  {
    index[cell] = list.size();
    list.push_back(force);
  }



  template <int dim>
  void
  InterfaceForce<dim>::find_curvature()
  {
    if (given != nullptr)
      evaluate_given_curvature();
    else
      finder->find(phase->level_set(), curvature, is_known);
  }



  template <int dim>
  void
  InterfaceForce<dim>::evaluate_given_curvature()
  {
    space->initialize_scalar(curvature);
    space->initialize_scalar(is_known);
    for (unsigned int c = 0; c < space->mesh().graph().n_cells(); ++c)
      if (finder->is_near(c, phase->level_set()))
        for (const unsigned int node : space->nodes(c))
          if (node < curvature.locally_owned_size())
            {
              curvature.local_element(node) =
                given->value(space->position(node));
              is_known.local_element(node) = 1.;
            }
    space->interpolate(curvature, 1);
    space->interpolate(is_known, 1);
  }



  THALWEG_INSTANTIATE(InterfaceForce)
} // namespace Thalweg
