// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/courant_rate.h>
#include <thalweg/methods/flow_step_numbers.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Curvature's filter leaves of the stiffness k^3 of a capillary wave with
    /// k h = theta no more than theta 4 sin^2(theta / 2) (3 S^2 - 2 S^3) / h^3,
    /// S = cos^2(theta / 2): at most 1.58 in place of pi^3. The leapfrog scheme
    /// is stable up to twice one over the frequency, 5.6 in this number.
    constexpr double stable_capillary_number = 4.;



    template <int dim>
    double
    shortest_edge(const Mesh<dim> &mesh)
    {
      return dealii::Utilities::MPI::min(
        mesh.graph().minimal_extent(), mesh.triangulation().get_communicator());
    }



    /// The largest kinematic viscosity over the square of the shortest cell
    /// edge.
    template <int dim>
    double
    find_fourier_rate(const Fluids &fluids, const Mesh<dim> &mesh)
    {
      double viscosity = 0.;
      for (unsigned int f = 0; f < fluids.size(); ++f)
        viscosity =
          std::max(viscosity, fluids[f].viscosity / fluids[f].density);
      const double edge = shortest_edge(mesh);
      return viscosity / (edge * edge);
    }



    template <int dim>
    double
    find_capillary_rate(const Fluids    &fluids,
                        const Mesh<dim> &mesh,
                        const double     surface_tension)
    {
      if (surface_tension == 0.)
        return 0.;
      return std::sqrt(4. * dealii::numbers::PI * surface_tension /
                       ((fluids[0].density + fluids[1].density) *
                        std::pow(shortest_edge(mesh), 3)));
    }
  } // namespace



  template <int dim>
  FlowStepNumbers<dim>::FlowStepNumbers(const NodeSpace<dim> &space,
                                        const Fluids         &fluids,
                                        const double          stable,
                                        const double          surface_tension)
    : space(space)
    , stable_fourier_number(stable)
    , fourier_rate(find_fourier_rate(fluids, space.mesh()))
    , capillary_rate(find_capillary_rate(fluids, space.mesh(), surface_tension))
  {}



  template <int dim>
  StepNumbers
  FlowStepNumbers<dim>::of(const Vector &velocity) const
  {
    StepNumber courant, fourier;
    courant.name   = StepNumber::courant;
    courant.rate   = courant_rate(space, velocity);
    fourier.name   = StepNumber::fourier;
    fourier.rate   = fourier_rate;
    fourier.stable = stable_fourier_number;
    fourier.where  = "with explicit viscosity";
    fourier.cause  = "the cells are too small for this viscosity where it is "
                     "explicit";
    if (capillary_rate == 0.)
      return {courant, fourier};
    StepNumber capillary;
    capillary.name   = "capillary step number";
    capillary.rate   = capillary_rate;
    capillary.stable = stable_capillary_number;
    capillary.where  = "with surface tension";
    capillary.cause  = "the cells are too small for this surface tension";
    return {courant, fourier, capillary};
  }



  THALWEG_INSTANTIATE(FlowStepNumbers)
} // namespace Thalweg
