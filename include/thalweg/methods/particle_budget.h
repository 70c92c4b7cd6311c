// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_particle_budget_h
#define thalweg_methods_particle_budget_h

#include <thalweg/methods/parts.h>

#include <array>
#include <string>

namespace Thalweg
{
  /**
   * @brief What the parts of a step do to the kinetic and the potential energy
   * of the particles, drops and bubbles among them, fluid by fluid: columns of
   * the statistics, J.
   *
   * A particle that carries the volume v has 1/2 rho v V^2 and -rho v g x,
   * counted from the lower corner of the mesh, with gravity as it is when the
   * step begins.
   *
   * Does nothing, not even sums, unless the run asks for energy budgets.
   */
  template <int dim>
  class ParticleBudget
  {
  public:
    /// @param parts must outlive the object
    explicit ParticleBudget(const Parts<dim> &parts);

    /// Begins the step that starts at @p time. Collective.
    void
    begin(const double time);

    /// @p part has moved or changed particles since the last call; it may
    /// come several times a step. Collective.
    void
    record(const std::string &part);

    /// Says what there is at the end of the step.
    void
    end();

  private:
    /// Kinetic and potential energy of the first fluid, and of the second, J.
    using Energies = std::array<double, 4>;

    /// Calls @p action with the name of the column that says what @p part does
    /// to each of the energies, and the number of that.
    template <typename Action>
    void
    for_each_column(const std::string &part, const Action &action) const;

    void
    add(const Population<dim> &population, Energies &energies) const;

    Energies
    sum() const;

    const Parts<dim>      &parts;
    dealii::Tensor<1, dim> gravity;
    Energies               last{};
  };
} // namespace Thalweg

#endif
