// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/gather.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/interface/interface_force.h>

#include <algorithm>

namespace Thalweg
{
  /**
   * @brief Surface tension as the pressure's jump, taken out of what the flow
   * solves for.
   *
   * With @f$a@f$, which is @f$\pm\sigma\kappa@f$ at the interface and fades
   * within the denser fluid, the pressure is @f$p + a@f$ there and @f$p@f$ in
   * the other one, and @f$p@f$ is continuous with a kink, as its enrichment
   * is. What acts is @f$-\nabla a@f$ in the denser fluid: nothing on the other
   * one, which would answer to the errors of the curvature with accelerations
   * larger by the ratio of densities, nor across the interface, along whose
   * normals @f$a@f$ is constant. Where it fades it is a Q1 function, which
   * @f$p@f$ balances exactly.
   */
  template <int dim>
  class SharpSurfaceForce : public InterfaceForce<dim>
  {
  public:
    void
    declare_parameters(const Section &) override
    {}

    bool
    hides_pressure() const override
    {
      return this->parameters->acts();
    }

    void
    add_hidden_pressure(Vector &pressure) const override;

  private:
    using InterfaceForce<dim>::space;
    using InterfaceForce<dim>::phase;

    void
    find_forces() override;

    /// Finds a at the nodes.
    void
    find_jump();

    /// The sign of the level set in the denser fluid.
    double
    denser_side() const
    {
      return Fluids::sign(phase->both_fluids().denser());
    }

    Vector jump; ///< a, ghosted
  };



  template <int dim>
  void
  SharpSurfaceForce<dim>::find_jump()
  {
    constexpr unsigned int n_layers = 3;
    this->find_curvature();
    space->initialize_scalar(jump);
    jump.equ(-denser_side() * this->parameters->coefficient, this->curvature);
    space->interpolate(jump, 1);
    // a layer of nodes after the other, to 3/4, 2/4 and 1/4 of it
    for (double k = n_layers; k > 0.; --k)
      this->finder->spread(k / (k + 1.), this->is_known, jump);
  }



  template <int dim>
  void
  SharpSurfaceForce<dim>::find_forces()
  {
    find_jump();
    for (unsigned int c = 0; c < space->mesh().graph().n_owned_cells(); ++c)
      {
        const auto a = gather<dim>(jump, space->nodes(c));
        const auto [smallest, largest] =
          std::minmax_element(a.begin(), a.end());
        if (*smallest == *largest)
          continue;
        typename InterfaceForce<dim>::CellForce force;
        if (phase->cut_index(c) >= 0)
          {
            const auto middle = Q1::middle<dim>(space->mesh().graph().cell(c));
            for (unsigned int v = 0; v < a.size(); ++v)
              force.density -= a[v] * middle.gradients[v];
          }
        else if (phase->fluid_number(c) == phase->both_fluids().denser())
          for (unsigned int v = 0; v < a.size(); ++v)
            force.pressures[v] = -a[v];
        else
          continue;
        this->add(c, force);
      }
  }



  template <int dim>
  void
  SharpSurfaceForce<dim>::add_hidden_pressure(Vector &pressure) const
  {
    for (unsigned int n = 0; n < pressure.locally_owned_size(); ++n)
      if (denser_side() * phase->level_set().local_element(n) > 0.)
        pressure.local_element(n) += jump.local_element(n);
  }



  THALWEG_INSTANTIATE(SharpSurfaceForce)
  THALWEG_REGISTER(InterfaceForce,
                   SharpSurfaceForce,
                   "sharp",
                   "the jump of the pressure, known from the curvature, is "
                   "taken out of what the flow solves for")
} // namespace Thalweg
