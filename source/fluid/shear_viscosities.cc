// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/gather.h>
#include <thalweg/fluid/shear_viscosities.h>
#include <thalweg/materials/laminate.h>

#include <cmath>

namespace Thalweg
{
  template <int dim>
  ShearViscosities<dim>::ShearViscosities(const NodeSpace<dim>        &space,
                                          const BoundaryNodes<dim>    &boundary,
                                          const PhaseField<dim>       &phase,
                                          const FluidViscosities<dim> &given)
    : space(space)
    , phase(phase)
    , given(given)
    , is_active(phase.both_fluids().depend_on_shear())
    , at_wall(is_active ? boundary.cells_with_given_nodes()
                        : std::vector<bool>())
  {
    if (!is_active)
      return;
    own.attach(space, phase.both_fluids());
    space.initialize_velocity(last);
    last.update_ghost_values();
    slopes.resize(space.mesh().graph().n_owned_cells());
  }



  template <int dim>
  dealii::Tensor<2, dim>
  ShearViscosities<dim>::gradient(const Vector      &velocity,
                                  const unsigned int cell) const
  {
    const auto point = Q1::middle<dim>(space.mesh().graph().cell(cell));
    const auto u     = gather_velocity<dim>(velocity, space.nodes(cell));
    dealii::Tensor<2, dim> result;
    for (unsigned int v = 0; v < n_vertices; ++v)
      for (unsigned int d = 0; d < dim; ++d)
        result[d] += u[dim * v + d] * point.gradients[v];
    return result;
  }



  template <int dim>
  double
  ShearViscosities<dim>::shear_rate(const dealii::Tensor<2, dim> &twice_rate,
                                    const unsigned int            fluid,
                                    const unsigned int            cell) const
  {
    const int index = phase.cut_index(cell);
    if (index < 0 || at_wall[cell])
      return std::sqrt(.5) * twice_rate.norm();
    const CutCell<dim>         &cut  = phase.cut_cells()[index];
    const auto                 &last = viscosities();
    const std::array<double, 2> both{{last(0, cell), last(1, cell)}};
    const double                share =
      both[fluid] > 0.
                       ? harmonic_mean(cut.negative_fraction, both) / both[fluid]
                       : 1.;
    const auto traction = twice_rate * cut.normal;
    const auto shear    = traction - (traction * cut.normal) * cut.normal;
    return std::sqrt(.5) *
           (twice_rate - (1. - share) * (outer_product(shear, cut.normal) +
                                         outer_product(cut.normal, shear)))
             .norm();
  }



  template <int dim>
  void
  ShearViscosities<dim>::update(const Vector &velocity,
                                const bool    with_cut_cells)
  {
    if (!is_active)
      return;
    const Fluids                      &fluids = phase.both_fluids();
    std::array<std::vector<double>, 2> values;
    for (unsigned int f = 0; f < 2; ++f)
      {
        values[f].resize(slopes.size());
        for (unsigned int c = 0; c < slopes.size(); ++c)
          values[f][c] = viscosities()(f, c);
      }
    for (unsigned int c = 0; c < slopes.size(); ++c)
      {
        const auto grad       = gradient(velocity, c);
        const auto twice_rate = grad + transpose(grad);
        const bool is_cut     = phase.cut_index(c) >= 0;
        slopes[c]             = 0.;
        if (is_cut && !with_cut_cells)
          continue;
        for (unsigned int f = 0; f < fluids.size(); ++f)
          {
            values[f][c] = given(f, c);
            if (const Rheology *law = fluids.rheology(f))
              {
                const double rate  = shear_rate(twice_rate, f, c);
                const auto   value = law->value(rate, values[f][c]);
                values[f][c]       = value.viscosity;
                if (!is_cut && f == phase.fluid_number(c) && rate > 0.)
                  slopes[c] = value.slope / rate;
              }
          }
        if (fluids.size() == 1)
          values[1][c] = values[0][c];
      }
    for (unsigned int f = 0; f < 2; ++f)
      own.set(f, std::move(values[f]));
    last.zero_out_ghost_values();
    last.copy_locally_owned_data_from(velocity);
    space.interpolate(last, dim);
  }



  template <int dim>
  void
  ShearViscosities<dim>::subtract_tangent(const Vector &change,
                                          const double  factor,
                                          Vector       &force) const
  {
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < slopes.size(); ++c)
      if (slopes[c] != 0.)
        {
          // d mu = slope (2 eps : eps(change)), eps in the middle
          const auto   grad       = gradient(last, c);
          const auto   twice_rate = grad + transpose(grad);
          const double difference =
            factor * slopes[c] *
            scalar_product(twice_rate, gradient(change, c));
          const auto &nodes = space.nodes(c);
          const auto  u     = gather_velocity<dim>(last, nodes);
          for (unsigned int q = 0; q < gauss.n_points; ++q)
            {
              const auto             point = gauss.evaluate(graph.cell(c), q);
              dealii::Tensor<2, dim> at_point;
              for (unsigned int v = 0; v < n_vertices; ++v)
                for (unsigned int d = 0; d < dim; ++d)
                  at_point[d] += u[dim * v + d] * point.gradients[v];
              const auto sigma =
                (gauss.weight * point.determinant * difference) *
                (at_point + transpose(at_point));
              for (unsigned int v = 0; v < n_vertices; ++v)
                {
                  const auto f = sigma * point.gradients[v];
                  for (unsigned int d = 0; d < dim; ++d)
                    force.local_element(dim * nodes[v] + d) -= f[d];
                }
            }
        }
  }



  THALWEG_INSTANTIATE(ShearViscosities)
} // namespace Thalweg
