// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/ports.h>

namespace Thalweg
{
  std::string
  Ports::inventory() const
  {
    std::string all;
    for (const auto &[part, things] : offers)
      for (const auto &[thing, object] : things)
        all += (all.empty() ? "is '" : ", '") + thing + "' of '" + part + "'";
    return all.empty() ? "is nothing" : all;
  }
} // namespace Thalweg
