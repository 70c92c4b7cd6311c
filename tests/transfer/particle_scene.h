// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_transfer_particle_scene_h
#define tests_transfer_particle_scene_h

#include <thalweg/particles/seeding.h>
#include <thalweg/transfer/velocity_projection.h>

#include <cmath>

#include "support/flow_scene.h"
#include "support/meshes.h"

/// Particles with given velocities, and what projections make of them.
namespace ParticleScenes
{
  using namespace Thalweg;

  /// A projection with settings of its own.
  template <int dim>
  std::unique_ptr<VelocityProjection<dim>>
  make(const std::string &name, const std::string &settings = "")
  {
    auto model = Registry<VelocityProjection<dim>>::entries().at(name).make();
    dealii::ParameterHandler prm;
    model->declare_parameters(Section(prm));
    prm.parse_input_from_string(settings);
    // The variables have their values; the handler may go.
    return model;
  }


  /// Only the particles count.
  const std::string exact = "set Tolerance = 1e-14\nset Regularization = 0";

  /// A bent mesh with hanging nodes.
  template <int dim>
  std::unique_ptr<Scene<dim>>
  bent()
  {
    return std::make_unique<Scene<dim>>(unit_box<dim>(3),
                                        Meshes::distort_and_refine<dim>);
  }

  /// Hanging nodes and periodic sides.
  template <int dim>
  std::unique_ptr<Scene<dim>>
  periodic()
  {
    return std::make_unique<Scene<dim>>(
      hanging_box<dim>(4, {"Periodic boundaries = left:right"}));
  }


  /// Fills the mesh with particles, with no velocity.
  template <int dim>
  void
  fill(Scene<dim>        &scene,
       const double       jitter,
       const unsigned int per_direction = 4)
  {
    SeedingParameters parameters;
    parameters.particles_per_direction = per_direction;
    parameters.jitter                  = jitter;
    seed(*scene.population,
         parameters,
         dealii::Functions::ZeroFunction<dim>(dim),
         dealii::Functions::ConstantFunction<dim>(1.));
  }


  template <int dim, typename Field>
  void
  set_particles(Scene<dim> &scene, const Field &field)
  {
    for (auto &particle : scene.population->particles())
      {
        const auto u = field(particle.position());
        for (unsigned int d = 0; d < dim; ++d)
          particle.properties()[d] = u[d];
      }
  }


  template <int dim>
  Vector
  zeros(const LagrangeSpace<dim> &space)
  {
    Vector vector;
    space.initialize(vector, dim);
    vector.update_ghost_values();
    return vector;
  }


  /// What the particles give, from a guess of zero.
  template <int dim>
  Vector
  project(const Scene<dim>              &scene,
          const LagrangeSpace<dim>      &space,
          const VelocityProjection<dim> &projection)
  {
    Vector velocity = zeros(space);
    projection.project(*scene.population, space, velocity);
    return velocity;
  }


  /// The greatest difference of owned and ghost entries.
  inline double
  difference(const Vector &a, const Vector &b)
  {
    double largest = 0;
    for (unsigned int i = 0;
         i < a.locally_owned_size() + a.get_partitioner()->n_ghost_indices();
         ++i)
      largest =
        std::max(largest, std::abs(a.local_element(i) - b.local_element(i)));
    return max_of_all(largest);
  }


  /// sum_p w_p V_p . V_p, each particle with its share of its cell.
  template <int dim>
  double
  energy(const Scene<dim> &scene)
  {
    const auto &graph = scene.mesh.graph();
    double      sum   = 0;
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto &all = *scene.population;
        for (const auto &particle : all.in_cell(c))
          for (unsigned int d = 0; d < dim; ++d)
            sum += graph.cell(c).measure / all.n_in_cell(c) *
                   std::pow(particle.properties()[d], 2);
      }
    return sum_of_all(sum);
  }


  template <int dim>
  dealii::Tensor<1, dim>
  smooth(const dealii::Point<dim> &p)
  {
    dealii::Tensor<1, dim> u;
    for (unsigned int d = 0; d < dim; ++d)
      u[d] = std::sin(3. * p[0] + d) * std::cos(2. * p[1] - d * p[dim - 1]);
    return u;
  }


  /// The order of a projection of a smooth field between boxes of n and 2 n
  /// cells in each direction.
  template <int dim>
  double
  order_of(const VelocityProjection<dim> &projection,
           const unsigned int             degree,
           const unsigned int             n)
  {
    const dealii::MappingQ<dim> mapping(2);
    const auto                  error = [&](const unsigned int n_cells) {
      Scene<dim> scene(unit_box<dim>(n_cells));
      fill(scene, .8);
      set_particles(scene, smooth<dim>);
      const LagrangeSpace<dim> space(scene.mesh, degree, mapping);
      return mean_square_error(space.velocity(),
                               mapping,
                               project(scene, space, projection),
                               smooth<dim>);
    };
    return std::log2(error(n) / error(2 * n));
  }
} // namespace ParticleScenes

#endif
