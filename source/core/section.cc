// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/parameter_file.h>
#include <thalweg/core/section.h>

namespace Thalweg
{
  Section::Section(dealii::ParameterHandler &prm)
    : prm(&prm)
  {}


  Section
  Section::with(const ParameterFile &file) const
  {
    Section same(*this);
    same.input = &file;
    return same;
  }


  std::string
  Section::given(const std::string &name, const std::string &otherwise) const
  {
    std::string full;
    for (const std::string &section : path)
      full += section + "/";
    return input == nullptr ? otherwise : input->value(full + name, otherwise);
  }


  Section
  Section::enter(const std::string &name) const
  {
    Section subsection(*this);
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
