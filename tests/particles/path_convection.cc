// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "particles/path_setup.h"

using namespace ParticleTest;
using Thalweg::WallKind;

namespace
{
  /// A box with hanging nodes, whose cells are distorted or not.
  template <int dim>
  void
  make_hanging_mesh(Thalweg::Mesh<dim> &mesh, const bool distorted)
  {
    make_box(mesh, 4);
    Point<dim> corner = middle_of_box<dim>();
    corner[0]         = 0.2;
    refine_around(mesh, corner, 0.35);
    if (distorted)
      distort(mesh, 0.05);
  }

  /// The greatest error of position and velocity after a turn by six radians
  /// in one step, at Courant numbers above 10, with an angular velocity that
  /// changes linearly from 2 to 10 1/s and an acceleration of the same values.
  template <int dim>
  std::array<double, 2>
  rotation_errors(const Thalweg::Mesh<dim> &mesh,
                  const std::string        &integrator,
                  const double              courant,
                  const unsigned int        degree)
  {
    const Point<dim>         center = middle_of_box<dim>();
    Thalweg::Population<dim> population(mesh);
    seed_plain(population, 2);
    const auto before = all_states(population);

    const Field<dim>                   turn   = rotation<dim>(center);
    const auto                         fields = path_fields<dim>(mesh,
                                         degree,
                                         times<dim>(2., turn),
                                         times<dim>(10., turn),
                                         times<dim>(2., turn),
                                         times<dim>(10., turn));
    const Thalweg::PathConvection<dim> convection(mesh,
                                                  substeps(integrator, courant),
                                                  {});
    const auto                         report =
      convection.move(population, fields, 1.).sum(MPI_COMM_WORLD);
    EXPECT_EQ(report.n_lost, 0u);
    EXPECT_LE(inconsistency(population), 1e-12);

    // the acceleration is the velocity: what is gained is the way
    std::array<double, 2> worst{};
    for (const auto &[id, after] : all_states(population))
      if (const auto &p = before.at(id).position; p.distance(center) < 0.35)
        {
          const auto exact = rotated(p, center, 6.);
          worst[0]         = std::max(worst[0], after.position.distance(exact));
          worst[1] = std::max(worst[1], (after.velocity - (exact - p)).norm());
        }
    return worst;
  }

  template <int dim>
  void
  check_orders(const bool distorted, const unsigned int degree)
  {
    Thalweg::Mesh<dim> mesh(MPI_COMM_WORLD);
    make_hanging_mesh(mesh, distorted);
    const double coarse     = distorted ? 0.25 : 0.5;
    const auto   rk2_coarse = rotation_errors(mesh, "rk2", 0.25, degree);
    const auto   rk2_fine   = rotation_errors(mesh, "rk2", 0.0625, degree);
    const auto   rk4_coarse = rotation_errors(mesh, "rk4", coarse, degree);
    const auto   rk4_fine   = rotation_errors(mesh, "rk4", coarse / 4, degree);
    for (unsigned int i = 0; i < 2; ++i)
      {
        EXPECT_GE(std::log(rk2_coarse[i] / rk2_fine[i]) / std::log(4.), 1.9);
        EXPECT_GE(std::log(rk4_coarse[i] / rk4_fine[i]) / std::log(4.), 3.7);
        EXPECT_LE(rk4_fine[i], 1e-5);
      }
  }

  /// V = rotation and a = V.grad V: a particle keeps the velocity of the
  /// field.
  template <int dim>
  void
  keep_velocity(const bool distorted)
  {
    Thalweg::Mesh<dim> mesh(MPI_COMM_WORLD);
    make_hanging_mesh(mesh, distorted);
    const Point<dim> center = middle_of_box<dim>();
    const Field<dim> turn   = rotation<dim>(center);
    const Field<dim> inward = [turn, center](const Point<dim> &p) {
      return turn(center + turn(p));
    };
    Thalweg::Population<dim> population(mesh);
    seed_plain(population, 2);
    set_velocity<dim>(population, turn);
    const auto before = all_states(population);
    const auto fields = path_fields<dim>(mesh, 2, turn, turn, inward, inward);
    const Thalweg::PathConvection<dim> convection(mesh,
                                                  substeps("rk4", 0.1),
                                                  {});
    convection.move(population, fields, 2.);
    for (const auto &[id, after] : all_states(population))
      if (before.at(id).position.distance(center) < 0.4)
        {
          EXPECT_LE((after.velocity - turn(after.position)).norm(), 1e-6);
        }
  }

  /// Uniform flow with an acceleration A x + t b, against closed forms.
  template <int dim>
  void
  accelerate_linearly(const unsigned int degree, const bool distorted)
  {
    Thalweg::Mesh<dim> mesh(MPI_COMM_WORLD);
    make_hanging_mesh(mesh, distorted);
    // a straight path is curved in the coordinates of distorted cells
    const double             tolerance = distorted ? 5e-6 : 1e-9;
    Thalweg::Population<dim> population(mesh);
    seed_plain(population, 2);
    const auto     before = all_states(population);
    Tensor<1, dim> v, b;
    Tensor<2, dim> A;
    for (unsigned int d = 0; d < dim; ++d)
      {
        v[d] = 0.2 + 0.3 * d;
        b[d] = 1. - 0.4 * d;
        for (unsigned int e = 0; e < dim; ++e)
          A[d][e] = 0.5 * d - 0.3 * e + 0.7;
      }
    const double     dt    = 0.4;
    const Field<dim> begin = [&](const Point<dim> &p) {
      return A * Tensor<1, dim>(p);
    };
    const Field<dim> end = [&](const Point<dim> &p) {
      return A * Tensor<1, dim>(p) + dt * b;
    };
    const auto fields = path_fields<dim>(
      mesh, degree, constant<dim>(v), constant<dim>(3. * v), begin, end);
    const Thalweg::PathConvection<dim> convection(
      mesh, substeps("rk4", 0.5), {{1, WallKind::open}, {3, WallKind::open}});
    convection.move(population, fields, dt);

    unsigned int n_compared = 0;
    for (const auto &[id, after] : all_states(population))
      {
        const Point<dim> p     = before.at(id).position;
        const Point<dim> exact = p + 2. * dt * v;
        if (exact[dim - 1] > 1. - 1e-6)
          continue;
        ++n_compared;
        EXPECT_LE(after.position.distance(exact), tolerance);
        // the way is v t + v t^2 / dt
        const Tensor<1, dim> gain =
          A * (Tensor<1, dim>(p) * dt + v * (dt * dt * (1. / 2. + 1. / 3.))) +
          0.5 * dt * dt * b;
        EXPECT_LE((after.velocity - gain).norm(), tolerance);
      }
    EXPECT_GT(n_compared, 10u);
  }

  /// A flow along x that is parabolic in y and in z.
  template <int dim>
  void
  follow_parabola(const bool refined)
  {
    Thalweg::Mesh<dim> mesh(MPI_COMM_WORLD);
    make_box(mesh, 3);
    make_periodic(mesh);
    if (refined)
      refine_around(mesh, middle_of_box<dim>(), 0.3);
    Thalweg::Population<dim> population(mesh);
    seed_plain(population, 3, 0.7);
    const auto       before   = all_states(population);
    const Field<dim> parabola = [](const Point<dim> &p) {
      Tensor<1, dim> u;
      u[0] = p[1] * p[1];
      if (dim == 3)
        u[0] += p[dim - 1] * (p[1] - p[dim - 1]);
      return u;
    };
    const auto fields =
      path_fields<dim>(mesh, 2, parabola, parabola, parabola, parabola);
    const Thalweg::PathConvection<dim> convection(mesh, {}, {});
    convection.move(population, fields, 10.);
    for (const auto &[id, after] : all_states(population))
      {
        const Tensor<1, dim> way   = 10. * parabola(before.at(id).position);
        Point<dim>           exact = before.at(id).position + way;
        exact[0] -= std::floor(exact[0]);
        EXPECT_LE(std::abs(std::remainder(after.position[0] - exact[0], 1.)),
                  1e-10);
        EXPECT_NEAR(after.position[1], exact[1], 1e-12);
        EXPECT_LE((after.velocity - way).norm(), 1e-10);
      }
  }
} // namespace


TEST(PathConvectionMpi, UnsteadyRotationHasTheOrderOfTheScheme)
{
  check_orders<2>(false, 1);
  check_orders<2>(false, 2);
  check_orders<3>(false, 2);
}


TEST(PathConvectionMpi, UnsteadyRotationOnDistortedCells)
{
  check_orders<2>(true, 1);
  check_orders<2>(true, 2);
  check_orders<3>(true, 1);
}


TEST(PathConvectionMpi, InviscidFlowKeepsItsVelocity)
{
  keep_velocity<2>(false);
  keep_velocity<2>(true);
  keep_velocity<3>(false);
}


TEST(PathConvectionMpi, LinearAccelerationAlongAStraightPath)
{
  accelerate_linearly<2>(1, false);
  accelerate_linearly<2>(2, true);
  accelerate_linearly<3>(1, true);
  accelerate_linearly<3>(2, false);
}


TEST(PathConvectionMpi, ParabolicFlowIsExact)
{
  follow_parabola<2>(false);
  follow_parabola<2>(true);
  follow_parabola<3>(true);
}


TEST(PathConvectionMpi, SteadyFieldsOfDegreeOneGoLikeStreamlines)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_hanging_mesh(mesh, false);
  const Field<2> field = [](const Point<2> &p) {
    return Tensor<1, 2>({std::sin(9. * p[1]), std::cos(7. * p[0])});
  };
  Thalweg::Population<2> streamline(mesh), path(mesh);
  seed_plain(streamline, 3, 0.5);
  seed_plain(path, 3, 0.5);
  const auto velocity = nodal<2>(mesh, field);
  const auto zero     = constant<2>({});
  const auto fields   = path_fields<2>(mesh, 1, field, field, zero, zero);
  const Thalweg::StreamlineConvection<2> streamlines(mesh, {}, {});
  const Thalweg::PathConvection<2>       paths(mesh, {}, {});
  const auto a = streamlines.move(streamline, velocity, 1.);
  const auto b = paths.move(path, fields, 1.);
  EXPECT_EQ(a.n_substeps, b.n_substeps);
  EXPECT_EQ(a.n_cells_crossed, b.n_cells_crossed);
  const auto expected = all_positions(streamline);
  for (const auto &[id, p] : all_positions(path))
    EXPECT_LE(p.distance(expected.at(id)), 1e-11);
}


TEST(PathConvectionMpi, UndefinedFieldsAreCountedAsLost)
{
  for (const bool in_acceleration : {false, true})
    {
      Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
      make_box(mesh, 4);
      Thalweg::Population<2> population(mesh);
      seed_plain(population, 2);
      const auto     zero = constant<2>({});
      const Field<2> bad  = [](const Point<2> &p) {
        return Tensor<1, 2>(
          {p.norm() < 0.1 ? std::numeric_limits<double>::quiet_NaN() : 0., 0.});
      };
      const auto                       fields = in_acceleration
                                                  ? path_fields<2>(mesh, 1, zero, zero, bad, zero)
                                                  : path_fields<2>(mesh, 1, zero, bad, zero, zero);
      const Thalweg::PathConvection<2> convection(mesh, {}, {});
      const auto                       report =
        convection.move(population, fields, 0.1).sum(MPI_COMM_WORLD);
      EXPECT_EQ(report.n_lost, 4u);
      EXPECT_EQ(population.n_global_particles(), 60u);
    }
}


TEST(PathConvection, OtherDegreesAreRefused)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 2);
  Thalweg::Population<2>           population(mesh);
  const Thalweg::PathConvection<2> convection(mesh, {}, {});
  Thalweg::PathFields<2>           fields;
  fields.degree = 3;
  EXPECT_THROW(convection.move(population, fields, 0.1), dealii::ExceptionBase);
  EXPECT_THROW(convection.trace_back({}, {}, fields, 0.1),
               dealii::ExceptionBase);
}
