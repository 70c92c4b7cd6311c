// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/materials/fluids.h>

#include <cmath>
#include <gtest/gtest.h>
#include <memory>

#include "support/input.h"

using namespace Thalweg;

namespace
{
  /// A law with these settings.
  struct Law
  {
    explicit Law(const std::string              &name,
                 const std::vector<std::string> &settings = {})
      : model(Registry<Rheology>::entries().at(name).make())
    {
      model->declare_parameters(Section(prm));
      std::string text;
      for (const std::string &setting : settings)
        text += "set " + setting + "\n";
      prm.parse_input_from_string(text);
    }

    double
    stress(const double rate, const double reference) const
    {
      return model->value(rate, reference).viscosity * rate;
    }

    dealii::ParameterHandler  prm;
    std::unique_ptr<Rheology> model;
  };
} // namespace



TEST(Rheology, LawsHaveTheirStresses)
{
  EXPECT_EQ(Law("newton").stress(3., 2.), 6.);
  EXPECT_FALSE(Law("newton").model->depends_on_shear());
  EXPECT_NEAR(Law("power law", {"Exponent = 0.5"}).stress(4., 3.), 6., 1e-6);
  EXPECT_NEAR(
    Law("carreau",
        {"Exponent = 0.5", "Relaxation time = 2", "Infinite viscosity = 1"})
      .stress(2., 5.),
    2. * (1. + 4. * std::pow(17., -.25)),
    1e-14);
  EXPECT_NEAR(Law("bingham", {"Yield stress = 7"}).stress(2., 3.), 13., 1e-6);
  EXPECT_NEAR(Law("herschel bulkley", {"Yield stress = 7", "Exponent = 2"})
                .stress(2., 3.),
              19.,
              1e-5);
}



TEST(Rheology, SlopesAreDerivativesDownToStandstill)
{
  for (const char *name :
       {"newton", "power law", "carreau", "bingham", "herschel bulkley"})
    {
      const Law  law(name,
                    std::string(name) == "bingham" ||
                        std::string(name) == "herschel bulkley"
                       ? std::vector<std::string>{"Yield stress = 5"}
                       : std::vector<std::string>{});
      const auto start = law.model->value(0., 2.);
      EXPECT_TRUE(std::isfinite(start.viscosity + start.slope)) << name;
      for (double rate = 1e-9; rate < 1e6; rate *= 3.)
        {
          const double step  = 1e-5 * rate;
          const double above = law.model->value(rate + step, 2.).viscosity;
          const double below = law.model->value(rate - step, 2.).viscosity;
          EXPECT_NEAR(law.model->value(rate, 2.).slope * rate,
                      (above - below) / (2. * step) * rate,
                      1e-9 * above)
            << name << " " << rate;
        }
    }
}



TEST(Rheology, FluidsHaveOneEach)
{
  dealii::ParameterHandler prm;
  Fluids                   fluids;
  EXPECT_FALSE(fluids.depend_on_shear());
  fluids.declare_parameters(Section(prm));
  prm.parse_input_from_string(section(
    "Fluids",
    {},
    section("Second fluid", {}, section("Rheology", {"Model = carreau"}))));
  EXPECT_TRUE(fluids.depend_on_shear());
  EXPECT_EQ(fluids.rheology(0), nullptr);
  EXPECT_NE(fluids.rheology(1), nullptr);
}
