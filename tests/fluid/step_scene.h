// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_fluid_step_scene_h
#define tests_fluid_step_scene_h

#include <thalweg/fluid/incremental_step.h>
#include <thalweg/fluid/pressure_stabilization.h>

#include <cmath>

#include "support/flow_scene.h"

namespace Steps
{
  using namespace Thalweg;

  constexpr double pi = dealii::numbers::PI;


  template <int dim>
  std::unique_ptr<PressureStabilization<dim>>
  stabilization(const std::string &name)
  {
    return Registry<PressureStabilization<dim>>::entries().at(name).make();
  }


  /// The mesh's part of a step, solved tightly.
  template <int dim>
  struct StepScene : public FlowScene<dim>
  {
    StepScene(const std::string                     &settings,
              const unsigned int                     velocity_degree,
              const unsigned int                     pressure_degree,
              const double                           nu,
              const typename Scene<dim>::MeshChange &change = {})
      : FlowScene<dim>(settings, velocity_degree, pressure_degree, change)
      , context(MPI_COMM_WORLD)
      , stabilization_model(stabilization<dim>("none"))
    {
      parameters.pressure_tolerance = 1e-13;
      parameters.velocity_tolerance = 1e-13;
      context.log                   = Log(false);
      context.statistics.declare({});
      step = std::make_unique<IncrementalStep<dim>>(context,
                                                    this->operators,
                                                    this->flow_boundary,
                                                    *stabilization_model,
                                                    parameters,
                                                    nu);
    }

    /// A velocity or an acceleration of zeros with ghosts.
    Vector
    no_velocity() const
    {
      Vector vector = this->empty_velocity();
      vector.update_ghost_values();
      return vector;
    }

    /// The pressure of @p velocity under @p forces and friction, from zero.
    Vector
    pressure_of(const Vector &velocity, const Vector &forces) const
    {
      Vector pressure = this->empty_pressure();
      this->flow_boundary.apply_open(pressure, 1.);
      this->P.interpolate(pressure, 1);
      step->find_pressure(
        velocity, forces, friction_of(velocity), no_velocity(), pressure);
      return pressure;
    }

    /// The viscous acceleration.
    Vector
    friction_of(const Vector &velocity) const
    {
      Vector g = no_velocity();
      step->viscous_acceleration(velocity, g);
      return g;
    }

    /// The greatest difference from a function at all nodes of the pressure,
    /// up to a constant where nothing fixes it.
    double
    pressure_error(const Vector                      &pressure,
                   const typename Scene<dim>::Scalar &function) const
    {
      double sum = 0, count = 0;
      if (!this->conditions->has_open_boundary())
        this->for_each_free_node(this->P,
                                 [&](const unsigned int n, const auto &p) {
                                   sum +=
                                     pressure.local_element(n) - function(p);
                                   count += 1.;
                                 });
      const double mean    = sum_of_all(sum) / std::max(1., sum_of_all(count));
      double       largest = 0;
      for_each_owned_node<dim>(this->P,
                               [&](const unsigned int n, const auto &p) {
                                 largest =
                                   std::max(largest,
                                            std::abs(pressure.local_element(n) -
                                                     function(p) - mean));
                               });
      return max_of_all(largest);
    }

    /// The greatest difference from a function at all nodes.
    double
    velocity_error(const Vector                     &velocity,
                   const typename Scene<dim>::Field &function) const
    {
      double largest = 0;
      for_each_owned_node<dim>(
        this->V, [&](const unsigned int n, const auto &p) {
          largest =
            std::max(largest, (this->at(velocity, n) - function(p)).norm());
        });
      return max_of_all(largest);
    }

    Context                                     context;
    IncrementalStepParameters                   parameters;
    std::unique_ptr<PressureStabilization<dim>> stabilization_model;
    std::unique_ptr<IncrementalStep<dim>>       step;
  };


  /// Along x, with walls at y = 0 and y = 1.
  template <int dim>
  dealii::Tensor<1, dim>
  poiseuille(const dealii::Point<dim> &p)
  {
    dealii::Tensor<1, dim> u;
    u[0] = p[1] * (1. - p[1]);
    return u;
  }


  template <int dim>
  std::string
  as_text(const std::string &first)
  {
    return first + "; 0" + (dim == 3 ? "; 0" : "");
  }

  /// Conditions with which poiseuille() is a flow of its own.
  template <int dim>
  std::string
  channel(const std::string &ends)
  {
    return section("Boundary conditions", {"No slip = bottom, top", ends});
  }

  template <int dim>
  std::string
  given_ends()
  {
    return channel<dim>("Velocity = left: " + as_text<dim>("y*(1-y)") +
                        " | right: " + as_text<dim>("y*(1-y)"));
  }

  inline dealii::Tensor<1, 2>
  vortices(const dealii::Point<2> &p)
  {
    dealii::Tensor<1, 2> u;
    u[0] = std::sin(2. * pi * p[0]) * std::cos(2. * pi * p[1]);
    u[1] = -std::cos(2. * pi * p[0]) * std::sin(2. * pi * p[1]);
    return u;
  }

  /// Of vortices(), over the density.
  inline double
  vortex_pressure(const dealii::Point<2> &p)
  {
    return .25 * (std::cos(4. * pi * p[0]) + std::cos(4. * pi * p[1]));
  }

  const std::vector<std::string> all_periodic{
    "Periodic boundaries = left:right, bottom:top"};
} // namespace Steps

#endif
