// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/grain_view.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <gtest/gtest.h>

#include "support/complaint.h"
#include "support/dimensions.h"
#include "support/input.h"
#include "support/resumed_case.h"

using namespace Thalweg;

namespace
{
  /// The sections of grains that fall in a unit box.
  std::string
  grain_sections(const std::vector<std::string> &insertion,
                 const std::vector<std::string> &walls   = {},
                 const std::vector<std::string> &contact = {},
                 const std::string              &name    = "sand")
  {
    return section(name,
                   {},
                   section("Materials",
                           {"Density = 2000",
                            "Restitution = 0.6",
                            "Friction = 0.4",
                            "Rolling friction = 0.05"}) +
                     section("Contact",
                             contact,
                             section("linear", {"Normal stiffness = 1e6"})) +
                     section("Insertion", insertion) + section("Walls", walls));
  }

  std::string
  with_grains(const std::string &sections)
  {
    return section("Methods", {"Names = sand: grains"}, sections);
  }

  template <int dim>
  std::string
  gravity()
  {
    return section("Body forces",
                   {dim == 2 ? "Gravity = 1, -9.81"
                             : "Gravity = 1, 0.5, -9.81"});
  }

  /// All grains of a run by their numbers.
  template <int dim>
  std::map<std::uint64_t, GrainRecord>
  grains_of(const RunCase<dim> &run, const std::string &name = "sand")
  {
    const auto  view = run.simulation->view();
    const auto &system =
      view.ports->template get<const GrainView>(name, "grains", "A test")
        .system;
    std::map<std::uint64_t, GrainRecord> all;
    for (const auto &grain : system.all().grains)
      all[grain.id] = grain;
    return all;
  }

  bool
  same_bits(const Vec3 &a, const Vec3 &b)
  {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  }

  /// Whether this process's grains are those of another run, to the last bit.
  void
  expect_same_bits(const std::map<std::uint64_t, GrainRecord> &some,
                   const std::map<std::uint64_t, GrainRecord> &all)
  {
    unsigned int n_different = 0;
    for (const auto &[id, grain] : some)
      {
        const GrainRecord &other = all.at(id);
        n_different +=
          !(same_bits(grain.x, other.x) && same_bits(grain.v, other.v) &&
            same_bits(grain.w, other.w) && same_bits(grain.force, other.force));
      }
    EXPECT_EQ(n_different, 0u);
    EXPECT_EQ(dealii::Utilities::MPI::sum(some.size(), MPI_COMM_WORLD),
              all.size());
  }

  const std::vector<std::string> some_grains{"Pattern = random",
                                             "Number = 120",
                                             "Sizes = uniform",
                                             "Diameter = 0.07",
                                             "Spread = 0.03",
                                             "Velocity = -x; 0.3"};
  const std::vector<std::string> some_balls{"Pattern = random",
                                            "Number = 150",
                                            "Sizes = uniform",
                                            "Diameter = 0.13",
                                            "Spread = 0.05",
                                            "Velocity = -x; 0.3; 0"};

  template <int dim>
  std::string
  some()
  {
    return with_grains(grain_sections(dim == 2 ? some_grains : some_balls,
                                      {},
                                      {"Rolling = epsd"})) +
           gravity<dim>();
  }

  /// A mesh that is refined and coarsened under the grains.
  template <int dim>
  std::string
  wandering_mesh()
  {
    return unit_box<dim>(3) +
           section("Refinement",
                   {},
                   section("Adaptive",
                           {"Criteria = region", "Maximum level = 2"},
                           section("region",
                                   {"At least = if(x < 10*t, 2, 0)",
                                    "At most = if(x < 10*t, 2, 0)"})));
  }
} // namespace



template <typename Dimension>
class GrainsMpi : public testing::Test
{};
TYPED_TEST_SUITE(GrainsMpi, Dimensions);

TYPED_TEST(GrainsMpi, TheBitsAreTheSameOnAnyNumberOfProcessesAndMeshes)
{
  constexpr int      dim   = TypeParam::value;
  const std::string  steps = steps_of("0.01", "0.2");
  const RunCase<dim> alone(unit_box<dim>(1) + some<dim>() + steps,
                           MPI_COMM_SELF);
  const auto         all = grains_of(alone);
  EXPECT_GT(alone.last("sand: rebuilds of lists"), 3.);
  EXPECT_GT(alone.last("sand: contacts a grain"), .05);
  // Cells of three diameters and of a third of one, and hanging nodes.
  for (const std::string &mesh : {unit_box<dim>(4),
                                  unit_box<dim>(dim == 2 ? 48 : 20),
                                  hanging_box<dim>(5),
                                  wandering_mesh<dim>()})
    {
      const RunCase<dim> run(mesh + some<dim>() + steps);
      expect_same_bits(grains_of(run), all);
      EXPECT_EQ(run.last("sand: grains lost"), 0.);
    }
}



TYPED_TEST(GrainsMpi, TheyLeaveThroughOpenBoundariesAndComeInAtIntervals)
{
  constexpr int      dim = TypeParam::value;
  const RunCase<dim> run(
    unit_box<dim>(4) +
    with_grains(grain_sections(
      {std::string("Region = if(") + "xyz"[dim - 1] + " > 0.79, 1, -1)",
       "Diameter = 0.2",
       "Interval = 0.1",
       "Last time = 0.25",
       std::string("Velocity = ") + (dim == 2 ? "0; -8" : "0; 0; -8")},
      {std::string("Open = ") + (dim == 2 ? "bottom" : "front")})) +
    steps_of("0.01", "0.6"));
  const double n = 3. * std::pow(5., dim - 1);
  EXPECT_EQ(run.last("sand: grains"), 0.);
  EXPECT_EQ(run.last("sand: grains left"), n);
  EXPECT_EQ(run.last("sand: grains lost"), 0.);
  EXPECT_NEAR(run.last("sand: missing energy [J]"), 0., 1e-9 * n * 1000.);
}



TYPED_TEST(GrainsMpi, StreamsHaveTheirRateAndGrainsAreTakenOut)
{
  constexpr int     dim  = TypeParam::value;
  const std::string high = std::string(1, "xyz"[dim - 1]);
  const auto        run  = [&](const std::string &rate) {
    return RunCase<dim>(
      unit_box<dim>(4) +
      with_grains(grain_sections(
        {"Region = " + high + " - 0.6",
         "Pattern = random",
         "Diameter = 0.05",
         "Sizes = uniform",
         "Spread = 0.01",
         "Interval = 0.02",
         "Last time = 0.09",
         rate,
         std::string("Velocity = ") + (dim == 2 ? "0; -8" : "0; 0; -8")})) +
      steps_of("0.01", "0.12"));
  };
  // At 0, 0.02, ... 0.08 s.
  const RunCase<dim> numbers = run("Number rate = 137");
  EXPECT_EQ(numbers.last("sand: grains"), std::floor(137. * .1));
  const double       mass_rate = dim == 2 ? 500. : 30.;
  const RunCase<dim> masses = run("Mass rate = " + std::to_string(mass_rate));
  // The last grain of each interval may be too much, which counts for the next.
  const double largest = 2000. * M_PI * .0009 * (dim == 2 ? 1. : .04);
  EXPECT_GE(masses.last("sand: mass in [kg]"), mass_rate * .1);
  EXPECT_LT(masses.last("sand: mass in [kg]"), mass_rate * .1 + largest);
  const RunCase<dim> taken(
    unit_box<dim>(4) +
    with_grains(section(
      "sand",
      {},
      section("Contact", {}, section("linear", {"Normal stiffness = 1e6"})) +
        section("Insertion", {"Diameter = 0.2", "Spacing = 0.25"}) +
        section("Removal", {"Region = if(t > 0.015, x - 0.5, -1)"}))) +
    steps_of("0.01", "0.03"));
  EXPECT_EQ(taken.last("sand: grains"), .5 * std::pow(4., dim));
  EXPECT_EQ(taken.last("sand: grains left"), .5 * std::pow(4., dim));
  EXPECT_NEAR(taken.last("sand: missing energy [J]"), 0., 1e-9);
}



TYPED_TEST(GrainsMpi, EnergyIsMissedWithTheSquareOfTheSubStep)
{
  constexpr int dim = TypeParam::value;
  // Through the periodic sides, too.
  const auto budget = [](const std::string &steps_a_contact) {
    const RunCase<dim> run(
      unit_box<dim>(4, "0", {"Periodic boundaries = left:right"}) +
      with_grains(grain_sections({"Diameter = 0.19",
                                  "Spacing = 0.25",
                                  std::string("Velocity = 0.3*sin(2*pi*y); ") +
                                    (dim == 2 ? "-1" : "0; -1")},
                                 {},
                                 {"Steps a contact = " + steps_a_contact})) +
      section("Body forces",
              {dim == 2 ? "Gravity = 0, -9.81" : "Gravity = 0, 0, -9.81"}) +
      steps_of("0.01", "0.3"));
    EXPECT_EQ(run.last("sand: grains"), std::pow(4., dim));
    EXPECT_EQ(run.last("sand: grains left"), 0.);
    const double dissipated = run.last("sand: dissipated along normals [J]");
    EXPECT_GT(dissipated, 1.);
    return std::abs(run.last("sand: missing energy [J]")) /
           (run.last("sand: translational energy [J]") + dissipated);
  };
  const double coarse = budget("50"), fine = budget("100");
  EXPECT_LT(fine, 2e-4);
  EXPECT_GT(coarse / fine, 3.);
}



TYPED_TEST(GrainsMpi, ARunGoesOnFromACheckpointWithTheSameBits)
{
  constexpr int          dim   = TypeParam::value;
  const std::string      input = wandering_mesh<dim>() + some<dim>();
  const std::string      end   = steps_of("0.01", "0.2");
  const RunCase<dim>     straight(input + end, MPI_COMM_SELF);
  const ResumedCase<dim> resumed(input + end, 11);
  expect_same_bits(grains_of(*resumed), grains_of(straight));
  EXPECT_NEAR(resumed->last("sand: missing energy [J]"),
              straight.last("sand: missing energy [J]"),
              1e-9);
}



TYPED_TEST(GrainsMpi, AnyNumberOfThemAndTwoMethodsBesideEachOther)
{
  constexpr int dim = TypeParam::value;
  // None come in before the end.
  const RunCase<dim> none(
    unit_box<dim>(2) +
    with_grains(grain_sections({"Diameter = 0.1", "First time = 5"})) +
    steps_of("0.01", "0.02"));
  EXPECT_EQ(none.last("sand: grains"), 0.);
  const RunCase<dim> both(
    unit_box<dim>(2) +
    section("Methods",
            {"Names = a: grains, b: grains"},
            grain_sections(
              {"Diameter = 0.2", "Number = 1", "Spacing = 0.5"}, {}, {}, "a") +
              grain_sections({"Diameter = 0.3", "Number = 2", "Spacing = 0.5"},
                             {},
                             {},
                             "b")) +
    gravity<dim>() + steps_of("0.01", "0.5"));
  EXPECT_EQ(both.last("a: grains"), 1.);
  EXPECT_EQ(both.last("b: grains"), 2.);
  EXPECT_GT(both.last("a: dissipated along normals [J]"), 0.);
}



TEST(Grains, TheyFallAsFastAThousandKilometresAway)
{
  const auto center = [](const std::string &lower, const std::string &upper) {
    const RunCase<3> run(
      section("Geometry",
              {},
              section("box",
                      {"Lower corner = " + lower, "Upper corner = " + upper})) +
      with_grains(grain_sections({"Pattern = random",
                                  "Number = 150",
                                  "Diameter = 0.13",
                                  "Velocity = 0.5; 0.3; 0"})) +
      gravity<3>() + steps_of("0.01", "0.1"));
    EXPECT_EQ(run.last("sand: grains lost"), 0.);
    return run.last("sand: potential energy [J]");
  };
  const double here = center("0, 0, 0", "1, 1, 1");
  EXPECT_NEAR(center("1e6, -1e6, 1e6", "1000001, -999999, 1000001"),
              here,
              1e-3 * std::abs(here));
}



TEST(Grains, WhatCannotBeIsRefused)
{
  const auto complaint = [](const std::string &methods) {
    return complaint_of(
      [&]() { RunCase<2>(unit_box<2>(2) + methods + steps_of("0.1", "0.1")); });
  };
  EXPECT_EQ(complaint(with_grains(grain_sections({"Diameter = 0.1"}))), "");
  EXPECT_NE(complaint(
              with_grains(grain_sections({"Diameter = 0.1", "Region = x - 2"})))
              .find("room for 0 grains"),
            std::string::npos);
  EXPECT_NE(complaint(with_grains(grain_sections(
                        {"Diameter = 0.4", "Pattern = random", "Number = 50"})))
              .find("of the 50"),
            std::string::npos);
}
