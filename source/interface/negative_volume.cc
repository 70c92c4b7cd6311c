// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/interface/cut_cell.h>
#include <thalweg/interface/cut_in_space.h>

#include <algorithm>

namespace Thalweg
{
  template <int dim>
  double
  negative_volume(const typename CellGraph<dim>::Cell  &cell,
                  const std::array<double, (1 << dim)> &phi)
  {
    if (cell.axis_parallel)
      return cell.measure * SimplexCut::negative_fraction<dim>(phi);
    const auto [smallest, largest] =
      std::minmax_element(phi.begin(), phi.end());
    if (*smallest >= 0)
      return 0.;
    if (*largest <= 0)
      return cell.measure;
    double volume = 0;
    SimplexCut::cut_in_space<dim>(Q1::SimplexShape<dim>(cell.vertices),
                                  phi,
                                  [&volume](const auto &piece,
                                            const auto &,
                                            const auto &) {
                                    if (piece.negative)
                                      volume += piece.measure;
                                  });
    return volume;
  }



  template double
  negative_volume<2>(const CellGraph<2>::Cell &, const std::array<double, 4> &);
  template double
  negative_volume<3>(const CellGraph<3>::Cell &, const std::array<double, 8> &);
} // namespace Thalweg
