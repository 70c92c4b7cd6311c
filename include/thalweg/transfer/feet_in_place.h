// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_transfer_feet_in_place_h
#define thalweg_transfer_feet_in_place_h

#include <thalweg/fields/node_space.h>
#include <thalweg/particles/streamline_convection.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief What new particles are that appear between two steps, where nothing
   * moves: they have the fields' values at the points themselves.
   *
   * @param cells numbers of owned cells in the cell graph, one a point
   * @param reference_points coordinates in these cells
   * @param velocity_space of degree 1 or 2
   * @param velocity ghosted, m/s
   * @param level_set_space of the same mesh
   * @param level_set ghosted
   * @return one foot a point
   */
  template <int dim>
  std::vector<Foot<dim>>
  feet_in_place(const std::vector<unsigned int>       &cells,
                const std::vector<dealii::Point<dim>> &reference_points,
                const LagrangeSpace<dim>              &velocity_space,
                const Vector                          &velocity,
                const NodeSpace<dim>                  &level_set_space,
                const Vector                          &level_set);
} // namespace Thalweg

#endif
