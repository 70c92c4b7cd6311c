// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/fields/expression.h>
#include <thalweg/methods/scalar_parameters.h>

namespace Thalweg
{
  void
  ScalarParameters::declare(const Section &section)
  {
    using namespace dealii::Patterns;
    section.add("Carrier",
                carrier,
                "",
                "The name of the method whose particles carry the scalar, "
                "which stands before this one in `Methods/Names`; empty: the "
                "first that has particles.",
                Anything());
    section.add(
      "Unit",
      unit,
      "",
      "What the scalar is measured in, for the names of columns: `K`.",
      Anything());
    section.add("Initial value",
                initial,
                "",
                "At the start, a function of x, y and z.",
                Anything());
    section.add("Diffusivity",
                diffusivity,
                "m^2/s",
                "Of all fluids, or of each, `water: 1.4e-7, air: 2e-5`.",
                Anything());
    section.add("Capacity",
                capacity,
                "",
                "What a cubic metre holds for each unit of the scalar, J/(m^3 "
                "K) of heat; of all fluids, or of each. The diffusivity times "
                "this is the conductivity.",
                Anything());
    section.add("Source",
                source,
                "",
                "What is supplied to a cubic metre in a second, in units of "
                "the scalar times the capacity (W/m^3 of heat), a function of "
                "x, y, z and t.",
                Anything());
    section.add(
      "Latent heat",
      latent_heat,
      "",
      "What it takes to melt a cubic metre, in units of the scalar "
      "times the capacity (J/m^3 of heat); `wax: 1.8e8, air: 0` where "
      "there are two fluids, of which one may melt.");
    section.add("Solidus",
                solidus,
                "",
                "The value of the scalar at which it begins to melt.");
    section.add("Liquidus",
                liquidus,
                "",
                "The value at which all has molten; that of the solidus, if "
                "there is one melting point.");
    section.add("Tolerance",
                tolerance,
                "",
                "Of the linear solver, a part of the first residual.",
                Double(0., 1.));
    conditions.declare(section.enter("Boundary conditions"));
  }



  template <int dim>
  void
  ScalarParameters::check(std::vector<std::string> &faults) const
  {
    for (const auto &[name, text] : {std::make_pair("Initial value", initial),
                                     std::make_pair("Source", source)})
      {
        const std::string where = name, expression = text;
        collect_fault(faults, [&where, &expression]() {
          parse_expression<dim>(expression, 1, where);
        });
      }
    collect_fault(faults, [this]() {
      AssertThrow(
        liquidus >= solidus,
        dealii::ExcMessage(
          "'Liquidus' is below 'Solidus': what melts begins to at the "
          "solidus, and is liquid above the liquidus; for one melting "
          "point both are the same."));
      AssertThrow(melts() || (liquidus == 0. && solidus == 0.),
                  dealii::ExcMessage("'Solidus' and 'Liquidus' are for what "
                                     "melts: give a 'Latent heat', or leave "
                                     "them out."));
    });
  }



  template void
  ScalarParameters::check<2>(std::vector<std::string> &) const;
  template void
  ScalarParameters::check<3>(std::vector<std::string> &) const;
} // namespace Thalweg
