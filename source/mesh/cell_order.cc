// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/cell_order.h>

namespace Thalweg
{
  CellOrder::CellOrder(const std::vector<unsigned int> &cells,
                       const unsigned int               n_cells)
    : begin(n_cells + 1, 0)
  {
    constexpr unsigned int nowhere = dealii::numbers::invalid_unsigned_int;
    for (const unsigned int cell : cells)
      if (cell != nowhere)
        ++begin[cell + 1];
    for (unsigned int c = 0; c < n_cells; ++c)
      begin[c + 1] += begin[c];
    things.resize(begin[n_cells]);
    std::vector<unsigned int> next(begin.begin(), begin.end() - 1);
    for (unsigned int i = 0; i < cells.size(); ++i)
      if (cells[i] != nowhere)
        things[next[cells[i]]++] = i;
  }
} // namespace Thalweg
