// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fluid/nodal_melting.h>

#include <deal.II/base/mpi.h>

namespace Thalweg
{
  template <int dim>
  NodalMelting<dim>::NodalMelting(const NodeSpace<dim> &space,
                                  const Melting        &law)
    : space(space)
    , law(law)
  {
    space.initialize_scalar(lumped);
    space.initialize_scalar(latent);
  }



  template <int dim>
  void
  NodalMelting<dim>::update(const Vector &capacity)
  {
    latent.zero_out_ghost_values();
    for (unsigned int n = 0; n < space.n_owned_nodes(); ++n)
      latent.local_element(n) =
        space.is_dependent(n)
          ? 0.
          : lumped.local_element(n) / capacity.local_element(n);
    space.interpolate(latent, 1);
  }



  template <int dim>
  void
  NodalMelting<dim>::join(const Vector &value,
                          const Vector &molten,
                          Vector       &heat) const
  {
    heat.zero_out_ghost_values();
    for (unsigned int n = 0; n < space.n_owned_nodes(); ++n)
      heat.local_element(n) = value.local_element(n) +
                              latent.local_element(n) * molten.local_element(n);
    space.interpolate(heat, 1);
  }



  template <int dim>
  void
  NodalMelting<dim>::find(const Vector &heat,
                          double (Melting::*part)(const double) const,
                          Vector &result) const
  {
    result.zero_out_ghost_values();
    for (unsigned int n = 0; n < space.n_owned_nodes(); ++n)
      {
        const Melting here      = at(n);
        result.local_element(n) = (here.*part)(heat.local_element(n));
      }
    space.interpolate(result, 1);
  }



  template <int dim>
  double
  NodalMelting<dim>::molten_part(const Vector &molten) const
  {
    const MPI_Comm communicator =
      space.mesh().triangulation().get_communicator();
    double part = 0., all = 0.;
    for (unsigned int n = 0; n < space.n_owned_nodes(); ++n)
      {
        all += lumped.local_element(n);
        part += lumped.local_element(n) * molten.local_element(n);
      }
    part = dealii::Utilities::MPI::sum(part, communicator);
    all  = dealii::Utilities::MPI::sum(all, communicator);
    return all > 0. ? part / all : 0.;
  }



  THALWEG_INSTANTIATE(NodalMelting)
} // namespace Thalweg
