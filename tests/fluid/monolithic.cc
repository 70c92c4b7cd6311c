// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "fluid/solver_scene.h"
#include "support/complaint.h"
#include "support/dimensions.h"
#include "support/meshes.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class MonolithicMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(MonolithicMpi, Dimensions);

  /// On one process: the blocks beside the interface are inverted by each
  /// process for itself.
  template <typename T>
  class Monolithic1 : public testing::Test
  {};
  TYPED_TEST_SUITE(Monolithic1, Dimensions);

  constexpr double mu = .3;

  /// A flow of Stokes' equations, (0.3 friction) in the unit box.
  template <int dim>
  dealii::Tensor<1, dim>
  eddies(const dealii::Point<dim> &x)
  {
    dealii::Tensor<1, dim> u;
    if (dim == 2)
      {
        u[0] = std::sin(3. * x[0]) * std::cos(3. * x[1]);
        u[1] = -std::cos(3. * x[0]) * std::sin(3. * x[1]);
      }
    else
      {
        u[0] = std::sin(3. * x[0]) * std::cos(3. * x[1]) * std::cos(3. * x[2]);
        u[1] = std::cos(3. * x[0]) * std::sin(3. * x[1]) * std::cos(3. * x[2]);
        u[2] =
          -2. * std::cos(3. * x[0]) * std::cos(3. * x[1]) * std::sin(3. * x[2]);
      }
    return u;
  }

  template <int dim>
  double
  eddy_pressure(const dealii::Point<dim> &x)
  {
    return std::cos(2. * x[0]) * std::sin(3. * x[dim - 1]);
  }

  /// The flow as expressions.
  template <int dim>
  std::string
  eddies_as_text()
  {
    if (dim == 2)
      return "sin(3*x)*cos(3*y); -cos(3*x)*sin(3*y)";
    return "sin(3*x)*cos(3*y)*cos(3*z); cos(3*x)*sin(3*y)*cos(3*z); "
           "-2*cos(3*x)*cos(3*y)*sin(3*z)";
  }

  /// Conditions and forces with which it is steady.
  template <int dim>
  std::string
  eddy_case()
  {
    const std::string factor = std::to_string(mu * 9. * dim) + "*";
    std::string       force;
    if (dim == 2)
      force = factor + "sin(3*x)*cos(3*y) - 2*sin(2*x)*sin(3*y); -" + factor +
              "cos(3*x)*sin(3*y) + 3*cos(2*x)*cos(3*y)";
    else
      force = factor + "sin(3*x)*cos(3*y)*cos(3*z) - 2*sin(2*x)*sin(3*z); " +
              factor + "cos(3*x)*sin(3*y)*cos(3*z); -2*" + factor +
              "cos(3*x)*cos(3*y)*sin(3*z) + 3*cos(2*x)*cos(3*z)";
    return section("Boundary conditions",
                   {"Velocity = " + on_all_sides<dim>(eddies_as_text<dim>())}) +
           section("Body forces", {"Force density = " + force});
  }
} // namespace



TYPED_TEST(MonolithicMpi, SteadyStokesFlowsConverge)
{
  constexpr int dim = TypeParam::value;
  double        errors[2][2];
  for (const unsigned int level : {0, 1})
    {
      SolverScene<dim> scene(unit_box<dim>((dim == 2 ? 16 : 8) << level) +
                               one_fluid(1., mu) + eddy_case<dim>(),
                             "monolithic");
      scene.initialize();
      scene.find_steady_flow();
      errors[level][0] = scene.velocity_error(eddies<dim>);
      errors[level][1] = scene.pressure_error(eddy_pressure<dim>);
      EXPECT_LE(scene.context.statistics.get("coupled iterations"), 40.);
    }
  EXPECT_GT(std::log2(errors[0][0] / errors[1][0]), 1.9);
  EXPECT_GT(std::log2(errors[0][1] / errors[1][1]), .9);
  EXPECT_LT(errors[1][0], dim == 2 ? 1e-3 : 1e-2);
}



TYPED_TEST(MonolithicMpi, SolversAndStabilizationsAgree)
{
  const auto run = [](const std::string &settings) {
    constexpr int    dim = TypeParam::value;
    SolverScene<dim> scene(
      hanging_box<dim>(dim == 2 ? 8 : 4) + two_fluids(10., 1., 1., .1) +
        section("Body forces",
                {dim == 2 ? "Gravity = 0, -1" : "Gravity = 0, 0, -1"}),
      "monolithic",
      "set Tolerance = 1e-11\n" + settings);
    scene.initialize(
      [](const dealii::Point<dim> &x) { return x[dim - 1] - .43 + .3 * x[0]; });
    scene.step(scene.velocity(eddies<dim>), .1);
    double sum = 0.;
    scene.for_each_node([&](const unsigned int n, const auto &x) {
      sum += scene.at(scene.solver->velocity(), n) * x;
    });
    return sum_of_all(sum);
  };
  const double reference = run(section("Velocity block", {"Model = direct"}));
  for (const char *name : {"jacobi", "amg", "ilu"})
    EXPECT_NEAR(run(
                  section("Velocity block", {"Model = " + std::string(name)})),
                reference,
                1e-6 * std::abs(reference))
      << name;
  EXPECT_NEAR(run(section("Pressure block", {"Model = laplace"}) +
                  "set Maximal linear iterations = 3000\n"),
              reference,
              1e-6 * std::abs(reference));
  for (const char *name : {"pspg", "fic"})
    EXPECT_NEAR(run(section("Stabilization", {"Model = " + std::string(name)})),
                reference,
                .3 * std::abs(reference))
      << name;
}



TYPED_TEST(Monolithic1, NeedsFewIterationsWhateverTheFluids)
{
  constexpr int dim = TypeParam::value;
  for (const auto &[rho, mu_1, mu_2] : {std::make_tuple(1., 1., 1.),
                                        std::make_tuple(1., 1e6, 1.),
                                        std::make_tuple(1., 1., 1e6),
                                        std::make_tuple(1000., 1e-3, 1e-5),
                                        std::make_tuple(1000., 1e3, 1e-3)})
    for (const double dt : {1e-3, .1})
      {
        SolverScene<dim> scene(unit_box<dim>(dim == 2 ? 16 : 6) +
                                 two_fluids(rho, 1., mu_1, mu_2) +
                                 section("Body forces",
                                         {dim == 2 ? "Gravity = 0, -9.81"
                                                   : "Gravity = 0, 0, -9.81"}),
                               "monolithic");
        scene.initialize([](const dealii::Point<dim> &x) {
          return x[dim - 1] - .613 + .3 * x[0];
        });
        scene.step(scene.velocity(eddies<dim>), dt);
        EXPECT_LE(scene.context.statistics.get("coupled iterations"), 40.)
          << rho << " " << mu_1 << " " << mu_2 << " " << dt;
      }
}



// Layers of two viscosities, both moved by a force along them: exact at the
// nodes, however different they are.
TEST(MonolithicMpi2d, SteadyLayersOfTwoViscositiesAreExactAtTheNodes)
{
  for (const double ratio : {1., 1e3, 1e6})
    {
      SolverScene<2> scene(
        unit_box<2>(15, "0", {"Periodic boundaries = left:right"}) +
          two_fluids(1., 1., ratio, 1.) +
          section("Body forces", {"Force density = 1; 0"}) +
          section("Boundary conditions", {"No slip = bottom, top"}),
        "monolithic",
        "set Tolerance = 1e-12\n");
      scene.initialize([](const auto &x) { return x[1] - .5; });
      scene.find_steady_flow();
      // stress s_0 - y, velocity zero at the walls and the same at y = 1/2
      const double s = (.125 / ratio + .375) / (.5 / ratio + .5);
      EXPECT_LT(scene.velocity_error([&](const auto &x) {
        dealii::Tensor<1, 2> u;
        const double         y = x[1];
        u[0]                   = y < .5 ? (s * y - .5 * y * y) / ratio
                                        : s * (y - 1.) - .5 * (y * y - 1.);
        return u;
      }),
                2e-3);
    }
}



namespace
{
  /// Fluids 10:1 that are stretched along the surface between them and
  /// squeezed across it, given all around: n is the normal.
  template <int dim>
  struct Extension
  {
    Extension(const double angle, const double offset)
      : offset(offset)
    {
      n[0]       = std::sin(angle);
      n[dim - 1] = std::cos(angle);
    }

    double
    level_set(const dealii::Point<dim> &x) const
    {
      return n * x - offset;
    }

    /// In each direction along the surface alike.
    dealii::Tensor<1, dim>
    velocity(const dealii::Point<dim> &x) const
    {
      return (x - dim * (n * x) * n) / (dim - 1.);
    }

    std::string
    text() const
    {
      std::string scalar = "(", result;
      for (unsigned int d = 0; d < dim; ++d)
        scalar += (d == 0 ? "" : "+") + std::string(1, "xyz"[d]) + "*(" +
                  std::to_string(n[d]) + ")";
      scalar += ")";
      for (unsigned int d = 0; d < dim; ++d)
        result += (d == 0 ? "" : "; ") + std::string("(") + "xyz"[d] + "-" +
                  std::to_string(dim) + "*" + scalar + "*(" +
                  std::to_string(n[d]) + "))/" + std::to_string(dim - 1);
      return result;
    }

    /// The greatest error of the velocity at the nodes.
    double
    error(const unsigned int n_cells, const std::string &enrichment) const
    {
      SolverScene<dim> scene(
        unit_box<dim>(n_cells) + two_fluids(1., 1., 10., 1.) +
          section("Interface", {"Enrichment = " + enrichment}) +
          section("Boundary conditions",
                  {"Velocity = " + on_all_sides<dim>(text())}),
        "monolithic",
        "set Tolerance = 1e-10\n");
      scene.initialize([this](const auto &x) { return level_set(x); });
      scene.find_steady_flow();
      return scene.velocity_error(
        [this](const auto &x) { return velocity(x); });
    }

    dealii::Tensor<1, dim> n;
    double                 offset;
  };
} // namespace



// The pressure jumps by 2 (mu_1 - mu_2) du_n/dn. (Here no side has less than a
// thousandth of a cell.)
TYPED_TEST(MonolithicMpi, StretchedFluidsNeedAPressureThatJumps)
{
  constexpr int        dim = TypeParam::value;
  const Extension<dim> flat(0., .53), oblique(dim == 2 ? .1 : .3, .53);
  const unsigned int   n = dim == 2 ? 10 : 8;
  EXPECT_LT(flat.error(n, "discontinuous"), 1e-8);
  EXPECT_LT(oblique.error(n, "discontinuous"), 1e-5);
  EXPECT_GT(oblique.error(n, "gradient"), 5e-3);
}



TEST(MonolithicMpi2d, JumpsAreSafeWhereverAFlatInterfaceIs)
{
  for (unsigned int i = 0; i < 40; ++i)
    EXPECT_LT(Extension<2>(0., .4 + i / 400.).error(10, "discontinuous"), 1e-2)
      << i;
}



TEST(Monolithic, RefusesJumpsAtHangingNodes)
{
  SolverScene<2> scene(hanging_box<2>(4) + two_fluids(10., 1., 1., .1) +
                         section("Interface", {"Enrichment = discontinuous"}),
                       "monolithic");
  scene.initialize([](const auto &x) { return x[1] - .43; });
  const auto complaint = complaint_of([&]() { scene.find_steady_flow(); });
  EXPECT_NE(complaint.find("passes a cell with a hanging node"),
            std::string::npos);
}
