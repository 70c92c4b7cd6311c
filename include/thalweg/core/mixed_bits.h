// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_mixed_bits_h
#define thalweg_core_mixed_bits_h

#include <cstdint>

namespace Thalweg
{
  /// The step from one state of SplitMix64 (Steele, Lea and Flood 2014) to the
  /// next.
  constexpr std::uint64_t mixing_step = 0x9e3779b97f4a7c15ull;

  /// The number that SplitMix64 gives after @p x: all bits depend on all.
  inline std::uint64_t
  mixed_bits(std::uint64_t x)
  {
    x += mixing_step;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
  }
} // namespace Thalweg

#endif
