// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/grain_view.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "support/complaint.h"
#include "support/dimensions.h"
#include "support/files.h"
#include "support/input.h"
#include "support/resumed_case.h"

using namespace Thalweg;

namespace
{
  template <int dim>
  std::map<std::uint64_t, GrainRecord>
  walled_grains(const RunCase<dim> &run)
  {
    const auto  view = run.simulation->view();
    const auto &system =
      view.ports->template get<const GrainView>("sand", "grains", "A test")
        .system;
    std::map<std::uint64_t, GrainRecord> all;
    for (const auto &grain : system.all().grains)
      all[grain.id] = grain;
    return all;
  }

  /// A run in a box from -1 to 1, whose lowest coordinate is @p bottom.
  /// @param walls the sections of walls, with their names in @p names
  template <int dim>
  std::string
  in_a_box(const std::vector<std::string> &insertion,
           const std::string              &names,
           const std::string              &walls,
           const std::string              &end,
           const double                    bottom     = -1.,
           const std::string              &tangential = "0.3")
  {
    const std::string low = std::string(dim == 3 ? "-1, " : "") + "-1, ";
    const std::string up  = dim == 3 ? "1, 1, 2" : "1, 2";
    return section("Geometry",
                   {},
                   section("box",
                           {"Lower corner = " + low + std::to_string(bottom),
                            "Upper corner = " + up})) +
           section("Refinement", {"Global levels = 1"}) +
           section("Methods",
                   {"Names = sand: grains"},
                   section("sand",
                           {},
                           section("Materials",
                                   {"Density = 2000",
                                    "Restitution = 0.6",
                                    "Friction = " + tangential}) +
                             section("Contact",
                                     {},
                                     section("linear",
                                             {"Normal stiffness = 1e6"})) +
                             section("Insertion", insertion) +
                             section("Walls", {"Names = " + names}, walls))) +
           section("Body forces",
                   {dim == 2 ? "Gravity = 0, -9.81"
                             : "Gravity = 0, 0, -9.81"}) +
           section("Time", {"Time step = 0.01", "End time = " + end});
  }

  /// Where the square from -1 to 1 at z = 0 is written as 2 n^2 triangles.
  class SquareFile
  {
  public:
    SquareFile(const unsigned int n, const std::string &ending)
      : path(own_path("square" + ending))
    {
      std::ofstream file(path, std::ios::binary);
      if (ending == ".obj")
        write_obj(file, n);
      else
        write_stl(file, n);
    }

    ~SquareFile()
    {
      std::remove(path.c_str());
    }

    const std::string path;

  private:
    static void
    write_obj(std::ostream &file, const unsigned int n)
    {
      file.precision(17);
      for (unsigned int j = 0; j <= n; ++j)
        for (unsigned int i = 0; i <= n; ++i)
          file << "v " << -1. + 2. * i / n << ' ' << -1. + 2. * j / n << " 0\n";
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          {
            const unsigned int a = j * (n + 1) + i + 1;
            file << "f " << a << ' ' << a + 1 << ' ' << a + n + 2 << ' '
                 << a + n + 1 << '\n';
          }
    }

    static void
    write_stl(std::ostream &file, const unsigned int n)
    {
      const std::uint32_t n_triangles = 2 * n * n;
      file << std::string(80, ' ');
      file.write(reinterpret_cast<const char *>(&n_triangles), 4);
      const auto at = [n](const unsigned int i) {
        return static_cast<float>(-1. + 2. * i / n);
      };
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          for (const bool is_upper : {false, true})
            {
              const float numbers[12]{0.F,
                                      0.F,
                                      0.F,
                                      at(i),
                                      at(j),
                                      0.F,
                                      at(i + 1),
                                      at(is_upper ? j + 1 : j),
                                      0.F,
                                      at(is_upper ? i : i + 1),
                                      at(j + 1),
                                      0.F};
              file.write(reinterpret_cast<const char *>(numbers), 48);
              file.write("\0\0", 2);
            }
    }
  };

  const std::vector<std::string> one_grain{
    "Region = if(x > 0 & x < 0.5 & y > 0 & y < 0.5 & z > 0 & z < 0.5, 1, -1)",
    "Diameter = 0.4",
    "Spacing = 0.5",
    "Velocity = 0.11; -0.7; -3",
    "Spin = 3; 0.5; -2"};

  GrainRecord
  after_impact(const std::string &names,
               const std::string &walls,
               const double       bottom = -1.)
  {
    const RunCase<3> run(in_a_box<3>(one_grain, names, walls, "0.1", bottom),
                         MPI_COMM_SELF);
    return walled_grains(run).at(0);
  }
} // namespace



TEST(GrainWallShapes, ImpactsAreTheSameOnBoundariesPlanesAndSurfaces)
{
  const auto expect_equal = [](const GrainRecord &a, const GrainRecord &b) {
    EXPECT_LT(norm(a.x - b.x), 1e-12);
    EXPECT_LT(norm(a.v - b.v), 1e-12);
    EXPECT_LT(norm(a.w - b.w), 1e-12);
  };
  const GrainRecord on_boundary = after_impact("", "", 0.);
  EXPECT_GT(on_boundary.v.z, .5);
  expect_equal(after_impact("floor: plane",
                            section("floor", {"Normal = 0, 0, 2"})),
               on_boundary);
  expect_equal(after_impact("floor: polygon",
                            section("floor",
                                    {"Corners = -1, -1, 0; 1, -1, 0; 1, 1, 0; "
                                     "-1, 1, 0"})),
               on_boundary);
  for (const char *ending : {".stl", ".obj"})
    for (const unsigned int n : {1u, 10u, 100u})
      {
        const SquareFile file(n, ending);
        // Face, edge and vertex.
        for (const char *shift :
             {"0.03, 0.011, 0", "0.05, 0.011, 0", "0.05, 0.04, 0"})
          expect_equal(after_impact("floor: surface",
                                    section("floor",
                                            {"File = " + file.path,
                                             std::string("Shift = ") + shift})),
                       on_boundary);
      }
}



template <typename Dimension>
class GrainWallsMpi : public testing::Test
{};
TYPED_TEST_SUITE(GrainWallsMpi, Dimensions);

namespace
{
  /// A paddle that turns, a lid that rises and falls, and a gate that goes,
  /// among grains.
  template <int dim>
  std::string
  stirred()
  {
    const std::string up = dim == 2 ? "; " : "; 0; ";
    return in_a_box<dim>(
      {"Pattern = random",
       dim == 2 ? "Number = 120" : "Number = 300",
       "Diameter = 0.15",
       "Sizes = uniform",
       "Spread = 0.02",
       std::string("Region = 0.9 - ") + "xyz"[dim - 1]},
      "paddle: polygon, lid: plane, gate: polygon",
      section("paddle",
              {dim == 2 ? "Corners = -0.6, -0.3; 0.6, -0.3"
                        : "Corners = -0.6, -0.6, -0.3; 0.6, -0.6, -0.3; 0.6, "
                          "0.6, -0.3; -0.6, 0.6, -0.3"},
              section("Motion",
                      {"Angular velocity = 3*cos(2*t)",
                       dim == 2 ? "Center = 0, -0.3" : "Center = 0, 0, -0.3",
                       dim == 2 ? "Velocity = 0.1; 0" : "Axis = 0, 1, 0"})) +
        section("lid",
                {dim == 2 ? "Point = 0, 1" : "Point = 0, 0, 1",
                 dim == 2 ? "Normal = 0, -1" : "Normal = 0, 0, -1"},
                section("Motion", {"Velocity = 0" + up + "0.8*sin(8*t)"})) +
        section("gate",
                {dim == 2 ? "Corners = -0.5, -1; -0.5, 0"
                          : "Corners = -0.5, -1, -1; -0.5, 1, -1; -0.5, 1, 0; "
                            "-0.5, -1, 0"},
                section("Motion", {"Last time = 0.12"})),
      "0.3");
  }

  template <int dim>
  void
  expect_same_grains(const std::map<std::uint64_t, GrainRecord> &some,
                     const std::map<std::uint64_t, GrainRecord> &all)
  {
    unsigned int n_different = 0;
    for (const auto &[id, grain] : some)
      {
        const GrainRecord &other = all.at(id);
        n_different += norm(grain.x - other.x) != 0. ||
                       norm(grain.v - other.v) != 0. ||
                       norm(grain.w - other.w) != 0.;
      }
    EXPECT_EQ(n_different, 0u);
    EXPECT_EQ(dealii::Utilities::MPI::sum(some.size(), MPI_COMM_WORLD),
              all.size());
  }
} // namespace

TYPED_TEST(GrainWallsMpi, MovingWallsGoOnFromWhereTheyWereWithTheSameBits)
{
  constexpr int      dim = TypeParam::value;
  const RunCase<dim> alone(stirred<dim>(), MPI_COMM_SELF);
  const auto         all = walled_grains(alone);
  EXPECT_EQ(alone.last("sand: grains lost"), 0.);
  EXPECT_GT(std::abs(alone.last("sand: work of walls [J]")), 1.);
  EXPECT_GT(alone.last("sand: contacts a grain"), .1);
  expect_same_grains<dim>(walled_grains(RunCase<dim>(stirred<dim>())), all);
  const ResumedCase<dim> resumed(stirred<dim>(), 17);
  expect_same_grains<dim>(walled_grains(*resumed), all);
  EXPECT_NEAR(resumed->last("sand: work of walls [J]"),
              alone.last("sand: work of walls [J]"),
              1e-9);
}



TYPED_TEST(GrainWallsMpi, AConveyorDragsAGrainUntilItRolls)
{
  constexpr int      dim = TypeParam::value;
  const RunCase<dim> run(in_a_box<dim>(
    {dim == 2
       ? "Region = if(abs(x + 0.75) < 0.1 & abs(y - 0.25) < 0.1, 1, -1)"
       : "Region = if(abs(x + 0.75) < 0.1 & abs(y - 0.25) < 0.1 & abs(z - "
         "0.25) < 0.1, 1, -1)",
     "Diameter = 0.499999",
     "Spacing = 0.5"},
    "belt: plane",
    section("belt",
            {dim == 2 ? "Normal = 0, 1" : "Normal = 0, 0, 1"},
            section("Motion",
                    {dim == 2 ? "Surface velocity = 1; 5"
                              : "Surface velocity = 1; 0; 5"})),
    "0.8"));
  // Nothing changes the angular momentum about the belt, which is as near as
  // the weight presses the grain.
  const double inertia  = dim == 2 ? .5 : .4;
  const double r        = .25;
  const double mass     = 2000. * M_PI * r * r * (dim == 2 ? 1. : 4. / 3. * r);
  const double arm      = 1. - mass * 9.81 / 1e6 / r;
  const double expected = inertia / (arm * arm + inertia);
  EXPECT_NEAR(run.last("sand: fastest grain [m/s]"), expected, 2e-3);
  EXPECT_GT(run.last("sand: work of walls [J]"), 0.);
}



TYPED_TEST(GrainWallsMpi, ATurningDrumGivesWhatIsDissipatedAndLifted)
{
  constexpr int      dim = TypeParam::value;
  const RunCase<dim> run(in_a_box<dim>(
    {std::string("Region = if(") + (dim == 2 ? "y" : "z") + " < 0 & x^2 + " +
       (dim == 2 ? "y^2" : "z^2") + " < 0.6, 1, -1)",
     "Diameter = 0.19",
     "Spacing = 0.2"},
    "drum: cylinder",
    section("drum",
            dim == 2 ? std::vector<std::string>{"Radius = 0.95"}
                     : std::vector<std::string>{"Radius = 0.95",
                                                "Axis = 0, 1, 0",
                                                "Point = 0, 0, 0"},
            section("Motion", {"Angular velocity = if(t > 0.2, 3, 0)"})),
    "0.8",
    -1.,
    "0.6"));
  const double       work = run.last("sand: work of walls [J]");
  EXPECT_EQ(run.last("sand: grains lost"), 0.);
  EXPECT_GT(work, 100.);
  EXPECT_LT(std::abs(run.last("sand: missing energy [J]")), .01 * work);
}



TYPED_TEST(GrainWallsMpi, APileIsAsHighWideAndSteepAsItWasMade)
{
  constexpr int dim = TypeParam::value;
  // A wedge with a slope of 45 degrees, and one grain far away.
  const std::string up    = dim == 2 ? "y" : "z";
  const std::string place = own_path("pile");
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::filesystem::create_directories(place);
  MPI_Barrier(MPI_COMM_WORLD);
  const std::string section_of_pile =
    section("Postprocess",
            {"Models = pile"},
            section("pile",
                    {"Interval = 1",
                     std::string("Center = -1, ") +
                       (dim == 2 ? "-1" : "-1, -1"),
                     "Along = x",
                     "Width = 0.2"}));
  RunCase<dim>(in_a_box<dim>({"Region = if(x + " + up +
                                " < -0.5 | (x > 0.85 & " + up +
                                " < -0.85), 1, -1)",
                              "Diameter = 0.199",
                              "Spacing = 0.2"},
                             "",
                             "",
                             "0.001") +
                 section_of_pile,
               MPI_COMM_WORLD,
               place);
  std::ifstream file(place + "/sand_pile.csv");
  std::string   line;
  std::getline(file, line);
  std::getline(file, line);
  std::replace(line.begin(), line.end(), ',', ' ');
  std::istringstream row(line);
  double             time, height, run_out, bulk, slope;
  row >> time >> height >> run_out >> bulk >> slope;
  EXPECT_NEAR(height, 1.4, .01);
  EXPECT_NEAR(run_out, 1.4, 1e-9);
  EXPECT_NEAR(slope, 45., 1e-6);
  EXPECT_NEAR(bulk, 1.4, 1e-9);
  MPI_Barrier(MPI_COMM_WORLD);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::filesystem::remove_all(place);
}
