// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "support/flow_scene.h"
#include "support/run_case.h"

namespace
{
  using Lines = std::vector<std::string>;


  /// The method with these settings, and those of the l2 projection.
  std::string
  method(const Lines &settings = {}, const Lines &projection = {})
  {
    return section(
      "Method",
      {"Model = single fluid pfem2"},
      section("single fluid pfem2",
              settings,
              section("Projection", {}, section("l2", projection))));
  }

  /// Tolerances of which nothing is seen.
  const Lines tight{"Pressure tolerance = 1e-12", "Velocity tolerance = 1e-13"};
  const Lines tight_projection{"Tolerance = 1e-13"};

  Lines
  operator+(Lines a, const Lines &b)
  {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  std::string
  time_steps(const double dt, const double end)
  {
    return section("Time",
                   {"Time step = " + std::to_string(dt),
                    "End time = " + std::to_string(end)});
  }

  std::string
  starts_with(const std::string &velocity)
  {
    return section("Initial conditions", {"Velocity = " + velocity});
  }


  /// The mean square error of the velocity at the end of a run.
  template <int dim, typename Function>
  double
  velocity_error(const RunCase<dim> &run, const Function &exact)
  {
    const auto &flow = *run.simulation->view().flow("").flow;
    return mean_square_error(flow.velocity_dofs,
                             flow.mapping,
                             flow.velocity,
                             exact);
  }

  template <int dim, typename Function>
  double
  pressure_error(const RunCase<dim> &run, const Function &exact)
  {
    const auto &flow = *run.simulation->view().flow("").flow;
    return mean_square_error(flow.pressure_dofs,
                             flow.mapping,
                             flow.pressure,
                             exact);
  }


  const double nu = .01;

  /// Decaying vortices in a periodic box.
  std::string
  vortices(const unsigned int n, const double dt, const double end)
  {
    return unit_box<2>(n,
                       "0",
                       {"Periodic boundaries = left:right, bottom:top"}) +
           time_steps(dt, end) + one_fluid(1., nu) +
           starts_with("sin(2*pi*x)*cos(2*pi*y); -cos(2*pi*x)*sin(2*pi*y)");
  }

  double
  vortex_error(const RunCase<2> &run, const double time)
  {
    const double k      = 2. * dealii::numbers::PI;
    const double factor = std::exp(-2. * k * k * nu * time);
    return velocity_error(run, [&](const auto &p) {
      dealii::Tensor<1, 2> u;
      u[0] = factor * std::sin(k * p[0]) * std::cos(k * p[1]);
      u[1] = -factor * std::cos(k * p[0]) * std::sin(k * p[1]);
      return u;
    });
  }


  /// A fluid between plates that moves up to Fourier numbers of 50.
  std::string
  between_plates(const std::string &velocity,
                 const std::string &top,
                 const std::string &force,
                 const std::string &theta,
                 const unsigned int degree)
  {
    return unit_box<2>(4,
                       "if(y < 0.5, 1, 0)",
                       {"Periodic boundaries = left:right"}) +
           method(tight + Lines{"Viscous theta = " + theta,
                                "Velocity degree = " + std::to_string(degree)},
                  tight_projection) +
           // nu dt / h^2 = 50 with h = 1/8
           time_steps(50. / 64., 10. * 50. / 64.) + one_fluid(1., 1.) +
           section("Body forces", {"Force density = " + force + "; 0"}) +
           section("Boundary conditions",
                   {"No slip = bottom", "Velocity = top: " + top + "; 0"}) +
           starts_with(velocity + "; 0");
  }
} // namespace



TEST(SingleFluid, ErrorsOfVorticesFallWithTheSquareOfTheCells)
{
  const auto error = [](const unsigned int n) {
    return vortex_error(RunCase<2>(vortices(n, .01, .1) + method()), .1);
  };
  const double coarse = error(16), fine = error(32);
  EXPECT_LT(fine, .005);
  EXPECT_GT(std::log2(coarse / fine), 1.9);
}



TEST(SingleFluid, ErrorsOfVorticesFallWithTheSquareOfTheStep)
{
  // On elements of degree 2 the mesh hardly counts. All steps are made once.
  const auto error = [](const double dt) {
    return vortex_error(RunCase<2>(
                          vortices(16, dt, .8) +
                          method({"Velocity degree = 2",
                                  "Pressure degree = 2",
                                  "Maximal corrector iterations = 0"})),
                        .8);
  };
  const double coarse = error(.2), fine = error(.1);
  EXPECT_LT(fine, .005);
  EXPECT_GT(std::log2(coarse / fine), 1.9);
}



TEST(SingleFluid, StepsAreMadeAgainWhereThePredictionFailed)
{
  const auto run = [](const std::string &setting) {
    return RunCase<2>(
      vortices(16, .2, .8) +
      method({"Velocity degree = 2", "Pressure degree = 2", setting}));
  };
  const RunCase<2> corrected = run("Corrector tolerance = 1e-9");
  const RunCase<2> once      = run("Maximal corrector iterations = 0");
  EXPECT_EQ(corrected.last("passes"), 2.);
  EXPECT_EQ(once.last("passes"), 1.);
  EXPECT_GT(once.last("prediction error"), 1e-3);
  EXPECT_LT(vortex_error(corrected, .8), .5 * vortex_error(once, .8));
}



TEST(SingleFluid, ImpulsiveStartsOnCoarseMeshesAreSurvived)
{
  // Steps that are made once reach velocities of 1.1 m/s here.
  const RunCase<2> run(
    section("Geometry", {"Model = cylinder in channel"}) +
    section("Refinement", {"Global levels = 1"}) +
    section("Time",
            {"Courant number = 5", "First step = 0.001", "End time = 0.6"}) +
    section("Particles",
            {"Particles per direction = 4",
             "Minimum per cell = 10",
             "Maximum per cell = 32"}) +
    one_fluid(1., .001) +
    method({"Velocity degree = 2", "Pressure degree = 2"}) +
    section("Boundary conditions",
            {"No slip = bottom, top, cylinder",
             "Velocity = left: 4*0.3*y*(0.41 - y)/0.41^2; 0",
             "Open = right: 0"}));
  EXPECT_LT(run.last("max velocity 1 [m/s]"), .6);
}



TEST(SingleFluid, UniformFlowStaysUniform)
{
  // Courant number 10.
  for (const std::string &conditions :
       {section("Boundary conditions",
                {"Velocity = left: 1; 0.5 | bottom: 1; 0.5",
                 "Open = right: 0 | top: 0"}),
        section("Boundary conditions",
                {"Velocity = left: 1; 0.5 | bottom: 1; 0.5 | right: 1; 0.5 | "
                 "top: 1; 0.5"})})
    for (const std::string degrees :
         {"Velocity degree = 1", "Velocity degree = 2"})
      {
        const RunCase<2> run(hanging_box<2>(4) +
                             method(tight + Lines{degrees}, tight_projection) +
                             time_steps(1.25, 12.5) + one_fluid(2., .1) +
                             conditions + starts_with("1; 0.5"));
        EXPECT_GT(run.last("Courant number"), 9.9);
        EXPECT_LT(velocity_error(run,
                                 [](const auto &) {
                                   dealii::Tensor<1, 2> u;
                                   u[0] = 1.;
                                   u[1] = .5;
                                   return u;
                                 }),
                  1e-10);
        EXPECT_LT(pressure_error(run, [](const auto &) { return 0.; }), 1e-9);
      }
}



TEST(SingleFluid, CouettesFlowIsSteadyAtAnyFourierNumber)
{
  for (const std::string theta : {"0.5", "1"})
    for (const unsigned int degree : {1u, 2u})
      {
        const RunCase<2> run(between_plates("y", "1", "0", theta, degree));
        EXPECT_NEAR(run.last("Fourier number"), 50., 1e-3);
        EXPECT_LT(velocity_error(run,
                                 [](const auto &p) {
                                   dealii::Tensor<1, 2> u;
                                   u[0] = p[1];
                                   return u;
                                 }),
                  1e-8)
          << theta << ' ' << degree;
      }
}



TEST(SingleFluid, PoiseuillesFlowIsSteadyAtAnyFourierNumber)
{
  for (const std::string theta : {"0.5", "1"})
    {
      const RunCase<2> run(between_plates("y*(1-y)", "0", "2", theta, 2));
      EXPECT_LT(velocity_error(run,
                               [](const auto &p) {
                                 dealii::Tensor<1, 2> u;
                                 u[0] = p[1] * (1. - p[1]);
                                 return u;
                               }),
                1e-8)
        << theta;
    }
}



TEST(SingleFluid, TrapezoidalViscosityIsStableAtFourierNumber100)
{
  const auto error = [](const unsigned int n_steps) {
    const double      dt    = 100. / 256.; // nu dt / h^2 = 100, h = 1/16
    const std::string noise = "0.1*sin(16*pi*x)*sin(7*pi*y)";
    const RunCase<2>  run(
      unit_box<2>(16, "0", {"Periodic boundaries = left:right"}) +
      method({"Viscous theta = 0.5"}) + time_steps(dt, n_steps * dt) +
      one_fluid(1., 1.) + section("Body forces", {"Force density = 8; 0"}) +
      section("Boundary conditions", {"No slip = bottom, top"}) +
      starts_with("4*y*(1-y) + " + noise + "; 0.1*sin(12*pi*x)*sin(12*pi*y)"));
    return velocity_error(run, [](const auto &p) {
      dealii::Tensor<1, 2> u;
      u[0] = 4. * p[1] * (1. - p[1]);
      return u;
    });
  };
  EXPECT_LT(error(50), error(1));
}



TEST(SingleFluid, WaterAtRestStaysAtRest)
{
  for (const std::string degrees :
       {"Velocity degree = 1", "Velocity degree = 2"})
    {
      const RunCase<2> run(hanging_box<2>(4) + method(tight + Lines{degrees}) +
                           time_steps(.1, .5) + one_fluid(1000., .001) +
                           section("Body forces", {"Gravity = 0, -9.81"}) +
                           section("Boundary conditions", {"Open = top: 5"}));
      EXPECT_LT(velocity_error(
                  run, [](const auto &) { return dealii::Tensor<1, 2>(); }),
                1e-10);
      EXPECT_LT(pressure_error(
                  run, [](const auto &p) { return 5. + 9810. * (1. - p[1]); }),
                1e-5);
    }
}



TEST(SingleFluid, ElementsOfDegreeTwoFollowVortices)
{
  for (const auto &[pressure, bound] :
       {std::make_pair("Pressure degree = 1", .02),
        std::make_pair("Pressure degree = 2", .01)})
    {
      const RunCase<2> run(
        vortices(8, .05, .5) +
        section("Particles", {"Particles per direction = 4"}) +
        method({"Velocity degree = 2", pressure}, {"Regularization = 0.1"}));
      EXPECT_LT(vortex_error(run, .5), bound) << pressure;
    }
}



namespace
{
  /// Every process also runs the case alone; both must agree.
  template <int dim>
  void
  compare_flow_with_one_process(const std::string &text)
  {
    const RunCase<dim> together(text), alone(text, MPI_COMM_SELF);
    for (const std::string column :
         {"kinetic energy [J]", "max velocity 1 [m/s]"})
      EXPECT_NEAR(together.last(column),
                  alone.last(column),
                  1e-8 * std::abs(alone.last(column)))
        << column;
    EXPECT_EQ(together.last("particles"), alone.last("particles"));
    EXPECT_EQ(together.last("particles lost"), 0.);
  }

  /// A lid drives the fluid in a box with hanging nodes.
  template <int dim>
  std::string
  hanging_cavity(const unsigned int n, const Lines &settings)
  {
    return hanging_box<dim>(n) + method(tight + settings, tight_projection) +
           time_steps(.1, .5) + one_fluid(1., .01) +
           section("Boundary conditions",
                   {"Otherwise = no slip",
                    "Velocity = top: 16*x^2*(1-x)^2; 0" +
                      std::string(dim == 3 ? "; 0" : "")});
  }
} // namespace



TEST(SingleFluidMpi, RanksAgree)
{
  compare_flow_with_one_process<2>(hanging_cavity<2>(6, {}));
  compare_flow_with_one_process<2>(
    hanging_cavity<2>(6, {"Explicit pressure = incremental"}));
  compare_flow_with_one_process<2>(
    hanging_cavity<2>(4, {"Velocity degree = 2"}));
}



TEST(SingleFluidMpi, RanksAgree3d)
{
  compare_flow_with_one_process<3>(hanging_cavity<3>(3, {}));
}



TEST(SingleFluidMpi, RanksAgreeInPeriodicBoxes)
{
  compare_flow_with_one_process<2>(
    vortices(8, .05, .2) + method(tight, tight_projection) +
    section("Refinement", {"Local levels = if(x + y < 0.9, 1, 0)"}));
}



TEST(SingleFluid, TwoRunsAgreeToTheLastBit)
{
  const std::string text = hanging_cavity<2>(6, {});
  const RunCase<2>  first(text), second(text);
  for (const std::string column :
       {"kinetic energy [J]", "max velocity 1 [m/s]", "particles"})
    EXPECT_EQ(first.last(column), second.last(column)) << column;
}
