// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/interface/interface_quadrature.h>

#include <cmath>

namespace Thalweg
{
  template <>
  const std::vector<std::pair<std::array<double, 2>, double>> &
  side_quadrature<2>()
  {
    static const double x = .5 * (1. - std::sqrt(.6));
    static const std::vector<std::pair<std::array<double, 2>, double>> rule{
      {{{x, 1. - x}}, 5. / 18.},
      {{{.5, .5}}, 8. / 18.},
      {{{1. - x, x}}, 5. / 18.}};
    return rule;
  }



  template <>
  const std::vector<std::pair<std::array<double, 3>, double>> &
  side_quadrature<3>()
  {
    // D. Dunavant, Int. J. Numer. Methods Eng. 21, 1985, degree 4
    constexpr double a = .445948490915965, b = .091576213509771;
    constexpr double at_a = .223381589678011, at_b = .109951743655322;
    static const std::vector<std::pair<std::array<double, 3>, double>> rule{
      {{{a, a, 1. - 2. * a}}, at_a},
      {{{a, 1. - 2. * a, a}}, at_a},
      {{{1. - 2. * a, a, a}}, at_a},
      {{{b, b, 1. - 2. * b}}, at_b},
      {{{b, 1. - 2. * b, b}}, at_b},
      {{{1. - 2. * b, b, b}}, at_b}};
    return rule;
  }
} // namespace Thalweg
