// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/pressure_stabilization.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// For pairs of spaces that are stable by themselves.
    template <int dim>
    class NoStabilization : public PressureStabilization<dim>
    {
    public:
      void
      declare_parameters(const Section &) override
      {}

      bool
      is_active() const override
      {
        return false;
      }

      double
      parameter(const double,
                const double,
                const double,
                const double) const override
      {
        return 0.;
      }

      const Vector &
      balance(const Vector &pressure_gradient, const Vector &) const override
      {
        return pressure_gradient;
      }
    };



    /// Orthogonal subscales (Codina 2002): the part of the pressure gradient
    /// that nodal values cannot represent is diffused.
    template <int dim>
    class OrthogonalSubscales : public PressureStabilization<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        section.add("Viscous constant",
                    viscous_constant,
                    "",
                    "c_1 in 1/tau = c_1 nu / h^2 + c_2 |V| / h.",
                    dealii::Patterns::Double(0));
        section.add("Convective constant",
                    convective_constant,
                    "",
                    "c_2 in the same.",
                    dealii::Patterns::Double(0));
        section.add("Transient constant",
                    transient_constant,
                    "",
                    "Adds this constant over the time step to 1/tau, which "
                    "bounds tau in slow flow.",
                    dealii::Patterns::Double(0));
      }

      double
      parameter(const double length,
                const double kinematic_viscosity,
                const double speed,
                const double dt) const override
      {
        return 1. /
               (viscous_constant * kinematic_viscosity / (length * length) +
                convective_constant * speed / length + transient_constant / dt);
      }

      const Vector &
      balance(const Vector &pressure_gradient, const Vector &) const override
      {
        return pressure_gradient;
      }

    private:
      double viscous_constant    = 4.;
      double convective_constant = 2.;
      double transient_constant  = 1.;
    };



    /// Finite increment calculus: Onate et al. (2014), Eq. 19 to 23, with the
    /// static part of the momentum equation.
    template <int dim>
    class FiniteIncrementCalculus : public PressureStabilization<dim>
    {
    public:
      void
      declare_parameters(const Section &) override
      {}

      double
      parameter(const double length,
                const double kinematic_viscosity,
                const double,
                const double dt) const override
      {
        return 1. / (8. * kinematic_viscosity / (length * length) + 2. / dt);
      }

      const Vector &
      balance(const Vector &, const Vector &forces) const override
      {
        return forces;
      }
    };
  } // namespace

  THALWEG_REGISTER(PressureStabilization,
                   NoStabilization,
                   "none",
                   "for Taylor-Hood spaces, or gamma = 0")
  THALWEG_REGISTER(PressureStabilization,
                   OrthogonalSubscales,
                   "oss",
                   "orthogonal subscales (Eq. 74 to 76), second order")
  THALWEG_REGISTER(PressureStabilization,
                   FiniteIncrementCalculus,
                   "fic",
                   "finite increment calculus with the static momentum "
                   "equation (Onate et al. 2014), first order in the time "
                   "step")
} // namespace Thalweg
