// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/interpolation.h>

#include <cmath>

#include "support/dimensions.h"
#include "support/meshes.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class NodeSpaceMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(NodeSpaceMpi, Dimensions);

  /// Hanging nodes that meet periodic boundaries.
  template <int dim>
  std::string
  periodic_hanging_box()
  {
    return hanging_box<dim>(4, {"Periodic boundaries = left:right"});
  }


  /// Some number that differs from entry to entry and from rank to rank.
  double
  arbitrary(const unsigned int entry)
  {
    const unsigned int rank =
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    return std::sin(1. + 1.7 * entry + 0.3 * rank);
  }


  /// <interpolate(x), y> over the nodes of the ranks' own cells, to which
  /// they add, minus <x, fold(y)> over owned nodes.
  template <int dim>
  double
  defect(const NodeSpace<dim> &space, const unsigned int n_components)
  {
    Vector x, y;
    for (Vector *vector : {&x, &y})
      n_components == 1 ? space.initialize_scalar(*vector)
                        : space.initialize_velocity(*vector);
    for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
      x.local_element(i) = arbitrary(i);
    space.interpolate(x, n_components);
    double difference = 0;
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      for (const unsigned int node : space.nodes(c))
        for (unsigned int d = 0; d < n_components; ++d)
          {
            const unsigned int i     = n_components * node + d;
            const double       added = arbitrary(i + 1000 * c);
            y.local_element(i) += added;
            difference += x.local_element(i) * added;
          }
    space.fold(y, n_components);
    for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
      difference -= x.local_element(i) * y.local_element(i);
    return sum_of_all(difference);
  }
} // namespace



TYPED_TEST(NodeSpaceMpi, FoldIsTheTransposeOfInterpolate)
{
  constexpr int dim = TypeParam::value;
  for (const std::string &box :
       {hanging_box<dim>(4), periodic_hanging_box<dim>()})
    {
      const Scene<dim> scene(box);
      EXPECT_NEAR(defect(*scene.space, 1), 0., 1e-11);
      EXPECT_NEAR(defect(*scene.space, dim), 0., 1e-11);
    }
}



TYPED_TEST(NodeSpaceMpi, InterpolatesLinearFunctionsAtHangingNodes)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> bent(unit_box<dim>(4), Meshes::distort_and_refine<dim>);
  const Scene<dim> periodic(periodic_hanging_box<dim>());
  for (const Scene<dim> *scene : {&bent, &periodic})
    {
      const auto linear = [&](const dealii::Point<dim> &p) {
        return 1. + (scene == &bent ? p[0] : 0.) + 2. * p[dim - 1];
      };
      Vector values;
      scene->space->initialize_scalar(values);
      scene->for_each_node([&](const unsigned int n, const auto &p) {
        values.local_element(n) = linear(p);
      });
      scene->space->interpolate(values, 1);
      CellField<dim, 1> cells;
      scene->space->copy_to_cells(values, cells);
      for (unsigned int c = 0; c < scene->mesh.graph().n_owned_cells(); ++c)
        for (unsigned int v = 0; v < (1u << dim); ++v)
          ASSERT_NEAR(cells[c][v],
                      linear(scene->mesh.graph().cell(c).vertices[v]),
                      1e-12);
    }
}



TYPED_TEST(NodeSpaceMpi, JoinsPeriodicNodesAndLeavesTheOthers)
{
  constexpr int      dim = TypeParam::value;
  const unsigned int n   = 4;
  for (const std::string pairs : {"", "left:right", "left:right, bottom:top"})
    {
      const Scene<dim> scene(
        unit_box<dim>(n, "0", {"Periodic boundaries = " + pairs}));
      unsigned int n_nodes = 0;
      scene.for_each_node([&](const unsigned int, const auto &) { ++n_nodes; });
      const unsigned int n_periodic = scene.mesh.periodic_pairs().size();
      EXPECT_EQ(dealii::Utilities::MPI::sum(n_nodes, MPI_COMM_WORLD),
                std::pow(n, n_periodic) * std::pow(n + 1, dim - n_periodic))
        << pairs;
    }
}



TYPED_TEST(NodeSpaceMpi, TellsHangingNodesFromPeriodicOnes)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(periodic_hanging_box<dim>());
  const auto      &space     = *scene.space;
  unsigned int     n_hanging = 0;
  for (unsigned int n = 0; n < space.scalar_layout().locally_owned_size(); ++n)
    {
      const auto [first, last] = space.hanging_masters(n);
      double weights           = 0;
      for (unsigned int k = first; k < last; ++k)
        {
          EXPECT_EQ(space.dependences().all()[k].node, n);
          weights += space.dependences().all()[k].weight;
        }
      if (first < last)
        {
          ++n_hanging;
          EXPECT_TRUE(space.is_dependent(n));
          EXPECT_NEAR(weights, 1., 1e-14);
        }
    }
  EXPECT_GT(dealii::Utilities::MPI::sum(n_hanging, MPI_COMM_WORLD), 0u);
}



TYPED_TEST(NodeSpaceMpi, FunctionsAreInterpolatedAtAllNodes)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(hanging_box<dim>(4));
  class Linear : public dealii::Function<dim>
  {
  public:
    Linear()
      : dealii::Function<dim>(dim)
    {}

    double
    value(const dealii::Point<dim> &p, const unsigned int c) const override
    {
      return c + 2. * p[c] - p[0];
    }
  };
  Vector velocity;
  scene.space->initialize_velocity(velocity);
  interpolate_function(*scene.space, Linear(), velocity);
  for (unsigned int c = 0; c < scene.mesh.graph().n_owned_cells(); ++c)
    for (unsigned int v = 0; v < (1u << dim); ++v)
      for (unsigned int d = 0; d < dim; ++d)
        ASSERT_NEAR(velocity.local_element(dim * scene.space->nodes(c)[v] + d),
                    Linear().value(scene.mesh.graph().cell(c).vertices[v], d),
                    1e-13);
}



TYPED_TEST(NodeSpaceMpi, HangingNodesOfGhostCellsHaveTheirValuesToo)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(periodic_hanging_box<dim>());
  const auto       linear = [](const dealii::Point<dim> &p) {
    return 1. + 2. * p[dim - 1];
  };
  Vector values;
  scene.space->initialize_scalar(values);
  scene.for_each_node([&](const unsigned int n, const auto &p) {
    values.local_element(n) = linear(p);
  });
  scene.space->interpolate(values, 1);
  for (unsigned int c = scene.mesh.graph().n_owned_cells();
       c < scene.mesh.graph().n_cells();
       ++c)
    for (unsigned int v = 0; v < (1u << dim); ++v)
      EXPECT_NEAR(values.local_element(scene.space->nodes(c)[v]),
                  linear(scene.mesh.graph().cell(c).vertices[v]),
                  1e-12);
}
