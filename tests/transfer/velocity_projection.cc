// SPDX-License-Identifier: LGPL-2.1-or-later
#include "particle_scene.h"
#include "support/dimensions.h"

using namespace ParticleScenes;

namespace
{
  template <typename T>
  class VelocityProjectionMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(VelocityProjectionMpi, Dimensions);

  template <typename T>
  class MovingLeastSquaresMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(MovingLeastSquaresMpi, Dimensions);

  template <typename T>
  class VelocityIncrementMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(VelocityIncrementMpi, Dimensions);
} // namespace



TYPED_TEST(MovingLeastSquaresMpi, ReproducesLinearFields)
{
  constexpr int               dim = TypeParam::value;
  const dealii::MappingQ<dim> mapping(2);
  const auto mls = make<dim>("moving least squares", "set Limiter = false");
  for (const auto &scene : {bent<dim>(), periodic<dim>()})
    {
      const bool is_periodic = !scene->mesh.periodic_pairs().empty();
      const auto linear      = [&](const auto &p) {
        auto q = p;
        if (is_periodic)
          q[0] = 1.;
        return dealii::Tensor<1, dim>(some_matrix<dim>() * q);
      };
      fill(*scene, .6);
      set_particles(*scene, linear);
      for (const unsigned int degree : {1u, 2u})
        {
          const LagrangeSpace<dim> space(scene->mesh, degree, mapping);
          EXPECT_LT(difference(project(*scene, space, *mls),
                               nodal_velocity<dim>(space, linear)),
                    1e-11)
            << degree;
        }
    }
}



TYPED_TEST(MovingLeastSquaresMpi, TheLimiterKeepsToTheParticles)
{
  constexpr int               dim = TypeParam::value;
  const dealii::MappingQ<dim> mapping(2);
  const auto                  scene = bent<dim>();
  fill(*scene, .6);
  set_particles(*scene, [](const auto &p) { return p; });
  dealii::Tensor<1, dim> least, greatest;
  for (unsigned int d = 0; d < dim; ++d)
    {
      double low = 1e10, high = -1e10;
      for (const auto &particle : scene->population->particles())
        {
          low  = std::min(low, particle.position()[d]);
          high = std::max(high, particle.position()[d]);
        }
      least[d]    = -max_of_all(-low);
      greatest[d] = max_of_all(high);
    }
  for (const unsigned int degree : {1u, 2u})
    for (const bool limited : {true, false})
      {
        const LagrangeSpace<dim> space(scene->mesh, degree, mapping);
        const Vector             u      = project(*scene,
                                 space,
                                 *make<dim>("moving least squares",
                                            limited ? "set Limiter = true"
                                                                     : "set Limiter = false"));
        double                   excess = 0, inside = 0;
        FlowScene<dim>::for_each_free_node(
          space, [&](const unsigned int n, const auto &p) {
            for (unsigned int d = 0; d < dim; ++d)
              {
                const double value = u.local_element(dim * n + d);
                excess =
                  std::max({excess, least[d] - value, value - greatest[d]});
                if (!on_side_of_unit_box(p))
                  inside = std::max(inside, std::abs(value - p[d]));
              }
          });
        EXPECT_LT(max_of_all(inside), 1e-11);
        if (limited)
          EXPECT_EQ(max_of_all(excess), 0.);
        else
          EXPECT_GT(max_of_all(excess), .005);
      }
}



TYPED_TEST(MovingLeastSquaresMpi, IsOfSecondOrder)
{
  constexpr int      dim = TypeParam::value;
  const unsigned int n   = dim == 2 ? 8 : 6;
  for (const unsigned int degree : {1u, 2u})
    EXPECT_GT(order_of(*make<dim>("moving least squares"), degree, n), 1.8)
      << degree;
}



TYPED_TEST(VelocityProjectionMpi, ConstantsAreReproduced)
{
  constexpr int               dim = TypeParam::value;
  const dealii::MappingQ<dim> mapping(2);
  for (const auto &scene : {bent<dim>(), periodic<dim>()})
    {
      fill(*scene, .8, 3);
      const auto constant = [&](const auto &) {
        dealii::Tensor<1, dim> u;
        for (unsigned int d = 0; d < dim; ++d)
          u[d] = 1. + d;
        return u;
      };
      set_particles(*scene, constant);
      for (const std::string name :
           {"weighted average", "moving least squares"})
        for (const unsigned int degree : {1u, 2u})
          {
            const LagrangeSpace<dim> space(scene->mesh, degree, mapping);
            EXPECT_LT(difference(project(*scene, space, *make<dim>(name)),
                                 nodal_velocity<dim>(space, constant)),
                      1e-12)
              << name << ' ' << degree;
          }
    }
}



TYPED_TEST(VelocityProjectionMpi, NodesOfPeriodicSidesAreLikeAllOthers)
{
  // A wave that is shifted by cells, as seen from nodes shifted as far.
  constexpr int               dim     = TypeParam::value;
  constexpr unsigned int      n_cells = 4;
  const dealii::MappingQ<dim> mapping(2);
  Scene<dim>                  scene(
    unit_box<dim>(n_cells, "0", {"Periodic boundaries = left:right"}));
  fill(scene, 0.);
  for (const std::string name :
       {"weighted average", "moving least squares", "l2"})
    for (const unsigned int degree : {1u, 2u})
      {
        const LagrangeSpace<dim> space(scene.mesh, degree, mapping);
        std::vector<double>      sums;
        for (unsigned int shift = 0; shift < n_cells; ++shift)
          {
            const double x0 = double(shift) / n_cells;
            set_particles(scene, [&](const auto &p) {
              dealii::Tensor<1, dim> u;
              u[0] = std::exp(std::sin(2. * dealii::numbers::PI * (p[0] - x0)));
              u[1] = u[0] * p[1] * p[1];
              return u;
            });
            const Vector u =
              project(scene,
                      space,
                      *make<dim>(name, name == "l2" ? exact : ""));
            double sum = 0;
            FlowScene<dim>::for_each_free_node(
              space, [&](const unsigned int n, const auto &p) {
                const double distance = std::abs(p[0] - x0);
                if (distance < 1e-9 || distance > 1. - 1e-9)
                  sum += u.local_element(dim * n) +
                         3. * u.local_element(dim * n + 1);
              });
            sums.push_back(sum_of_all(sum));
          }
        for (const double sum : sums)
          EXPECT_NEAR(sum, sums[1], 1e-10) << name << ' ' << degree;
      }
}



TYPED_TEST(VelocityProjectionMpi, WithoutParticlesTheGuessStays)
{
  constexpr int               dim = TypeParam::value;
  const dealii::MappingQ<dim> mapping(2);
  const auto                  scene = bent<dim>();
  for (const std::string name :
       {"weighted average", "moving least squares", "l2"})
    {
      const LagrangeSpace<dim> space(scene->mesh, 2, mapping);
      const Vector             guess = nodal_velocity<dim>(space, wild<dim>);
      Vector                   u     = guess;
      u.update_ghost_values();
      make<dim>(name)->project(*scene->population, space, u);
      EXPECT_LT(difference(u, guess), 1e-10) << name;
    }
}



TYPED_TEST(VelocityIncrementMpi, ParticlesTakeFieldsOfTheSpaceWhereTheyAre)
{
  constexpr int               dim = TypeParam::value;
  const dealii::MappingQ<dim> mapping(2);
  Scene<dim>                  scene(hanging_box<dim>(3));
  fill(scene, .8);
  for (const unsigned int degree : {1u, 2u})
    {
      const LagrangeSpace<dim> space(scene.mesh, degree, mapping);
      const auto               product = [&](const auto &p) {
        dealii::Tensor<1, dim> u;
        for (unsigned int d = 0; d < dim; ++d)
          u[d] = std::pow((1. + p[0]) * p[1] + d, degree);
        return u;
      };
      const auto linear = [&](const auto &p) {
        return dealii::Tensor<1, dim>(p);
      };
      const Vector end   = nodal_velocity<dim>(space, product);
      const Vector star  = nodal_velocity<dim>(space, linear);
      const double blend = .25;
      set_particles(scene, wild<dim>);
      add_increment(*scene.population, space, end, star, blend);
      add_field(*scene.population, space, star, 10.);
      for (const auto &particle : scene.population->particles())
        {
          const auto p = particle.position();
          const auto wanted =
            (1. - blend) * (wild(p) + product(p) - linear(p)) +
            blend * product(p) + 10. * linear(p);
          for (unsigned int d = 0; d < dim; ++d)
            EXPECT_NEAR(particle.properties()[d], wanted[d], 1e-12);
        }
    }
}
