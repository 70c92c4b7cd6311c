// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_single_fluid_flow_parameters_h
#define thalweg_fluid_single_fluid_flow_parameters_h

#include <thalweg/fluid/pressure_stabilization.h>

#include <string>

namespace Thalweg
{
  /// How the mesh solves its part of a step.
  struct IncrementalStepParameters
  {
    void
    declare_parameters(const Section &section);

    /// theta of Eq. 68b, 70.
    double viscous_theta = 1.;
    /// gamma of Eq. 70: 1 or 0.
    unsigned int pressure_gamma        = 1;
    unsigned int iterations            = 2;
    bool         rotational            = false;
    double       pressure_tolerance    = 1e-6;
    double       velocity_tolerance    = 1e-8;
    unsigned int maximal_cg_iterations = 1000;
  };

  /// The spaces of a single fluid's flow, and how its steps are made.
  template <int dim>
  struct SingleFluidFlowParameters
  {
    void
    declare_parameters(const Section &section);

    /// Whether the mass matrix is diagonal.
    bool
    is_lumped() const;

    /// @throws dealii::ExcMessage
    void
    check() const;

    unsigned int velocity_degree = 1;
    unsigned int pressure_degree = 1;
    std::string  mass            = "by degree";
    /// "first order" or "second order".
    std::string order = "second order";
    /// "consistent" or "incremental".
    std::string                        explicit_pressure = "consistent";
    IncrementalStepParameters          step;
    Choice<PressureStabilization<dim>> stabilization;
  };
} // namespace Thalweg

#endif
