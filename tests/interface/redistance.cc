// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/interface/redistance.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include "particles/setup.h"
#include "support/dimensions.h"

namespace
{
  using dealii::Point;
  using dealii::Tensor;
  using namespace ParticleTest;
  using Thalweg::Mesh;
  using Thalweg::NodeSpace;
  using Thalweg::Redistance;
  using Thalweg::Vector;

  template <int dim>
  using Scalar = std::function<double(const Point<dim> &)>;

  /// The greatest difference to @p distance at nodes nearer than @p band
  /// after a level set with the values @p level_set was made a distance.
  template <int dim>
  double
  error(const Mesh<dim>   &mesh,
        const Scalar<dim> &level_set,
        const Scalar<dim> &distance,
        const double       band)
  {
    const NodeSpace<dim> space(mesh);
    Vector               phi;
    space.initialize_scalar(phi);
    for (unsigned int n = 0; n < phi.locally_owned_size(); ++n)
      phi.local_element(n) = level_set(space.position(n));
    space.interpolate(phi, 1);
    Redistance<dim>(space).apply(phi);

    double worst = 0;
    for (unsigned int n = 0; n < phi.locally_owned_size(); ++n)
      {
        const double exact = distance(space.position(n));
        if (std::abs(exact) < band)
          worst = std::max(worst, std::abs(phi.local_element(n) - exact));
      }
    return dealii::Utilities::MPI::max(worst, MPI_COMM_WORLD);
  }



  /// A plane that meets walls at angles that are not right.
  template <int dim>
  double
  plane(const Point<dim> &p)
  {
    Tensor<1, dim> normal;
    normal[0]       = -.3;
    normal[dim - 1] = .95;
    if (dim == 3)
      normal[1] = .2;
    normal /= normal.norm();
    return normal * p - .35;
  }



  template <int dim>
  double
  ball_distance(const Point<dim> &p)
  {
    Point<dim> center;
    for (unsigned int d = 0; d < dim; ++d)
      center[d] = .5;
    return p.distance(center) - .27;
  }



  template <typename T>
  class RedistanceMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(RedistanceMpi, Dimensions);
} // namespace



TYPED_TEST(RedistanceMpi, APlaneOfAnySlopeBecomesItsDistance)
{
  constexpr int dim = TypeParam::value;
  Mesh<dim>     mesh(MPI_COMM_WORLD);
  make_box(mesh, 8);
  EXPECT_LT(error<dim>(
              mesh,
              [](const auto &p) { return 7. * plane<dim>(p); },
              plane<dim>,
              1.75 / 8),
            1e-14);
}



TYPED_TEST(RedistanceMpi, APlaneAcrossHangingNodesToo)
{
  constexpr int dim = TypeParam::value;
  Mesh<dim>     mesh(MPI_COMM_WORLD);
  make_box(mesh, 8);
  refine_around(mesh, Point<dim>(), .5);
  EXPECT_LT(error<dim>(
              mesh,
              [](const auto &p) { return .1 * plane<dim>(p); },
              plane<dim>,
              1.75 / 16),
            1e-14);
}



TYPED_TEST(RedistanceMpi, ABallIsMadeRoundToSecondOrder)
{
  // The level set's slope varies by a factor of three along the interface.
  constexpr int dim    = TypeParam::value;
  const auto    skewed = [](const Point<dim> &p) {
    return ball_distance(p) * (1. + .5 * std::sin(4. * p[0] + p[dim - 1]));
  };
  double errors[2];
  for (const unsigned int i : {0, 1})
    {
      Mesh<dim> mesh(MPI_COMM_WORLD);
      make_box(mesh, i == 0 ? 16 : 32);
      errors[i] = error<dim>(mesh, skewed, ball_distance<dim>, .06);
    }
  EXPECT_LT(errors[0], 4e-3);
  EXPECT_LT(errors[1], errors[0] / 2.5);
}



TYPED_TEST(RedistanceMpi, GoesOnAcrossPeriodicBoundaries)
{
  // A plane across the periodic direction, nearest to nodes on the other
  // side of the boundary.
  constexpr int                dim = TypeParam::value;
  dealii::ParameterHandler     prm;
  Thalweg::MeshParameters<dim> parameters;
  parameters.declare(Thalweg::Section(prm));
  prm.parse_input_from_string(
    "subsection Geometry\n set Periodic boundaries = left:right\n"
    "end\nsubsection Refinement\n set Global levels = 3\nend\n");
  Mesh<dim> mesh(MPI_COMM_WORLD);
  mesh.create(parameters);
  const auto distance = [](const Point<dim> &p) {
    const double right = std::abs(p[0] - .95), left = std::abs(p[0] + .05);
    const double other = std::abs(p[0] - .45);
    const double d     = std::min({right, left, other});
    return p[0] > .45 && p[0] < .95 ? -d : d;
  };
  EXPECT_LT(error<dim>(mesh, distance, distance, .21), 1e-14);
}
