// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/gather.h>
#include <thalweg/interface/interface_force.h>

#include <algorithm>
#include <numeric>

namespace Thalweg
{
  /**
   * @brief Surface tension as a force in a layer around the interface,
   * @f$\sigma \kappa \nabla H@f$ (J. U. Brackbill, D. B. Kothe and C. Zemach,
   * J. Comput. Phys. 100, 1992), with @f$H@f$ between 1 in the first fluid
   * and 0 in the second at the nodes, linear in the distance from the
   * interface, and the curvature that a cell has: in each cell the gradient of
   * a Q1 function, as the pressure's is.
   */
  template <int dim>
  class ContinuumSurfaceForce : public InterfaceForce<dim>
  {
  public:
    void
    declare_parameters(const Section &section) override
    {
      section.add("Half width",
                  half_width,
                  "",
                  "How far the layer goes to both sides of the interface, in "
                  "shortest edges.",
                  dealii::Patterns::Double(0.));
    }

  private:
    using InterfaceForce<dim>::space;
    using InterfaceForce<dim>::phase;

    void
    find_forces() override;

    /// H, ghosted.
    void
    find_indicator(const double width);

    double half_width = 1.;
    Vector indicator;
  };



  template <int dim>
  void
  ContinuumSurfaceForce<dim>::find_indicator(const double width)
  {
    indicator.reinit(0);
    space->initialize_scalar(indicator);
    for (unsigned int n = 0; n < indicator.locally_owned_size(); ++n)
      {
        const double phi = phase->level_set().local_element(n);
        indicator.local_element(n) =
          width > 0. ? std::clamp(.5 * (1. - phi / width), 0., 1.) : phi < 0.;
      }
    space->interpolate(indicator, 1);
  }



  template <int dim>
  void
  ContinuumSurfaceForce<dim>::find_forces()
  {
    const double edge = phase->shortest_edge();
    find_indicator(half_width * edge);
    this->find_curvature();
    for (unsigned int c = 0; c < space->mesh().graph().n_owned_cells(); ++c)
      {
        auto pressures = gather<dim>(indicator, space->nodes(c));
        const auto [smallest, largest] =
          std::minmax_element(pressures.begin(), pressures.end());
        if (*smallest == *largest)
          continue;
        const auto   curvatures = gather<dim>(this->curvature, space->nodes(c));
        const double sum =
          std::accumulate(curvatures.begin(), curvatures.end(), 0.);
        const double factor =
          this->parameters->coefficient * sum / curvatures.size();
        for (double &pressure : pressures)
          pressure *= factor;
        this->add(c, {pressures, {}});
      }
  }



  THALWEG_INSTANTIATE(ContinuumSurfaceForce)
  THALWEG_REGISTER(InterfaceForce,
                   ContinuumSurfaceForce,
                   "continuum",
                   "a force in a layer around the interface (Brackbill et al. "
                   "1992), which the pressure balances exactly")
} // namespace Thalweg
