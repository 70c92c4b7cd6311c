// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/courant_rate.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>

namespace Thalweg
{
  template <int dim>
  double
  courant_rate(const NodeSpace<dim> &space, const Vector &velocity)
  {
    double                rate  = 0;
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        double shortest = graph.cell(c).extent.norm();
        if (!graph.cell(c).axis_parallel)
          shortest = graph.iterator(c)->minimum_vertex_distance();
        for (unsigned int v = 0; v < graph.n_vertices; ++v)
          {
            double sum = 0, squares = 0;
            for (unsigned int d = 0; d < dim; ++d)
              {
                const double u =
                  velocity.local_element(dim * space.nodes(c)[v] + d);
                const double own =
                  std::abs(u) * graph.cell(c).inverse_extent[d];
                sum = own <= sum ? sum : own;
                squares += u * u;
              }
            const double own =
              graph.cell(c).axis_parallel ? sum : std::sqrt(squares) / shortest;
            // std::max() would drop what is no number.
            if (!(own <= rate))
              rate = std::isfinite(own)
                       ? own
                       : std::numeric_limits<double>::infinity();
          }
      }
    return dealii::Utilities::MPI::max(
      rate, space.mesh().triangulation().get_communicator());
  }



  template double
  courant_rate<2>(const NodeSpace<2> &, const Vector &);
  template double
  courant_rate<3>(const NodeSpace<3> &, const Vector &);
} // namespace Thalweg
