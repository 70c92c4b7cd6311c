// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/courant_rate.h>
#include <thalweg/methods/flow_step_numbers.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
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
      const double edge =
        dealii::Utilities::MPI::min(mesh.graph().minimal_extent(),
                                    mesh.triangulation().get_communicator());
      return viscosity / (edge * edge);
    }
  } // namespace



  template <int dim>
  FlowStepNumbers<dim>::FlowStepNumbers(const NodeSpace<dim> &space,
                                        const Fluids         &fluids,
                                        const double          stable)
    : space(space)
    , stable_fourier_number(stable)
    , fourier_rate(find_fourier_rate(fluids, space.mesh()))
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
    return {courant, fourier};
  }



  THALWEG_INSTANTIATE(FlowStepNumbers)
} // namespace Thalweg
