// SPDX-License-Identifier: LGPL-2.1-or-later
#include "particle_scene.h"
#include "support/dimensions.h"

using namespace ParticleScenes;

namespace
{
  template <typename T>
  class L2ProjectionMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(L2ProjectionMpi, Dimensions);
} // namespace



TYPED_TEST(L2ProjectionMpi, FieldsOfTheSpaceAreReproduced)
{
  constexpr int               dim = TypeParam::value;
  const dealii::MappingQ<dim> mapping(2);
  const auto                  l2 = make<dim>("l2", exact);
  for (const auto &scene : {bent<dim>(), periodic<dim>()})
    {
      fill(*scene, .8);
      for (const unsigned int degree : {1u, 2u})
        {
          set_particles(*scene,
                        [&](const auto &) { return dealii::Tensor<1, dim>(); });
          const LagrangeSpace<dim> space(scene->mesh, degree, mapping);
          const Vector wanted = nodal_velocity<dim>(space, wild<dim>);
          add_field(*scene->population, space, wanted, 1.);
          EXPECT_LT(difference(project(*scene, space, *l2), wanted), 1e-10);
        }
    }
}



TYPED_TEST(L2ProjectionMpi, TheEnergyIsSplitIntoThatOfTheFieldAndTheRest)
{
  constexpr int               dim = TypeParam::value;
  const dealii::MappingQ<dim> mapping(2);
  const auto                  l2 = make<dim>("l2", exact);
  for (const auto &scene : {bent<dim>(), periodic<dim>()})
    {
      fill(*scene, .8);
      for (const unsigned int degree : {1u, 2u})
        {
          const LagrangeSpace<dim> space(scene->mesh, degree, mapping);
          set_particles(*scene,
                        [](const auto &p) { return wild(p) + smooth(p); });
          const double before = energy(*scene);
          const Vector u      = project(*scene, space, *l2);
          add_field(*scene->population, space, u, -1.);
          const double rest = energy(*scene);
          set_particles(*scene,
                        [&](const auto &) { return dealii::Tensor<1, dim>(); });
          add_field(*scene->population, space, u, 1.);
          const double after = energy(*scene);
          EXPECT_LT(after, before);
          EXPECT_GT(after, .1 * before);
          EXPECT_GT(rest, .05 * before);
          EXPECT_NEAR(after + rest, before, 1e-11);
        }
    }
}



TYPED_TEST(L2ProjectionMpi, TheMomentumStays)
{
  constexpr int               dim = TypeParam::value;
  const dealii::MappingQ<dim> mapping(2);
  const auto                  scene = bent<dim>();
  fill(*scene, .8);
  set_particles(*scene, wild<dim>);
  const LagrangeSpace<dim> space(scene->mesh, 2, mapping);
  const Vector             u = project(*scene, space, *make<dim>("l2", exact));
  add_field(*scene->population, space, u, -1.);
  const auto            &graph = scene->mesh.graph();
  dealii::Tensor<1, dim> lost;
  for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
    {
      const auto &all = *scene->population;
      for (const auto &particle : all.in_cell(c))
        for (unsigned int d = 0; d < dim; ++d)
          lost[d] +=
            graph.cell(c).measure / all.n_in_cell(c) * particle.properties()[d];
    }
  EXPECT_LT(dealii::Utilities::MPI::sum(lost, MPI_COMM_WORLD).norm(), 1e-12);
}



TYPED_TEST(L2ProjectionMpi, HasTheOrderOfTheSpace)
{
  constexpr int      dim = TypeParam::value;
  const auto         l2  = make<dim>("l2", exact);
  const unsigned int n   = dim == 2 ? 8 : 6;
  EXPECT_GT(order_of(*l2, 1, n), 1.9);
  EXPECT_GT(order_of(*l2, 2, n), 2.9);
}



TYPED_TEST(L2ProjectionMpi, TheGuessHoldsWhereNoParticleSpeaks)
{
  constexpr int               dim = TypeParam::value;
  const dealii::MappingQ<dim> mapping(2);
  const auto                  scene = bent<dim>();
  fill(*scene, 0., 2);
  auto                     &population = *scene->population;
  std::vector<unsigned int> gone;
  for (const auto &particle : population.particles())
    if (particle.position()[0] > .5)
      gone.push_back(particle.index_in(population.all()));
  population.remove(gone);
  for (const unsigned int degree : {1u, 2u})
    {
      const LagrangeSpace<dim> space(scene->mesh, degree, mapping);
      const Vector             wanted = nodal_velocity<dim>(space, smooth<dim>);
      set_particles(*scene,
                    [&](const auto &) { return dealii::Tensor<1, dim>(); });
      add_field(*scene->population, space, wanted, 1.);
      Vector u = wanted;
      u.update_ghost_values();
      make<dim>("l2", "set Tolerance = 1e-12")
        ->project(*scene->population, space, u);
      EXPECT_LT(difference(u, wanted), 1e-9);
    }
}
