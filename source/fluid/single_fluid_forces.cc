// SPDX-License-Identifier: LGPL-2.1-or-later
// What accelerates a SingleFluidFlow from outside.
#include <thalweg/fields/interpolation.h>
#include <thalweg/fields/owned_values.h>
#include <thalweg/fluid/single_fluid_flow.h>

namespace Thalweg
{
  template <int dim>
  void
  SingleFluidFlow<dim>::find_body_force()
  {
    for (unsigned int n = 0; n < velocity_space->n_owned_nodes(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
        body_force.local_element(dim * n + d) =
          forces.uniform_acceleration()[d];
    if (forces.has_density() || forces.has_field())
      for_each_owned_node<dim>(
        *velocity_space,
        [&](const unsigned int node, const dealii::Point<dim> &position) {
          dealii::Tensor<1, dim> a;
          if (forces.has_density())
            a += forces.density(position) / fluid.density;
          if (forces.has_field())
            a += forces.field(position);
          for (unsigned int d = 0; d < dim; ++d)
            body_force.local_element(dim * node + d) += a[d];
        });
    if (terms.has_acceleration())
      terms.add_acceleration(*velocity_space, body_force);
    velocity_space->interpolate(body_force, dim);
  }



  template <int dim>
  void
  SingleFluidFlow<dim>::add_coriolis(const Vector &velocity)
  {
    copy_owned(with_coriolis, body_force);
    if (forces.is_rotating())
      for (unsigned int n = 0; n < velocity_space->n_owned_nodes(); ++n)
        {
          dealii::Tensor<1, dim> v;
          for (unsigned int d = 0; d < dim; ++d)
            v[d] = velocity.local_element(dim * n + d);
          const dealii::Tensor<1, dim> a = -2. * (forces.spin() * v);
          for (unsigned int d = 0; d < dim; ++d)
            with_coriolis.local_element(dim * n + d) += a[d];
        }
    velocity_space->interpolate(with_coriolis, dim);
  }



  template void
  SingleFluidFlow<2>::find_body_force();
  template void
  SingleFluidFlow<3>::find_body_force();
  template void
  SingleFluidFlow<2>::add_coriolis(const Vector &);
  template void
  SingleFluidFlow<3>::add_coriolis(const Vector &);
} // namespace Thalweg
