// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_adaptation_flag_setting_h
#define thalweg_adaptation_flag_setting_h

#include <thalweg/mesh/mesh.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief Turns decisions into flags that fit together. Collective.
   *
   * Cells that meet at a vertex, also across periodic boundaries, may differ
   * by one level: where decisions would have it otherwise the coarser cell is
   * refined, or not coarsened. Siblings become coarser all together or not at
   * all. The processes agree on this with each other before any flag is set,
   * since what deal.II and p4est would do with flags that do not fit depends
   * on which process owns which cell.
   *
   * @param mesh gets the flags; those that it has are cleared
   * @param change of each locally owned cell: 1 finer, -1 coarser, 0 as it is
   * @return whether any flag is set on any process
   */
  template <int dim>
  bool
  set_flags(Mesh<dim> &mesh, const std::vector<signed char> &change);
} // namespace Thalweg

#endif
