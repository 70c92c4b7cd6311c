// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_materials_laminate_h
#define thalweg_materials_laminate_h

#include <array>

namespace Thalweg
{
  /// Of layers of two materials, of which a part of the volume is the first:
  /// what they have together along the layers.
  inline double
  arithmetic_mean(const double part, const std::array<double, 2> &values)
  {
    return part * values[0] + (1. - part) * values[1];
  }

  /// What they have across them; 0 where one of them has none.
  inline double
  harmonic_mean(const double part, const std::array<double, 2> &values)
  {
    return values[0] * values[1] > 0.
             ? values[0] * values[1] /
                 (part * values[1] + (1. - part) * values[0])
             : 0.;
  }
} // namespace Thalweg

#endif
