// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/particles/cell_maps.h>
#include <thalweg/particles/path_field.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Thalweg
{
  template <int dim, unsigned int degree>
  PathField<dim, degree>::PathField(const CellGraph<dim>  &graph,
                                    const PathFields<dim> &fields,
                                    const double           dt,
                                    const double           greatest_way,
                                    const double           direction)
    : direction(direction)
    , first_part(direction > 0 ? 1. : 0.)
    , part_per_time(dt > 0 ? -direction / dt : 0.)
  {
    AssertDimension(fields.degree, degree);
    for (const auto *values : {&fields.begin_velocity,
                               &fields.end_velocity,
                               &fields.begin_acceleration,
                               &fields.end_acceleration})
      {
        (void)values;
        AssertDimension(values->size(), graph.n_cells() * n_nodes * dim);
      }

    flow.resize(graph.n_cells());
    for (unsigned int i = 0; i < graph.n_cells(); ++i)
      {
        flow[i].velocity =
          nodal_values(fields.begin_velocity, fields.end_velocity, i);
        const double fastest = scale_velocity(graph.cell(i), flow[i].velocity);
        flow[i].longest_substep = fastest > 0
                                    ? greatest_way / fastest
                                    : std::numeric_limits<double>::max();
        to_polynomial(flow[i].velocity);
        flow[i].acceleration =
          nodal_values(fields.begin_acceleration, fields.end_acceleration, i);
        to_polynomial(flow[i].acceleration);
      }
  }


  template <int dim, unsigned int degree>
  typename PathField<dim, degree>::Polynomial
  PathField<dim, degree>::nodal_values(const std::vector<double> &begin,
                                       const std::vector<double> &end,
                                       const unsigned int         cell)
  {
    Polynomial        values;
    const std::size_t offset = static_cast<std::size_t>(cell) * n_nodes * dim;
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int c = 0; c < dim; ++c)
        {
          const std::size_t index = offset + i * dim + c;
          values[i][c]            = begin[index];
          values[i][dim + c]      = end[index] - begin[index];
        }
    return values;
  }


  /// Brings nodal values to what walkers need, and returns the fastest rate of
  /// a reference coordinate that occurs at a node in this step, in 1/s.
  template <int dim, unsigned int degree>
  double
  PathField<dim, degree>::scale_velocity(
    const typename CellGraph<dim>::Cell &geometry,
    Polynomial                          &velocity) const
  {
    typename CellMaps<dim>::Polynomial shape{};
    if (!geometry.axis_parallel)
      shape = CellMaps<dim>::shape_of(geometry);

    double fastest = 0;
    for (unsigned int i = 0; i < n_nodes; ++i)
      {
        Coordinates begin, end, node;
        for (unsigned int d = 0, power = 1; d < dim; ++d, power *= n)
          {
            const double scale =
              direction *
              (geometry.axis_parallel ? geometry.inverse_extent[d] : 1.);
            velocity[i][d] *= scale;
            velocity[i][dim + d] *= scale;
            begin[d] = velocity[i][d];
            end[d]   = velocity[i][d] + velocity[i][dim + d];
            node[d]  = static_cast<double>((i / power) % n) / degree;
          }
        if (!geometry.axis_parallel)
          {
            const auto jacobian = CellPolynomial::gradient<dim>(shape, node);
            begin               = CellPolynomial::solve<dim>(jacobian, begin);
            end                 = CellPolynomial::solve<dim>(jacobian, end);
          }
        for (unsigned int d = 0; d < dim; ++d)
          fastest = std::max({fastest, std::abs(begin[d]), std::abs(end[d])});
      }
    return fastest;
  }


  template <int dim, unsigned int degree>
  void
  PathField<dim, degree>::to_polynomial(Polynomial &values)
  {
    for (unsigned int d = 0, stride = 1; d < dim; ++d, stride *= n)
      for (unsigned int i = 0; i < n_nodes; ++i)
        if ((i / stride) % n == 0)
          for (unsigned int c = 0; c < width; ++c)
            {
              const double first = values[i][c];
              const double last  = values[i + degree * stride][c];
              if constexpr (degree == 1)
                values[i + stride][c] = last - first;
              else
                {
                  const double middle       = values[i + stride][c];
                  values[i + stride][c]     = 4. * middle - 3. * first - last;
                  values[i + 2 * stride][c] = 2. * (first - 2. * middle + last);
                }
            }
  }


  template class PathField<2, 1>;
  template class PathField<2, 2>;
  template class PathField<3, 1>;
  template class PathField<3, 2>;
} // namespace Thalweg
