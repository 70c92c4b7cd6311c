// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/materials/fluids.h>

#include <deal.II/base/exceptions.h>

namespace Thalweg
{
  void
  Fluids::declare_parameters(const Section &root)
  {
    const Section section = root.enter("Fluids");
    section.add("Number",
                number,
                "",
                "One fluid, or two that do not mix.",
                dealii::Patterns::Integer(1, 2));
    for (unsigned int f = 0; f < 2; ++f)
      {
        const Section fluid =
          section.enter(f == 0 ? "First fluid" : "Second fluid");
        fluid.add("Name",
                  fluids[f].name,
                  "",
                  f == 0
                    ? "How the other sections call this fluid; it is where "
                      "the initial level set is negative."
                    : "How the other sections call this fluid; it is where "
                      "the initial level set is positive.",
                  dealii::Patterns::Anything());
        fluid.add("Density",
                  fluids[f].density,
                  "kg/m^3",
                  "The fluid's density.",
                  dealii::Patterns::Double());
        fluid.add("Viscosity",
                  fluids[f].viscosity,
                  "Pa s",
                  "The fluid's dynamic viscosity.",
                  dealii::Patterns::Double());
        rheologies[f].declare_parameters(fluid.enter("Rheology"),
                                         "newton",
                                         "law of the viscosity");
      }
  }



  void
  Fluids::check() const
  {
    for (unsigned int f = 0; f < number; ++f)
      {
        const std::string where =
          std::string("Fluids/") + (f == 0 ? "First" : "Second") + " fluid";
        AssertThrow(fluids[f].density > 0,
                    dealii::ExcMessage("'" + where + "/Density' is " +
                                       std::to_string(fluids[f].density) +
                                       "; a density must be positive."));
        AssertThrow(fluids[f].viscosity >= 0,
                    dealii::ExcMessage("'" + where + "/Viscosity' is " +
                                       std::to_string(fluids[f].viscosity) +
                                       "; write zero for an ideal fluid, or a "
                                       "positive viscosity."));
        AssertThrow(!fluids[f].name.empty(),
                    dealii::ExcMessage("'" + where + "/Name' is empty."));
      }
    AssertThrow(number == 1 || fluids[0].name != fluids[1].name,
                dealii::ExcMessage("Both fluids are called '" + fluids[0].name +
                                   "'; give them different names."));
  }



  unsigned int
  Fluids::index(const std::string &name) const
  {
    for (unsigned int f = 0; f < number; ++f)
      if (fluids[f].name == name)
        return f;
    AssertThrow(false,
                dealii::ExcMessage(
                  "There is no fluid '" + name + "'; there is '" +
                  fluids[0].name + "'" +
                  (number == 2 ? " and '" + fluids[1].name + "'." : ".")));
    return 0;
  }
} // namespace Thalweg
