// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/lagrange_shape.h>
#include <thalweg/transfer/velocity_projection.h>

namespace Thalweg
{
  namespace
  {
    /// V_p = keep V_p + N(x_p) (a A + b B) for all particles.
    template <int dim, unsigned int degree>
    void
    update(Population<dim>          &population,
           const LagrangeSpace<dim> &space,
           const double              keep,
           const double              a,
           const Vector             &A,
           const double              b,
           const Vector             &B)
    {
      constexpr unsigned int n     = LagrangeShape::n_nodes(dim, degree);
      const auto            &graph = space.mesh().graph();
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        {
          const unsigned int *const   nodes = space.nodes(c);
          std::array<double, dim * n> values;
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int d = 0; d < dim; ++d)
              values[dim * i + d] = a * A.local_element(dim * nodes[i] + d) +
                                    b * B.local_element(dim * nodes[i] + d);
          for (auto &particle : population.in_cell(c))
            {
              const auto shape =
                LagrangeShape::values<dim, degree>(particle.reference());
              double change[dim] = {};
              for (unsigned int i = 0; i < n; ++i)
                for (unsigned int d = 0; d < dim; ++d)
                  change[d] += shape[i] * values[dim * i + d];
              for (unsigned int d = 0; d < dim; ++d)
                {
                  double &velocity =
                    particle.properties()[Population<dim>::velocity_offset + d];
                  velocity = keep * velocity + change[d];
                }
            }
        }
    }



    template <int dim>
    void
    update(Population<dim>          &population,
           const LagrangeSpace<dim> &space,
           const double              keep,
           const double              a,
           const Vector             &A,
           const double              b,
           const Vector             &B)
    {
      if (space.degree() == 1)
        update<dim, 1>(population, space, keep, a, A, b, B);
      else
        update<dim, 2>(population, space, keep, a, A, b, B);
    }
  } // namespace



  template <int dim>
  void
  add_increment(Population<dim>          &population,
                const LagrangeSpace<dim> &space,
                const Vector             &new_velocity,
                const Vector             &velocity_star,
                const double              blend)
  {
    update(population,
           space,
           1. - blend,
           1.,
           new_velocity,
           blend - 1.,
           velocity_star);
  }



  template <int dim>
  void
  add_field(Population<dim>          &population,
            const LagrangeSpace<dim> &space,
            const Vector             &field,
            const double              factor)
  {
    update(population, space, 1., factor, field, 0., field);
  }



#define INSTANTIATE(dim)                                       \
  template void add_increment<dim>(Population<dim> &,          \
                                   const LagrangeSpace<dim> &, \
                                   const Vector &,             \
                                   const Vector &,             \
                                   const double);              \
  template void add_field<dim>(Population<dim> &,              \
                               const LagrangeSpace<dim> &,     \
                               const Vector &,                 \
                               const double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Thalweg
