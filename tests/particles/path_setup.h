// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_tests_particles_path_setup_h
#define thalweg_tests_particles_path_setup_h

#include <thalweg/particles/path_convection.h>
#include <thalweg/particles/population_snapshot.h>

#include <vector>

#include "particles/setup.h"

namespace ParticleTest
{
  /// Copies a field out at the nodes of all cells.
  template <int dim>
  std::vector<double>
  path_nodal(const Thalweg::Mesh<dim> &mesh,
             const unsigned int        degree,
             const Field<dim>         &field)
  {
    std::vector<double> values;
    const unsigned int  n = degree + 1;
    for (unsigned int i = 0; i < mesh.graph().n_cells(); ++i)
      for (unsigned int node = 0; node < dealii::Utilities::pow(n, dim); ++node)
        {
          Point<dim> p;
          for (unsigned int v = 0; v < (1 << dim); ++v)
            {
              double shape = 1;
              for (unsigned int d = 0, power = 1; d < dim; ++d, power *= n)
                {
                  const double x = double((node / power) % n) / degree;
                  shape *= (v >> d) & 1 ? x : 1. - x;
                }
              p += shape * (mesh.graph().cell(i).vertices[v] - Point<dim>());
            }
          const auto value = field(p);
          for (unsigned int d = 0; d < dim; ++d)
            values.push_back(value[d]);
        }
    return values;
  }

  template <int dim>
  Thalweg::PathFields<dim>
  path_fields(const Thalweg::Mesh<dim> &mesh,
              const unsigned int        degree,
              const Field<dim>         &begin_velocity,
              const Field<dim>         &end_velocity,
              const Field<dim>         &begin_acceleration,
              const Field<dim>         &end_acceleration)
  {
    return {degree,
            path_nodal(mesh, degree, begin_velocity),
            path_nodal(mesh, degree, end_velocity),
            path_nodal(mesh, degree, begin_acceleration),
            path_nodal(mesh, degree, end_acceleration)};
  }

  template <int dim>
  Field<dim>
  constant(const Tensor<1, dim> &value)
  {
    return [value](const Point<dim> &) { return value; };
  }

  template <int dim>
  Field<dim>
  times(const double factor, const Field<dim> &field)
  {
    return [factor, field](const Point<dim> &p) { return factor * field(p); };
  }

  template <int dim>
  Point<dim>
  middle_of_box()
  {
    Point<dim> p;
    for (unsigned int d = 0; d < dim; ++d)
      p[d] = 0.5;
    return p;
  }

  /// A particle as it is.
  template <int dim>
  struct State
  {
    Point<dim>     position;
    Tensor<1, dim> velocity;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &position &velocity;
    }
  };

  template <int dim>
  using States = std::map<unsigned int, State<dim>>;

  /// The particles of this rank by their ids.
  template <int dim>
  States<dim>
  states(const Thalweg::Population<dim> &population)
  {
    States<dim> result;
    for (const auto &particle : population.particles())
      {
        State<dim> &state = result[particle.id()];
        state.position    = particle.position();
        for (unsigned int d = 0; d < dim; ++d)
          state.velocity[d] = particle.properties()[d];
      }
    return result;
  }

  /// The particles of all ranks by their ids.
  template <int dim>
  States<dim>
  all_states(const Thalweg::Population<dim> &population)
  {
    States<dim> result;
    for (const auto &of_rank :
         dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, states(population)))
      result.insert(of_rank.begin(), of_rank.end());
    return result;
  }

  template <int dim>
  void
  set_velocity(Thalweg::Population<dim> &population, const Field<dim> &field)
  {
    for (auto &particle : population.particles())
      {
        const auto value = field(particle.position());
        for (unsigned int d = 0; d < dim; ++d)
          particle.properties()[d] = value[d];
      }
  }

  inline Thalweg::ConvectionParameters
  substeps(const std::string &integrator, const double courant)
  {
    Thalweg::ConvectionParameters parameters;
    parameters.integrator             = integrator;
    parameters.substep_courant_number = courant;
    return parameters;
  }
} // namespace ParticleTest

#endif
