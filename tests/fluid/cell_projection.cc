// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/q1_integrals.h>
#include <thalweg/fluid/cell_projection.h>
#include <thalweg/fluid/nodal_mass.h>
#include <thalweg/fluid/pressure_system.h>

#include <cmath>

#include "support/dimensions.h"
#include "support/meshes.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class CellProjectionMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(CellProjectionMpi, Dimensions);


  /// Water and air on a mesh, and what the projection stands on.
  template <int dim>
  struct Projected
  {
    Projected(const std::string                     &settings,
              const typename Scene<dim>::MeshChange &change = {})
      : scene(settings + two_fluids(1000., 1.), change)
      , pressure(*scene.space, *scene.boundary, *scene.phase, scene.forces)
      , mass(*scene.space, *scene.boundary, *scene.phase)
      , projection(*scene.space, *scene.boundary, mass, pressure)
    {
      scene.set_phases(
        [](const auto &x) { return x[dim - 1] - .43 + .2 * x[0]; });
      pressure.assemble();
      mass.update();
    }

    /// Of all cells the greatest int_K div V.
    double
    greatest_outflow(const Vector &velocity) const
    {
      const Q1Integrals<dim> integrals;
      const auto            &graph   = scene.mesh.graph();
      double                 largest = 0;
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        {
          const auto gradients = integrals.gradient_integrals(graph.cell(c));
          double     sum       = 0;
          for (unsigned int v = 0; v < gradients.size(); ++v)
            sum += gradients[v] * scene.at(velocity, scene.space->nodes(c)[v]);
          largest = std::max(largest, std::abs(sum));
        }
      return max_of_all(largest);
    }

    /// Forces on the nodes that depend on no others.
    template <typename Function>
    Vector
    force(const Function &function) const
    {
      Vector force = scene.velocity(function);
      force.zero_out_ghost_values();
      for (unsigned int n = 0; n < force.locally_owned_size() / dim; ++n)
        if (scene.space->is_dependent(n))
          for (unsigned int d = 0; d < dim; ++d)
            force.local_element(dim * n + d) = 0.;
      return force;
    }

    Vector
    caused_by(Vector force) const
    {
      mass.invert(force);
      return force;
    }

    double
    energy(const Vector &velocity) const
    {
      double sum = 0;
      scene.for_each_node([&](const unsigned int n, const auto &) {
        sum += .5 * mass.lumped().local_element(n) *
               scene.at(velocity, n).norm_square();
      });
      return sum_of_all(sum);
    }

    Scene<dim>          scene;
    PressureSystem<dim> pressure;
    NodalMass<dim>      mass;
    CellProjection<dim> projection;
  };


  /// With divergence, and along the walls of the unit box.
  template <int dim>
  dealii::Tensor<1, dim>
  rough(const dealii::Point<dim> &x)
  {
    dealii::Tensor<1, dim> u;
    for (unsigned int d = 0; d < dim; ++d)
      u[d] = std::sin(dealii::numbers::PI * x[d]) *
             std::cos(5. * x[(d + 1) % dim] + 7. * d);
    return u;
  }


  template <int dim>
  dealii::Tensor<1, dim>
  uniform(const dealii::Point<dim> &)
  {
    dealii::Tensor<1, dim> u;
    u[0] = 2.;
    return u;
  }
} // namespace



TYPED_TEST(CellProjectionMpi, NothingIsLeftOfTheOutflowOfACell)
{
  constexpr int dim = TypeParam::value;
  const std::vector<std::pair<std::string, typename Scene<dim>::MeshChange>>
    meshes{{unit_box<dim>(6), {}},
           {hanging_box<dim>(4), {}},
           {hanging_box<dim>(4, {"Periodic boundaries = left:right"}), {}},
           {unit_box<dim>(4), Meshes::distort_and_refine<dim>},
           {hanging_box<dim>(4) +
              section("Boundary conditions", {"Open = top: 0"}),
            {}}};
  for (unsigned int m = 0; m < meshes.size(); ++m)
    {
      Projected<dim> p(meshes[m].first, meshes[m].second);
      Vector         v = p.scene.velocity(rough<dim>);
      p.scene.boundary->apply(v);
      p.scene.space->interpolate(v, dim);
      const double outflow = p.greatest_outflow(v), energy = p.energy(v);
      const auto   report = p.projection.project(v, 1e-9, 2000);
      EXPECT_LT(p.greatest_outflow(v), 1e-6 * outflow) << m;
      EXPECT_LT(p.energy(v), energy) << m;
      EXPECT_LT(report.residual, 1e-3) << m;
      Vector fixed = v;
      p.scene.boundary->apply(fixed);
      fixed.add(-1., v);
      EXPECT_LT(fixed.linfty_norm(), 1e-14) << m;
    }
}



TYPED_TEST(CellProjectionMpi, ItIsAnOrthogonalOne)
{
  // In the kinetic energy of velocities that forces f and g cause,
  // V = M^{-1} f, whose product is f M^{-1} g.
  constexpr int  dim = TypeParam::value;
  Projected<dim> p(hanging_box<dim>(4));
  const Vector   f = p.force(rough<dim>);
  const Vector g = p.force([](const auto &x) { return x[0] * rough<dim>(x); });
  const Vector of_f = p.caused_by(f), of_g = p.caused_by(g);
  const auto   project = [&](Vector v) {
    v.update_ghost_values();
    p.projection.project(v, 1e-9, 2000);
    return v;
  };
  const double whole = f * of_f, left = f * project(of_f);
  EXPECT_GT(left, 0.);
  EXPECT_LT(left, .99 * whole);
  EXPECT_NEAR(f * project(of_g), g * project(of_f), 1e-6 * whole);
}



TYPED_TEST(CellProjectionMpi, AUniformFlowIsLeftAlone)
{
  constexpr int     dim   = TypeParam::value;
  const std::string other = dim == 3 ? "; 0" : "";
  Projected<dim>    p(unit_box<dim>(4) + section("Boundary conditions",
                                              {"Velocity = left: 2; 0" + other +
                                                  " | right: 2; 0" + other}),
                   Meshes::distort_and_refine<dim>);
  Vector            v      = p.scene.velocity(uniform<dim>);
  const auto        report = p.projection.project(v, 1e-2, 100);
  EXPECT_EQ(report.iterations, 0u);
  p.scene.for_each_node([&](const unsigned int n, const auto &x) {
    EXPECT_EQ((p.scene.at(v, n) - uniform<dim>(x)).norm(), 0.) << x;
  });
}



TYPED_TEST(CellProjectionMpi, FewIterationsDoWhateverTheDensities)
{
  constexpr int dim = TypeParam::value;
  unsigned int  iterations[2];
  for (const unsigned int level : {0, 1})
    {
      Projected<dim> p(unit_box<dim>((dim == 2 ? 12 : 4) << level));
      Vector         v  = p.scene.velocity(rough<dim>);
      iterations[level] = p.projection.project(v, 1e-2, 100).iterations;
    }
  EXPECT_LT(iterations[0], 25u);
  EXPECT_LT(iterations[1], iterations[0] + 10);
}



// Velocities that are given all around may ask for outflows that no velocity
// inside has: what can be taken away is.
TEST(CellProjectionMpi3d, EndsWhereGivenVelocitiesDoNotFit)
{
  const std::string flow =
    "sin(3*x)*cos(3*y)*cos(3*z); cos(3*x)*sin(3*y)*cos(3*z); "
    "-2*cos(3*x)*cos(3*y)*sin(3*z)";
  Projected<3> projected(
    hanging_box<3>(4) +
    section("Boundary conditions", {"Velocity = " + on_all_sides<3>(flow)}));
  Vector velocity;
  projected.scene.space->initialize_velocity(velocity);
  projected.scene.boundary->apply(velocity);
  projected.scene.space->interpolate(velocity, 3);
  const double before = projected.greatest_outflow(velocity);
  projected.projection.project(velocity, 1e-2, 1000);
  EXPECT_LT(projected.greatest_outflow(velocity), before);
}
