// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_interface_sampled_volume_h
#define thalweg_interface_sampled_volume_h

#include <thalweg/mesh/cell_graph.h>

#include <deal.II/base/function.h>

namespace Thalweg
{
  /**
   * @brief The volume of the part of a cell where a function is negative.
   *
   * The function is sampled on 10^dim sub-cells where it comes near zero, and
   * cut linearly in each: exact for planes if the function is linear. Spheres
   * come out too small, their radius by about a sixth of s^2/R for sub-cells
   * of size s, which is 0.02 % of the volume for a radius of five cells.
   *
   * @param cell a cell of any shape
   * @param function a level set that varies about as fast as a distance
   * @return m^dim
   */
  template <int dim>
  double
  sampled_negative_volume(const typename CellGraph<dim>::Cell &cell,
                          const dealii::Function<dim>         &function);

  /// The same for all locally owned cells of all processes. Collective.
  template <int dim>
  double
  sampled_negative_volume(const CellGraph<dim>        &graph,
                          const dealii::Function<dim> &function,
                          const MPI_Comm               communicator);
} // namespace Thalweg

#endif
