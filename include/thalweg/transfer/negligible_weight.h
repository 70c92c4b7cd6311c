// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_transfer_negligible_weight_h
#define thalweg_transfer_negligible_weight_h

namespace Thalweg
{
  /// Where the particles around a node have less weight than this in all, none
  /// is near enough to speak for it.
  constexpr double negligible_weight = 1e-10;
} // namespace Thalweg

#endif
