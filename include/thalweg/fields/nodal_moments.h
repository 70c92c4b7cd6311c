// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_nodal_moments_h
#define thalweg_fields_nodal_moments_h

#include <thalweg/fields/node_space.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief Adds up what the ranks have of sums over the particles around nodes,
   * and what periodic copies of a node have. Collective.
   * @tparam Moments has an array `sums` of length `size`
   * @param nodal one a local node; afterwards those of owned ones are complete
   */
  template <int dim, typename Moments>
  void
  join_moments(const NodeSpace<dim> &space, std::vector<Moments> &nodal)
  {
    Vector sums;
    space.initialize_scalar(sums);
    for (unsigned int k = 0; k < Moments::size; ++k)
      {
        sums.zero_out_ghost_values();
        for (unsigned int node = 0; node < nodal.size(); ++node)
          sums.local_element(node) = nodal[node].sums[k];
        space.fold(sums, 1);
        for (unsigned int node = 0; node < sums.locally_owned_size(); ++node)
          nodal[node].sums[k] = sums.local_element(node);
      }
  }
} // namespace Thalweg

#endif
