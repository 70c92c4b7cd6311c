// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/lagrange_shape.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/fields/vertex_values.h>

#include <cmath>

#include "support/dimensions.h"
#include "support/flow_scene.h"
#include "support/meshes.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class LagrangeSpaceMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(LagrangeSpaceMpi, Dimensions);

  template <typename T>
  class LagrangeShapeOf : public testing::Test
  {};
  TYPED_TEST_SUITE(LagrangeShapeOf, Dimensions);


  /// A box with hanging nodes and periodic sides, cut by them.
  template <int dim>
  std::string
  periodic_box()
  {
    return hanging_box<dim>(4, {"Periodic boundaries = left:right"});
  }


  /// A polynomial of a degree in all directions, periodic in x.
  template <int dim>
  double
  polynomial(const dealii::Point<dim> &p, const unsigned int degree)
  {
    double value = 1.;
    for (unsigned int d = 1; d < dim; ++d)
      value *= 1. + d * p[d] - (degree == 2 ? 2. * p[d] * p[d] : 0.);
    return value;
  }


  /// The sum over owned nodes of the products of entries.
  double
  inner_product(const Vector &a, const Vector &b)
  {
    double sum = 0;
    for (unsigned int i = 0; i < a.locally_owned_size(); ++i)
      sum += a.local_element(i) * b.local_element(i);
    return sum_of_all(sum);
  }


  /// What the rank's cells add at their nodes: numbers without any pattern,
  /// the same on any number of ranks.
  template <int dim>
  Vector
  cell_contributions(const LagrangeSpace<dim> &space,
                     const Vector             &weights,
                     double                   &sum)
  {
    Vector vector;
    space.initialize(vector, dim);
    const auto &graph = space.mesh().graph();
    sum               = 0;
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      for (unsigned int i = 0; i < space.n_nodes_per_cell(); ++i)
        for (unsigned int d = 0; d < dim; ++d)
          {
            const unsigned int entry = dim * space.nodes(c)[i] + d;
            const double       value =
              std::sin(7. * i + d + 50. * graph.iterator(c)->center()[1]);
            vector.local_element(entry) += value;
            sum += value * weights.local_element(entry);
          }
    sum = sum_of_all(sum);
    return vector;
  }
} // namespace



TYPED_TEST(LagrangeShapeOf, IsThatOfFeqInLexicographicOrder)
{
  constexpr int      dim = TypeParam::value;
  dealii::Point<dim> xi;
  for (unsigned int d = 0; d < dim; ++d)
    xi[d] = .3 + .25 * d;
  const auto compare = [&](const auto &shape, const unsigned int degree) {
    const dealii::FE_Q<dim> fe(degree);
    const auto              place = fe.get_poly_space_numbering();
    ASSERT_EQ(shape.size(), fe.n_dofs_per_cell());
    for (unsigned int i = 0; i < place.size(); ++i)
      EXPECT_NEAR(shape[place[i]], fe.shape_value(i, xi), 1e-14);
  };
  compare(LagrangeShape::values<dim, 1>(xi), 1);
  compare(LagrangeShape::values<dim, 2>(xi), 2);
}



TYPED_TEST(LagrangeSpaceMpi, NodesOfACellStandInLexicographicOrder)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(unit_box<dim>(3), Meshes::distort_and_refine<dim>);
  const dealii::MappingQ<dim> mapping(2);
  for (const unsigned int degree : {1u, 2u})
    {
      const LagrangeSpace<dim> space(scene.mesh, degree, mapping);
      for (unsigned int i = 0; i < space.n_nodes_per_cell(); ++i)
        for (unsigned int d = 0, k = i; d < dim; ++d, k /= degree + 1)
          EXPECT_NEAR(space.unit_nodes()[i][d],
                      double(k % (degree + 1)) / degree,
                      1e-14);
      // Cell by cell the positions, as a field of the space.
      const Vector positions =
        nodal_velocity<dim>(space, [](const auto &p) { return p; });
      std::vector<double> cells;
      space.copy_to_cells(positions, cells);
      const auto &graph = scene.mesh.graph();
      for (unsigned int c = 0; c < graph.n_cells(); ++c)
        for (unsigned int i = 0; i < space.n_nodes_per_cell(); ++i)
          {
            const auto p =
              Q1::position<dim>(graph.cell(c).vertices, space.unit_nodes()[i]);
            for (unsigned int d = 0; d < dim; ++d)
              EXPECT_NEAR(cells[(c * space.n_nodes_per_cell() + i) * dim + d],
                          p[d],
                          1e-13);
          }
    }
}



TYPED_TEST(LagrangeSpaceMpi, DependentNodesTakePolynomialsOfTheSpace)
{
  constexpr int               dim = TypeParam::value;
  const Scene<dim>            scene(periodic_box<dim>());
  const dealii::MappingQ<dim> mapping(2);
  for (const unsigned int degree : {1u, 2u})
    {
      const LagrangeSpace<dim> space(scene.mesh, degree, mapping);
      const auto  wanted = [&](const auto &p) { return polynomial(p, degree); };
      Vector      vector = nodal_scalar<dim>(space, wanted);
      const auto &graph  = scene.mesh.graph();
      unsigned int n_dependent = 0;
      for (unsigned int c = 0; c < graph.n_cells(); ++c)
        for (unsigned int i = 0; i < space.n_nodes_per_cell(); ++i)
          {
            const unsigned int node = space.nodes(c)[i];
            n_dependent += space.is_dependent(node);
            EXPECT_NEAR(vector.local_element(node),
                        wanted(Q1::position<dim>(graph.cell(c).vertices,
                                                 space.unit_nodes()[i])),
                        1e-13);
          }
      EXPECT_GT(sum_of_all(n_dependent), 0.);
    }
}



TYPED_TEST(LagrangeSpaceMpi, FoldIsTheTransposeOfInterpolate)
{
  constexpr int               dim = TypeParam::value;
  const Scene<dim>            scene(periodic_box<dim>());
  const dealii::MappingQ<dim> mapping(2);
  for (const unsigned int degree : {1u, 2u})
    {
      const LagrangeSpace<dim> space(scene.mesh, degree, mapping);
      const Vector             field = nodal_velocity<dim>(space, wild<dim>);
      double                   wanted;
      Vector folded = cell_contributions(space, field, wanted);
      space.fold(folded, dim);
      EXPECT_NEAR(inner_product(folded, field), wanted, 1e-11);
      for (const Dependence &entry : space.dependences().all())
        EXPECT_EQ(folded.local_element(dim * entry.node), 0.);
    }
}



TYPED_TEST(LagrangeSpaceMpi, JoinCopiesAddsUpAcrossPeriodicSides)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(
    unit_box<dim>(4, "0", {"Periodic boundaries = left:right, bottom:top"}));
  const dealii::MappingQ<dim> mapping(2);
  for (const unsigned int degree : {1u, 2u})
    {
      const LagrangeSpace<dim> space(scene.mesh, degree, mapping);
      Vector                   count;
      space.initialize(count, 1);
      for (unsigned int c = 0; c < scene.mesh.graph().n_owned_cells(); ++c)
        for (unsigned int i = 0; i < space.n_nodes_per_cell(); ++i)
          count.local_element(space.nodes(c)[i]) += 1.;
      space.dependences().join_copies(count, 1, dealii::VectorOperation::add);
      for_each_owned_node<dim>(
        space, [&](const unsigned int node, const dealii::Point<dim> &p) {
          double wanted = space.is_dependent(node) ? 0. : 1.;
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double x        = 4. * p[d];
              const bool   periodic = d < 2;
              const bool   at_side  = x < 1e-9 || x > 4. - 1e-9;
              if (std::abs(x - std::round(x)) < 1e-9 && (periodic || !at_side))
                wanted *= 2.;
            }
          EXPECT_EQ(count.local_element(node), wanted) << p;
        });
    }
}



TYPED_TEST(LagrangeSpaceMpi, JoinCopiesFindsExtremesAcrossPeriodicSides)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(
    unit_box<dim>(4, "0", {"Periodic boundaries = left:right"}));
  const dealii::MappingQ<dim> mapping(2);
  const LagrangeSpace<dim>    space(scene.mesh, 2, mapping);
  for (const double sign : {1., -1.})
    {
      // The least, or the greatest, x of the centres of the cells around.
      const auto operation =
        sign > 0. ? dealii::VectorOperation::min : dealii::VectorOperation::max;
      Vector extreme;
      space.initialize(extreme, 1);
      for (unsigned int n = 0; n < space.dependences().n_nodes(); ++n)
        extreme.local_element(n) = sign * 1e10;
      for (unsigned int c = 0; c < scene.mesh.graph().n_owned_cells(); ++c)
        for (unsigned int i = 0; i < space.n_nodes_per_cell(); ++i)
          {
            const double x     = scene.mesh.graph().iterator(c)->center()[0];
            double      &value = extreme.local_element(space.nodes(c)[i]);
            value = sign > 0. ? std::min(value, x) : std::max(value, x);
          }
      space.dependences().join_copies(extreme, 1, operation);
      FlowScene<dim>::for_each_free_node(
        space, [&](const unsigned int node, const auto &p) {
          const bool at_side = p[0] < 1e-9 || p[0] > 1. - 1e-9;
          const bool at_line =
            std::abs(4. * p[0] - std::round(4. * p[0])) < 1e-9;
          const double centre = (std::floor(4. * p[0] + 1e-9) + .5) / 4.;
          const double wanted = at_side   ? .5 - sign * .375
                                : at_line ? (sign > 0. ? centre - .25 : centre)
                                          : centre;
          EXPECT_NEAR(extreme.local_element(node), wanted, 1e-14) << p;
        });
    }
}



TYPED_TEST(LagrangeSpaceMpi, VertexValuesAreThoseOfTheField)
{
  static constexpr int        dim = TypeParam::value;
  Scene<dim>                  scene(hanging_box<dim>(4));
  const dealii::MappingQ<dim> mapping(2);
  for (const unsigned int degree : {1u, 2u})
    {
      const LagrangeSpace<dim> space(scene.mesh, degree, mapping);
      Vector                   velocity =
        scene.velocity([](const auto &) { return dealii::Tensor<1, dim>(); });
      Vector scalar = scene.scalar([](const auto &) { return 0.; });
      copy_to_vertices(space,
                       nodal_velocity<dim>(space, wild<dim>),
                       *scene.space,
                       velocity,
                       dim);
      copy_to_vertices(space,
                       nodal_scalar<dim>(space,
                                         [](const auto &p) {
                                           return std::sin(9. * p[0] * p[1]);
                                         }),
                       *scene.space,
                       scalar,
                       1);
      scene.for_each_node([&](const unsigned int n, const auto &p) {
        for (unsigned int d = 0; d < dim; ++d)
          EXPECT_NEAR(scene.at(velocity, n)[d], wild(p)[d], 1e-13);
        EXPECT_NEAR(scalar.local_element(n), std::sin(9. * p[0] * p[1]), 1e-13);
      });
      // Ghosts and hanging nodes follow.
      Vector again = velocity;
      scene.space->interpolate(again, dim);
      for (unsigned int i = 0;
           i < dim * scene.space->scalar_layout().n_ghost_indices();
           ++i)
        EXPECT_EQ(again.local_element(again.locally_owned_size() + i),
                  velocity.local_element(velocity.locally_owned_size() + i));
    }
}
