// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/section.h>

namespace Thalweg
{
  Section::Section(dealii::ParameterHandler &prm)
    : prm(&prm)
  {}


  Section
  Section::enter(const std::string &name) const
  {
    Section subsection(*prm);
    subsection.path = path;
    subsection.path.push_back(name);
    subsection.enter_path();
    subsection.leave_path();
    return subsection;
  }


  void
  Section::enter_path() const
  {
    for (const std::string &name : path)
      prm->enter_subsection(name);
  }


  void
  Section::leave_path() const
  {
    for (std::size_t i = 0; i < path.size(); ++i)
      prm->leave_subsection();
  }
} // namespace Thalweg
