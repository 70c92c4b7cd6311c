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
        all += (all.empty() ? "what there is: '" : ", '") + thing + "'" +
               (part.empty() ? "" : " of '" + part + "'");
    return all.empty() ? "there is nothing yet" : all;
  }
} // namespace Thalweg
