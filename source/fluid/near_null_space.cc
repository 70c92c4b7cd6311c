// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/near_null_space.h>

#include <deal.II/base/mpi.h>

namespace Thalweg
{
  namespace
  {
    template <int dim>
    dealii::Point<dim>
    middle_of_nodes(const NodeSpace<dim> &space)
    {
      std::vector<double> sums(dim + 1, 0.);
      for (unsigned int n = 0; n < space.n_owned_nodes(); ++n)
        {
          for (unsigned int d = 0; d < dim; ++d)
            sums[d] += space.position(n)[d];
          sums[dim] += 1.;
        }
      dealii::Utilities::MPI::sum(
        sums, space.mesh().triangulation().get_communicator(), sums);
      dealii::Point<dim> middle;
      for (unsigned int d = 0; d < dim; ++d)
        middle[d] = sums[d] / sums[dim];
      return middle;
    }
  } // namespace



  template <int dim>
  std::vector<std::vector<double>>
  rigid_motions(const NodeSpace<dim> &space)
  {
    constexpr unsigned int           n_rotations = dim == 2 ? 1 : 3;
    const auto                       middle      = middle_of_nodes(space);
    const unsigned int               n_values    = dim * space.n_owned_nodes();
    std::vector<std::vector<double>> modes(dim + n_rotations,
                                           std::vector<double>(n_values, 0.));
    for (unsigned int n = 0; n < space.n_owned_nodes(); ++n)
      {
        const auto x = space.position(n) - middle;
        for (unsigned int d = 0; d < dim; ++d)
          modes[d][dim * n + d] = 1.;
        for (unsigned int r = 0; r < n_rotations; ++r)
          {
            // in the plane of these axes
            const unsigned int a = r, b = (r + 1) % dim;
            modes[dim + r][dim * n + a] = -x[b];
            modes[dim + r][dim * n + b] = x[a];
          }
      }
    return modes;
  }



  template std::vector<std::vector<double>>
  rigid_motions(const NodeSpace<2> &);
  template std::vector<std::vector<double>>
  rigid_motions(const NodeSpace<3> &);
} // namespace Thalweg
