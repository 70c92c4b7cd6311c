// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/coupled_stabilization.h>

namespace Thalweg
{
  namespace
  {
    /// Stabilizations with 1/tau = c_1 nu / h^2 + 1 / dt.
    class WithViscousConstant : public CoupledStabilization
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        section.add("Viscous constant",
                    viscous_constant,
                    "",
                    "c_1 in 1/tau = c_1 nu / h^2 + 1 / dt.",
                    dealii::Patterns::Double(0.));
      }

      double
      rate(const double viscous_rate, const double inverse_dt) const override
      {
        return viscous_constant * viscous_rate + inverse_dt;
      }

    private:
      double viscous_constant = 4.;
    };



    /// What nodal values cannot represent of the pressure gradient.
    class OrthogonalSubscales : public WithViscousConstant
    {
    public:
      Balance
      balance() const override
      {
        return Balance::projection;
      }
    };



    /// The residual of the momentum equation, whose friction linear elements
    /// do not see.
    class PressureStabilizingPetrovGalerkin : public WithViscousConstant
    {
    public:
      Balance
      balance() const override
      {
        return Balance::acceleration;
      }
    };



    /// Finite increment calculus: Onate et al. (2014), Eq. 19 to 23, with the
    /// static part of the momentum equation.
    class FiniteIncrements : public CoupledStabilization
    {
    public:
      void
      declare_parameters(const Section &) override
      {}

      Balance
      balance() const override
      {
        return Balance::friction;
      }

      double
      rate(const double viscous_rate, const double inverse_dt) const override
      {
        return 8. * viscous_rate + 2. * inverse_dt;
      }
    };
  } // namespace

  namespace
  {
    const Registration<CoupledStabilization, OrthogonalSubscales> oss(
      "oss",
      "orthogonal subscales (Codina 2002), which vanish for what nodal values "
      "can represent");
    const Registration<CoupledStabilization, PressureStabilizingPetrovGalerkin>
      pspg("pspg",
           "pressure-stabilizing Petrov-Galerkin (Eq. 89, with the "
           "acceleration that Eq. 90 leaves out)");
    const Registration<CoupledStabilization, FiniteIncrements>
      fic("fic",
          "finite increment calculus with the static momentum equation (Onate "
          "et al. 2014)");
  } // namespace
} // namespace Thalweg
