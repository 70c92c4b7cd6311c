// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "particles/path_setup.h"

using namespace ParticleTest;
using Thalweg::WallKind;

namespace
{
  /// All of a particle, in the order of the cells and within them.
  template <int dim>
  std::vector<double>
  everything(const Thalweg::Population<dim> &population)
  {
    std::vector<double> result;
    const auto         &graph = population.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      for (const auto &particle : population.in_cell(c))
        {
          result.push_back(c);
          result.push_back(particle.id());
          for (unsigned int d = 0; d < dim; ++d)
            {
              result.push_back(particle.position()[d]);
              result.push_back(particle.reference()[d]);
            }
          for (const double property : particle.properties())
            result.push_back(property);
        }
    return result;
  }

  template <int dim>
  void
  move_and_restore()
  {
    Thalweg::Mesh<dim> mesh(MPI_COMM_WORLD);
    make_box(mesh, 4);
    refine_around(mesh, middle_of_box<dim>(), 0.3);
    const Field<dim>         turn = rotation<dim>(middle_of_box<dim>());
    Thalweg::Population<dim> population(mesh);
    seed_plain(population, 2, 0.5);
    set_velocity<dim>(population, turn);
    const auto before = everything(population);
    const auto n      = population.n_global_particles();

    Thalweg::PopulationSnapshot<dim> snapshot;
    snapshot.save(population);
    Tensor<1, dim> away;
    away[0] = 1.;
    const auto fields =
      path_fields<dim>(mesh, 1, turn, constant<dim>(away), turn, turn);
    const Thalweg::PathConvection<dim> convection(mesh,
                                                  {},
                                                  {{1, WallKind::open}});
    convection.move(population, fields, 0.5);
    EXPECT_LT(population.n_global_particles(), n);
    const auto once = everything(population);
    snapshot.restore(population);
    EXPECT_EQ(population.n_global_particles(), n);
    EXPECT_EQ(everything(population), before);

    // and the second time everything is the same
    convection.move(population, fields, 0.5);
    EXPECT_EQ(everything(population), once);

    // the mesh has changed on every rank: what was saved is of no use
    mesh.triangulation().refine_global();
    mesh.update();
    EXPECT_THROW(snapshot.restore(population), dealii::ExceptionBase);
  }
} // namespace


TEST(PopulationSnapshotMpi, RestoresAllParticles)
{
  move_and_restore<2>();
  move_and_restore<3>();
}
