// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/dem/contact_forces.h>
#include <thalweg/methods/grain_view.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <sstream>

#include "support/files.h"
#include "support/input.h"
#include "support/run_case.h"

using namespace Thalweg;

namespace
{
  /// Grains of two materials in a box that is periodic from side to side.
  std::string
  two_materials(const std::string &insertion,
                const std::string &dt,
                const std::string &end)
  {
    return unit_box<2>(8, "0", {"Periodic boundaries = left:right"}) +
           section("Methods",
                   {"Names = sand: grains"},
                   section("sand",
                           {},
                           section("Materials",
                                   {"Names = red, blue",
                                    "Density = 2000",
                                    "Restitution = 0.1",
                                    "Friction = 0.5"}) +
                             section("Contact",
                                     {},
                                     section("linear",
                                             {"Normal stiffness = 1e6"})) +
                             insertion)) +
           section("Body forces", {"Gravity = 0, -10"}) + steps_of(dt, end);
  }
} // namespace



// Four grains on each other: each carries the weight of those above.
TEST(GrainOutputsMpi, ContactsOfAColumnCarryItsWeight)
{
  const RunCase<2> run(two_materials(section("Insertion",
                                             {"Diameter = 0.2",
                                              "Region = min(x - 0.4, 0.6 - x)",
                                              "Spacing = 0.2"}),
                                     "0.01",
                                     "4"));
  ASSERT_EQ(run.last("sand: grains"), 5.);
  const auto       view = run.simulation->view();
  const GrainView &grains =
    view.ports->get<const GrainView>("sand", "grains", "");
  std::vector<double> forces;
  for (const GrainContact &contact :
       contact_forces(grains.system, grains.law, grains.materials.n()))
    {
      EXPECT_NEAR(contact.force.x, 0., 1e-6);
      EXPECT_GT(contact.overlap, 0.);
      forces.push_back(std::abs(contact.force.y));
    }
  std::vector<double> all;
  for (const auto &of_rank :
       dealii::Utilities::MPI::gather(MPI_COMM_WORLD, forces))
    all.insert(all.end(), of_rank.begin(), of_rank.end());
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return;
  std::sort(all.begin(), all.end());
  ASSERT_EQ(all.size(), 4u);
  const double weight = 2000. * M_PI * .01 * 10.;
  for (unsigned int i = 0; i < 4; ++i)
    EXPECT_NEAR(all[i], (i + 1) * weight, 1e-3 * weight) << i;
}



// Red grains below blue ones are apart. In columns by turns there are 10 or 15
// red ones in samples of 25, whose variance is that of chance.
TEST(GrainOutputsMpi, MixingIsThatOfLacey)
{
  const auto index = [](const std::string &is_red) {
    const std::string place = own_path("mixing");
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::filesystem::create_directories(place);
    MPI_Barrier(MPI_COMM_WORLD);
    const auto insertion = [&](const std::string &name,
                               const std::string &region) {
      return section(name,
                     {"Diameter = 0.099",
                      "Spacing = 0.1",
                      "Material = " + name,
                      "Region = " + region});
    };
    {
      const RunCase<2> run(
        two_materials(section("Insertion",
                              {"Names = red, blue"},
                              insertion("red", is_red) +
                                insertion("blue", "-(" + is_red + ")")),
                      "1e-5",
                      "1e-5") +
          section("Postprocess",
                  {"Models = mixing"},
                  section("mixing", {"Width = 0.5", "Material = blue"})),
        MPI_COMM_WORLD,
        place);
      EXPECT_EQ(run.last("sand: grains"), 100.);
    }
    MPI_Barrier(MPI_COMM_WORLD);
    std::istringstream table(content(place + "/sand_mixing.csv"));
    std::string        line;
    std::getline(table, line);
    std::getline(table, line);
    double time = 0., value = 0., part = 0.;
    char   comma;
    std::istringstream(line) >> time >> comma >> value >> comma >> part;
    EXPECT_EQ(part, .5);
    MPI_Barrier(MPI_COMM_WORLD);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::filesystem::remove_all(place);
    return value;
  };
  EXPECT_NEAR(index("0.5 - y"), 0., 1e-12);
  EXPECT_NEAR(index("sin(10*pi*x)"), 1., 1e-12);
}
