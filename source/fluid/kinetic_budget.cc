// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fluid/kinetic_budget.h>

namespace Thalweg
{
  template <int dim>
  KineticBudget<dim>::KineticBudget(Context              &context,
                                    const NodalMass<dim> &mass)
    : context(context)
    , mass(mass)
  {}



  template <int dim>
  void
  KineticBudget<dim>::begin(const Vector &velocity)
  {
    if (!context.has_energy_budget)
      return;
    last = energy(velocity);
    context.statistics.set("budget: projected [J]", last);
  }



  template <int dim>
  void
  KineticBudget<dim>::record(const std::string &part, const Vector &velocity)
  {
    if (!context.has_energy_budget)
      return;
    const double now = energy(velocity);
    context.statistics.set("budget: " + part + " [J]", now - last);
    last = now;
  }



  template <int dim>
  double
  KineticBudget<dim>::energy(const Vector &velocity) const
  {
    const Vector &masses = mass.lumped();
    double        sum    = 0.;
    for (unsigned int n = 0; n < masses.locally_owned_size(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
        sum += .5 * masses.local_element(n) *
               velocity.local_element(dim * n + d) *
               velocity.local_element(dim * n + d);
    return dealii::Utilities::MPI::sum(sum, context.communicator);
  }



  THALWEG_INSTANTIATE(KineticBudget)
} // namespace Thalweg
