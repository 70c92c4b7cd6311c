// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>

#include "support/dimensions.h"
#include "support/meshes.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class BoundaryNodesMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(BoundaryNodesMpi, Dimensions);

  constexpr double near = 1e-9;

  /// No slip on the left, a velocity on the right, open at the top, slip
  /// elsewhere.
  template <int dim>
  std::string
  all_kinds()
  {
    return section("Boundary conditions",
                   {"No slip = left",
                    std::string("Velocity = right: y*(1-y); 2*t") +
                      (dim == 3 ? "; 3" : ""),
                    "Open = top: 10*x"});
  }


  template <int dim>
  dealii::Tensor<1, dim>
  ones()
  {
    dealii::Tensor<1, dim> one;
    for (unsigned int d = 0; d < dim; ++d)
      one[d] = 1.;
    return one;
  }
} // namespace



TYPED_TEST(BoundaryNodesMpi, EachKindSetsWhatItShouldAlsoInCorners)
{
  constexpr int dim = TypeParam::value;
  Scene<dim>    scene(hanging_box<dim>(4) + all_kinds<dim>());
  scene.conditions->set_time(.5);
  Vector velocity = scene.velocity([](const auto &) { return ones<dim>(); });
  scene.boundary->apply(velocity);
  scene.for_each_node([&](const unsigned int n, const auto &p) {
    auto expected = ones<dim>();
    if (p[1] < near)
      expected[1] = 0.;
    if (dim == 3 && (p[2] < near || p[2] > 1. - near))
      expected[2] = 0.;
    if (p[0] < near)
      expected = 0.;
    if (p[0] > 1. - near)
      {
        expected[0] = p[1] * (1. - p[1]);
        expected[1] = 1.;
        if (dim == 3)
          expected[2] = 3.;
      }
    EXPECT_NEAR((scene.at(velocity, n) - expected).norm(), 0., 1e-14) << p;
  });
}



TYPED_TEST(BoundaryNodesMpi, ProjectTakesOutOnlyWhatIsFixed)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(hanging_box<dim>(4) + all_kinds<dim>());
  Vector velocity = scene.velocity([](const auto &) { return ones<dim>(); });
  scene.boundary->project(velocity);
  Vector twice = velocity;
  scene.boundary->project(twice);
  twice -= velocity;
  EXPECT_NEAR(twice.l2_norm(), 0., 1e-15);
  scene.for_each_node([&](const unsigned int n, const auto &p) {
    const auto u = scene.at(velocity, n);
    if (p[0] < near || p[0] > 1. - near)
      {
        EXPECT_EQ(u.norm(), 0.);
      }
    else if (!on_side_of_unit_box<dim>(p))
      {
        EXPECT_EQ((u - ones<dim>()).norm(), 0.);
      }
  });
}



TYPED_TEST(BoundaryNodesMpi, AVelocityWinsOverNoSlip)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(
    unit_box<dim>(4) +
    section("Boundary conditions",
            {"No slip = left, right, bottom",
             std::string("Velocity = top: 1; 0") + (dim == 3 ? "; 0" : "")}));
  Vector velocity = scene.velocity([](const auto &) { return ones<dim>(); });
  scene.boundary->apply(velocity);
  scene.for_each_node([&](const unsigned int n, const auto &p) {
    if (p[1] > 1. - near)
      {
        EXPECT_EQ(scene.at(velocity, n)[0], 1.) << p;
      }
    else if (p[0] < near || p[0] > 1. - near)
      {
        EXPECT_EQ(scene.at(velocity, n).norm(), 0.) << p;
      }
  });
}



TYPED_TEST(BoundaryNodesMpi, SlipWallsMeetInCornersOfOneBoundaryToo)
{
  // All sides of this box have one name.
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(
    section("Geometry",
            {"Model = generator"},
            section("generator",
                    {"Function = hyper_cube", "Arguments = 0 : 1 : false"})) +
    section("Refinement", {"Global levels = 2"}));
  Vector velocity = scene.velocity([](const auto &) { return ones<dim>(); });
  scene.boundary->apply(velocity);
  scene.for_each_node([&](const unsigned int n, const auto &p) {
    for (unsigned int d = 0; d < dim; ++d)
      EXPECT_NEAR(scene.at(velocity, n)[d],
                  p[d] < near || p[d] > 1. - near ? 0. : 1.,
                  1e-14)
        << p;
  });
}



TYPED_TEST(BoundaryNodesMpi, EdgesOfObstaclesAreFreeButForTheFloor)
{
  constexpr int     dim = TypeParam::value;
  const std::string z   = dim == 3 ? ", 0.25" : "";
  const Scene<dim>  scene(
    section("Geometry",
            {"Model = box with obstacles"},
            section("box with obstacles",
                    {"Cell size = 0.25",
                      "Obstacles = 0.25, 0" + z + " : 0.75, 0.5" +
                        (dim == 3 ? ", 0.75" : "")})));
  Vector velocity = scene.velocity([](const auto &) { return ones<dim>(); });
  scene.boundary->project_slip(velocity);
  const auto at_side = [](const auto &p, const unsigned int d) {
    return std::abs(p[d] - .25) < near || std::abs(p[d] - .75) < near;
  };
  const auto within = [](const auto &p, const unsigned int d) {
    return p[d] > .25 - near && p[d] < .75 + near;
  };
  scene.for_each_node([&](const unsigned int n, const auto &p) {
    // The faces of the obstacle that meet in the node.
    const bool beside =
      p[1] < .5 + near && within(p, 0) && (dim == 2 || within(p, dim - 1));
    const bool x     = beside && at_side(p, 0);
    const bool z     = beside && dim == 3 && at_side(p, dim - 1);
    const bool top   = beside && p[1] > .5 - near;
    const bool sharp = x + z + top > 1;
    const auto u     = scene.at(velocity, n);
    for (unsigned int d = 0; d < dim; ++d)
      {
        const bool outer = p[d] < near || p[d] > 1. - near;
        const bool inner = !sharp && (d == 0 ? x : d == 1 ? top : z);
        EXPECT_NEAR(u[d], outer || inner ? 0. : 1., 1e-14) << p;
      }
  });
}



TYPED_TEST(BoundaryNodesMpi, SlipIsProjectedAtSlipWallsOnly)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(hanging_box<dim>(4) + all_kinds<dim>());
  Vector velocity = scene.velocity([](const auto &) { return ones<dim>(); });
  scene.boundary->project_slip(velocity);
  scene.for_each_node([&](const unsigned int n, const auto &p) {
    auto       expected = ones<dim>();
    const bool sticks   = p[0] < near || p[0] > 1. - near;
    if (p[1] < near && !sticks)
      expected[1] = 0.;
    if (dim == 3 && (p[2] < near || p[2] > 1. - near) && !sticks)
      expected[2] = 0.;
    EXPECT_NEAR((scene.at(velocity, n) - expected).norm(), 0., 1e-14) << p;
  });
}



TEST(BoundaryNodesMpi, CurvedSlipWallsLeaveTheTangentialVelocity)
{
  const Scene<2> scene(
    section("Geometry",
            {"Model = generator"},
            section("generator",
                    {"Function = hyper_shell",
                     "Arguments = 0, 0 : 1 : 2 : 12 : true"})) +
    section("Refinement", {"Global levels = 2"}));
  const auto turn = [](const dealii::Point<2> &p) {
    return dealii::Tensor<1, 2>({-p[1] + p[0], p[0] + p[1]});
  };
  Vector velocity = scene.velocity(turn);
  scene.boundary->project(velocity);
  unsigned int n_walls = 0;
  scene.for_each_node([&](const unsigned int n, const auto &p) {
    const bool wall = p.norm() < 1. + near || p.norm() > 2. - near;
    n_walls += wall;
    const auto expected = wall ? dealii::Tensor<1, 2>({-p[1], p[0]}) : turn(p);
    EXPECT_NEAR((scene.at(velocity, n) - expected).norm(), 0., 1e-12) << p;
  });
  EXPECT_EQ(dealii::Utilities::MPI::sum(n_walls, MPI_COMM_WORLD), 96u);
}



TYPED_TEST(BoundaryNodesMpi, OpenNodesAreThoseOfTheBoundary)
{
  constexpr int     dim = TypeParam::value;
  const Scene<dim>  scene(hanging_box<dim>(4) + all_kinds<dim>());
  std::vector<bool> is_open(scene.space->scalar_layout().locally_owned_size(),
                            false);
  for (const auto &node : scene.boundary->pressure_nodes())
    {
      EXPECT_NEAR(node.position[1], 1., near);
      EXPECT_EQ(node.id, scene.mesh.boundary_id("top"));
      EXPECT_NEAR((node.normal - dealii::Point<dim>::unit_vector(1)).norm(),
                  0.,
                  near);
      if (node.node < is_open.size())
        is_open[node.node] = true;
    }
  scene.for_each_node([&](const unsigned int n, const auto &p) {
    EXPECT_EQ(is_open[n], p[1] > 1. - near) << p;
  });
}



TYPED_TEST(BoundaryNodesMpi, FluxThroughGivenVelocitiesIsThatOfTheNodes)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(hanging_box<dim>(4) + all_kinds<dim>());
  Vector           flux;
  scene.space->initialize_scalar(flux);
  Vector velocity;
  scene.space->initialize_velocity(velocity);
  scene.boundary->apply(velocity);
  scene.space->interpolate(velocity, dim);
  scene.boundary->add_flux(velocity, -3., flux);
  scene.space->fold(flux, 1);
  // The trapezoidal rule for the integral of y (1 - y) over sides of h = 1/4
  // and 1/8 misses h^2/12 times their lengths' sum, times the factor.
  const double sum = flux.mean_value() * flux.size();
  EXPECT_GT(sum, -3. * (1. / 6. - 1. / 12. / 64.) - 1e-13);
  EXPECT_LT(sum, -3. * (1. / 6. - 1. / 6. / 16.) + 1e-13);
}



TYPED_TEST(BoundaryNodesMpi, NormalsOfPassableFacesPointOutward)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(unit_box<dim>(4) + all_kinds<dim>(),
                         Meshes::distort_and_refine<dim>);
  std::map<dealii::types::boundary_id, dealii::Tensor<1, dim>> sums;
  for (const auto &face : scene.boundary->passable_faces())
    for (const auto &normal : face.normals_times_weight)
      sums[face.id] += normal;
  const auto area = [&](const std::string &name) {
    dealii::Tensor<1, dim> sum = sums[scene.mesh.boundary_id(name)];
    return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  };
  const auto right = area("right"), top = area("top");
  EXPECT_NEAR((right - dealii::Point<dim>::unit_vector(0)).norm(), 0., 1e-13);
  EXPECT_NEAR((top - dealii::Point<dim>::unit_vector(1)).norm(), 0., 1e-13);
  EXPECT_EQ(area("left").norm() + area("bottom").norm(), 0.);
}
