// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_fluid_solver_scene_h
#define tests_fluid_solver_scene_h

#include <thalweg/fluid/fluid_solver.h>

#include <cmath>
#include <limits>

#include "support/scene.h"

/**
 * @brief One of the registered solvers of flows with one fluid or two, for
 * single steps without particles.
 */
template <int dim>
struct SolverScene : public Scene<dim>
{
  using Vector = Thalweg::Vector;

  /// @param solver_settings the text of the solver's own section
  SolverScene(const std::string                     &settings,
              const std::string                     &solver_name,
              const std::string                     &solver_settings = "",
              const typename Scene<dim>::MeshChange &change          = {})
    : Scene<dim>(settings, change)
    , context(MPI_COMM_WORLD)
    , solver(Thalweg::Registry<Thalweg::FluidSolver<dim>>::entries()
               .at(solver_name)
               .make())
    , tension(Thalweg::Registry<Thalweg::InterfaceForce<dim>>::entries()
                .at("sharp")
                .make())
  {
    context.log = Thalweg::Log(false);
    context.statistics.declare({});
    solver->declare_parameters(Thalweg::Section(solver_prm));
    solver_prm.parse_input_from_string(solver_settings);
    terms.attach(*this->space);
    viscosities.attach(*this->space, this->fluids);
    this->set_phases([](const auto &) { return -1.; });
  }

  /// Lets @p level_set be where fluids are, and makes the solver.
  void
  initialize(const typename Scene<dim>::Scalar &level_set)
  {
    this->set_phases(level_set);
    initialize();
  }

  void
  initialize()
  {
    tension->initialize(*this->space,
                        *this->conditions,
                        *this->phase,
                        this->interface.surface_tension);
    solver->initialize({context,
                        *this->space,
                        *this->boundary,
                        *this->phase,
                        this->forces,
                        terms,
                        viscosities,
                        tension.get()});
  }

  /// A step from @p velocity that nothing has convected.
  void
  step(const Vector &velocity, const double dt)
  {
    Vector none;
    this->space->initialize_velocity(none);
    none.update_ghost_values();
    solver->solve(velocity, none, none, dt);
  }

  /// A step from rest.
  void
  step_from_rest(const double dt)
  {
    Vector none;
    this->space->initialize_velocity(none);
    none.update_ghost_values();
    step(none, dt);
  }

  /// The steady flow, from rest.
  void
  find_steady_flow()
  {
    step_from_rest(std::numeric_limits<double>::infinity());
  }

  /// Root mean square of the difference from a velocity, at all nodes.
  double
  velocity_error(const typename Scene<dim>::Field &exact) const
  {
    double sums[2] = {0., 0.};
    this->for_each_node([&](const unsigned int n, const auto &x) {
      sums[0] += (this->at(solver->velocity(), n) - exact(x)).norm_square();
      sums[1] += 1.;
    });
    return std::sqrt(sum_of_all(sums[0]) / sum_of_all(sums[1]));
  }

  /// The same of the pressure, up to a constant where nothing fixes it.
  double
  pressure_error(const typename Scene<dim>::Scalar &exact) const
  {
    double sums[3] = {0., 0., 0.};
    this->for_each_node([&](const unsigned int n, const auto &x) {
      const double e = solver->pressure().local_element(n) - exact(x);
      sums[0] += e;
      sums[1] += e * e;
      sums[2] += 1.;
    });
    for (double &sum : sums)
      sum = sum_of_all(sum);
    const double mean =
      this->conditions->has_open_boundary() ? 0. : sums[0] / sums[2];
    return std::sqrt(std::max(0., sums[1] / sums[2] - mean * mean));
  }

  Thalweg::Context                              context;
  dealii::ParameterHandler                      solver_prm;
  Thalweg::FlowTerms<dim>                       terms;
  Thalweg::FluidViscosities<dim>                viscosities;
  std::unique_ptr<Thalweg::FluidSolver<dim>>    solver;
  std::unique_ptr<Thalweg::InterfaceForce<dim>> tension;
};

#endif
