#include <thalweg/core/section.h>

namespace Thalweg
{
  Section::Section(dealii::ParameterHandler &prm)
    : prm(&prm)
    , entered(false)
  {}



  Section::Section(dealii::ParameterHandler &prm, const std::string &name)
    : prm(&prm)
    , entered(true)
  {
    prm.enter_subsection(name);
  }



  Section::Section(Section &&other) noexcept
    : prm(other.prm)
    , entered(other.entered)
  {
    other.entered = false;
  }



  Section::~Section()
  {
    if (entered)
      prm->leave_subsection();
  }



  Section
  Section::enter(const std::string &name) const
  {
    return Section(*prm, name);
  }
} // namespace Thalweg
