// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/flow_boundary.h>

#include "support/dimensions.h"
#include "support/flow_scene.h"
#include "support/meshes.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class FlowBoundaryMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(FlowBoundaryMpi, Dimensions);


  bool
  is(const double x, const double wanted)
  {
    return std::abs(x - wanted) < 1e-9;
  }


  template <int dim>
  std::string
  components(const std::string &first, const std::string &others)
  {
    return first + "; " + others + (dim == 3 ? "; " + others : "");
  }


  /// Inflow at the left, outflow at the right, a belt at the top, a slip
  /// wall at the bottom (and at front and back).
  template <int dim>
  std::string
  tunnel()
  {
    return hanging_box<dim>(3) +
           section(
             "Boundary conditions",
             {"Velocity = left: " + components<dim>("(1 + t) * y", "0.1") +
                " | top: " + components<dim>("7", "0"),
              "Open = right: 4 + y + t",
              "Slip = bottom" + std::string(dim == 3 ? ", front, back" : "")});
  }


  /// The values after @p action on ones, at all free nodes.
  template <int dim, typename Action, typename Visitor>
  void
  after(const FlowScene<dim> &scene, const Action &action, const Visitor &visit)
  {
    Vector u = scene.flow_velocity([](const auto &) {
      dealii::Tensor<1, dim> ones;
      for (unsigned int d = 0; d < dim; ++d)
        ones[d] = 1.;
      return ones;
    });
    action(u);
    unsigned int n_visited = 0;
    scene.for_each_free_node(scene.V, [&](const unsigned int n, const auto &p) {
      visit(scene.at(u, n), p);
      ++n_visited;
    });
    EXPECT_GT(sum_of_all(n_visited), 0.);
  }
} // namespace



TYPED_TEST(FlowBoundaryMpi, NodesOfAnyDegreeTakeTheirGivenValues)
{
  static constexpr int dim = TypeParam::value;
  for (const auto &[k, l] : degree_pairs())
    {
      const FlowScene<dim> scene(tunnel<dim>(), k, l);
      scene.conditions->set_time(2.);
      after(
        scene,
        [&](Vector &u) { scene.flow_boundary.apply(u); },
        [](const auto &u, const auto &p) {
          dealii::Tensor<1, dim> wanted;
          for (unsigned int d = 0; d < dim; ++d)
            wanted[d] = 1.;
          if (is(p[1], 1.) && !is(p[0], 0.))
            {
              wanted    = dealii::Tensor<1, dim>();
              wanted[0] = 7.;
            }
          else if (is(p[0], 0.) && !is(p[1], 1.))
            {
              for (unsigned int d = 1; d < dim; ++d)
                wanted[d] = .1;
              wanted[0] = 3. * p[1];
            }
          else if (!is(p[0], 0.))
            {
              if (is(p[1], 0.))
                wanted[1] = 0.;
              if (dim == 3 && (is(p[dim - 1], 0.) || is(p[dim - 1], 1.)))
                wanted[dim - 1] = 0.;
            }
          else
            return; // where two velocities are given
          EXPECT_NEAR((u - wanted).norm(), 0., 1e-13) << p;
        });
    }
}



TYPED_TEST(FlowBoundaryMpi, ProjectionsRemoveWhatIsFixed)
{
  constexpr int        dim = TypeParam::value;
  const FlowScene<dim> scene(tunnel<dim>(), 2, 1);
  after(
    scene,
    [&](Vector &u) { scene.flow_boundary.project(u); },
    [](const auto &u, const auto &p) {
      if (is(p[0], 0.) || is(p[1], 1.))
        {
          EXPECT_EQ(u.norm(), 0.) << p;
        }
      else
        {
          EXPECT_EQ(u[0], 1.) << p;
          EXPECT_NEAR(u[1], is(p[1], 0.) ? 0. : 1., 1e-13) << p;
          if (dim == 3)
            {
              EXPECT_NEAR(u[dim - 1],
                          is(p[dim - 1], 0.) || is(p[dim - 1], 1.) ? 0. : 1.,
                          1e-13)
                << p;
            }
        }
    });
}



TYPED_TEST(FlowBoundaryMpi, FluidAcceleratesWhereItPassesABoundary)
{
  constexpr int        dim = TypeParam::value;
  const FlowScene<dim> scene(tunnel<dim>(), 2, 1);
  scene.conditions->set_time(0.);
  after(
    scene,
    [&](Vector &u) { scene.flow_boundary.project_acceleration(u); },
    [](const auto &u, const auto &p) {
      if (is(p[0], 0.) && (is(p[1], 0.) || is(p[1], 1.)))
        return;
      if (is(p[1], 1.))
        EXPECT_EQ(u.norm(), 0.) << p; // the belt, along which it slides
      else if (is(p[0], 0.))
        EXPECT_NEAR(u.norm(), std::sqrt(dim), 1e-13) << p;
      else
        {
          EXPECT_EQ(u[0], 1.) << p;
          EXPECT_NEAR(u[1], is(p[1], 0.) ? 0. : 1., 1e-13) << p;
        }
    });
}



TYPED_TEST(FlowBoundaryMpi, OpenBoundariesHaveTheirPressure)
{
  constexpr int dim = TypeParam::value;
  for (const auto &[k, l] : degree_pairs())
    {
      const FlowScene<dim> scene(tunnel<dim>(), k, l);
      scene.conditions->set_time(.5);
      Vector p       = scene.flow_pressure([](const auto &) { return 1.; });
      Vector removed = p;
      scene.flow_boundary.apply_open(p, .1);
      scene.flow_boundary.project_open(removed);
      unsigned int n_open = 0;
      scene.for_each_free_node(
        scene.P, [&](const unsigned int n, const auto &x) {
          const bool open = is(x[0], 1.);
          n_open += open;
          EXPECT_NEAR(p.local_element(n), open ? .1 * (4.5 + x[1]) : 1., 1e-13);
          EXPECT_EQ(removed.local_element(n), open ? 0. : 1.);
        });
      EXPECT_EQ(n_open, scene.flow_boundary.open_nodes().size());
      EXPECT_GT(sum_of_all(n_open), 0.);
    }
}



TEST(NodeDemand, TheStrictestConditionHolds)
{
  dealii::Tensor<1, 2> x, y;
  x[0] = 2.;
  y[1] = 1.;
  NodeDemand<2> demand;
  demand.add(1, BoundaryKind::open, x, y);
  EXPECT_EQ(demand.kind, BoundaryKind::open);
  demand.add(2, BoundaryKind::slip, y, x);
  EXPECT_EQ(demand.kind, BoundaryKind::slip);
  demand.add(3, BoundaryKind::velocity, x, y);
  demand.add(4, BoundaryKind::no_slip, y, x);
  EXPECT_EQ(demand.kind, BoundaryKind::velocity);
  EXPECT_EQ(demand.boundary, 3u);
}



namespace
{
  /// A node where a wall with the normal x meets one whose normal is turned
  /// by @p angle: in a corner, or in an edge that sticks out.
  NodeDemand<2>
  two_walls(const double                     angle,
            const dealii::types::boundary_id other,
            const bool                       sticks_out)
  {
    dealii::Tensor<1, 2> first, second, along_first, along_second;
    first[0]           = 1.;
    along_first[1]     = -1.;
    second[0]          = std::cos(angle);
    second[1]          = std::sin(angle);
    along_second[0]    = -second[1];
    along_second[1]    = second[0];
    const double  sign = sticks_out ? -1. : 1.;
    NodeDemand<2> demand;
    demand.add(1, BoundaryKind::slip, first, sign * along_first);
    demand.add(other, BoundaryKind::slip, second, sign * along_second);
    return demand;
  }
} // namespace



TEST(NodeDemand, FacesOfASmoothWallHaveOneNormal)
{
  for (const bool sticks_out : {false, true})
    {
      const auto smooth = two_walls(.3, 1, sticks_out).fixed_directions();
      ASSERT_EQ(smooth.size(), 1u);
      EXPECT_NEAR(smooth[0][0], std::cos(.15), 1e-14);
      EXPECT_NEAR(smooth[0][1], std::sin(.15), 1e-14);
      EXPECT_EQ(two_walls(0., 2, sticks_out).fixed_directions().size(), 1u);
      EXPECT_EQ(two_walls(.3, 2, sticks_out).fixed_directions().size(), 1u);
    }
  EXPECT_EQ(two_walls(1.5, 1, false).fixed_directions().size(), 2u);
  EXPECT_EQ(two_walls(1.5, 2, false).fixed_directions().size(), 2u);
}



TEST(NodeDemand, AnEdgeThatSticksOutFixesNothing)
{
  for (const dealii::types::boundary_id other : {1, 2})
    {
      NodeDemand<2> edge = two_walls(1.5, other, true);
      EXPECT_TRUE(edge.is_free());
      EXPECT_FALSE(two_walls(1.5, other, false).is_free());
      FixedNodes<2> nodes;
      nodes.add(0, edge);
      EXPECT_TRUE(nodes.all().empty());
      // Where the fluid sticks to one of the walls it does.
      dealii::Tensor<1, 2> normal;
      normal[1] = 1.;
      edge.add(3, BoundaryKind::no_slip, normal, normal);
      EXPECT_FALSE(edge.is_free());
    }
}
