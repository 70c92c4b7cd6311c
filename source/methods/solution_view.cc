// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/solution_view.h>

namespace Thalweg
{
  void
  declare_flow_choice(const Section &section, std::string &method)
  {
    section.add("Method",
                method,
                "",
                "The name of the method whose flow this looks at, where "
                "'Methods/Names' has several; empty: the first.",
                dealii::Patterns::Anything());
  }
} // namespace Thalweg
