// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_kinetic_budget_h
#define thalweg_fluid_kinetic_budget_h

#include <thalweg/core/context.h>
#include <thalweg/fluid/nodal_mass.h>

#include <string>

namespace Thalweg
{
  /**
   * @brief What the parts of a solve do to the kinetic energy of the mesh,
   * 1/2 sum_i m_i V_i^2 with the lumped masses of both fluids: one column of
   * the statistics a part, J. They add up to "kinetic energy [J]".
   *
   * Does nothing, not even sums, unless the run asks for energy budgets.
   */
  template <int dim>
  class KineticBudget
  {
  public:
    /// Both must outlive the object.
    KineticBudget(Context &context, const NodalMass<dim> &mass);

    /// Begins with the velocity that the particles have given to the mesh.
    /// Collective.
    void
    begin(const Vector &velocity);

    /// @p part has changed the velocity to @p velocity. Collective.
    void
    record(const std::string &part, const Vector &velocity);

  private:
    /// Of both fluids and all ranks, J.
    double
    energy(const Vector &velocity) const;

    Context              &context;
    const NodalMass<dim> &mass;
    double                last = 0.;
  };
} // namespace Thalweg

#endif
