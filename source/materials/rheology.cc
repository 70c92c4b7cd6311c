// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/materials/rheology.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    class Newton : public Rheology
    {
    public:
      void
      declare_parameters(const Section &) override
      {}

      bool
      depends_on_shear() const override
      {
        return false;
      }

      Value
      value(const double, const double reference) const override
      {
        return {reference, 0.};
      }
    };



    /// mu = K g^(n - 1) for g = sqrt(rate^2 + g_0^2).
    Rheology::Value
    power(const double rate, const double least, const double K, const double n)
    {
      const double square    = rate * rate + least * least;
      const double viscosity = K * std::pow(square, .5 * (n - 1.));
      return {viscosity, viscosity * (n - 1.) * rate / square};
    }



    /// Papanastasiou's tau_y (1 - exp(-m rate)) / rate.
    Rheology::Value
    yield(const double rate, const double stress, const double m)
    {
      const double x = m * rate;
      if (x < 1e-3) // the series, where the quotient would be round-off
        return {stress * m * (1. - x / 2. + x * x / 6. - x * x * x / 24.),
                stress * m * m * (-.5 + x / 3. - x * x / 8.)};
      const double part = -std::expm1(-x);
      return {stress * part / rate,
              stress * (x * (1. - part) - part) / (rate * rate)};
    }



    class PowerLaw : public Rheology
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        section.add("Exponent",
                    exponent,
                    "",
                    "n in mu = K g^(n - 1), where K in Pa s^n is the fluid's "
                    "'Viscosity'.",
                    dealii::Patterns::Double(1e-3, 10.));
        section.add("Least shear rate",
                    least,
                    "1/s",
                    "g^2 is the square of the shear rate plus that of this "
                    "number.",
                    dealii::Patterns::Double(1e-300));
      }

      Value
      value(const double rate, const double reference) const override
      {
        return power(rate, least, reference, exponent);
      }

    private:
      double exponent = 1.;
      double least    = 1e-3;
    };



    class Carreau : public Rheology
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        section.add(
          "Exponent",
          exponent,
          "",
          "n in mu = mu_oo + (mu_0 - mu_oo) (1 + (lambda rate)^2)^((n "
          "- 1)/2), where mu_0 is the fluid's 'Viscosity'.",
          dealii::Patterns::Double(1e-3, 10.));
        section.add("Relaxation time",
                    time,
                    "s",
                    "lambda in it.",
                    dealii::Patterns::Double(0.));
        section.add("Infinite viscosity",
                    infinite,
                    "Pa s",
                    "mu_oo in it.",
                    dealii::Patterns::Double(0.));
      }

      Value
      value(const double rate, const double reference) const override
      {
        const double square = 1. + time * time * rate * rate;
        const double part =
          (reference - infinite) * std::pow(square, .5 * (exponent - 1.));
        return {infinite + part,
                part * (exponent - 1.) * time * time * rate / square};
      }

    private:
      double exponent = .5;
      double time     = 1.;
      double infinite = 0.;
    };



    class HerschelBulkley : public Rheology
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        declare_yield(section);
        section.add("Exponent",
                    exponent,
                    "",
                    "n in the stress tau_y + K rate^n, where K in Pa s^n is "
                    "the fluid's 'Viscosity'.",
                    dealii::Patterns::Double(1e-3, 10.));
      }

      Value
      value(const double rate, const double reference) const override
      {
        const Value plastic = power(rate, 1. / growth, reference, exponent);
        const Value solid   = yield(rate, stress, growth);
        return {plastic.viscosity + solid.viscosity,
                plastic.slope + solid.slope};
      }

    protected:
      void
      declare_yield(const Section &section)
      {
        section.add("Yield stress",
                    stress,
                    "Pa",
                    "The shear stress tau_y below which the fluid does not "
                    "flow.",
                    dealii::Patterns::Double(0.));
        section.add("Growth time",
                    growth,
                    "s",
                    "m in tau_y (1 - exp(-m rate)) (T. Papanastasiou, J. "
                    "Rheol. 31, 1987): the fluid creeps at shear rates below "
                    "1/m instead of standing still.",
                    dealii::Patterns::Double(1e-12));
      }

    private:
      double stress   = 0.;
      double growth   = 1000.;
      double exponent = 1.;
    };



    class Bingham : public HerschelBulkley
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        declare_yield(section);
      }
    };

    const Registration<Rheology, Newton>
      newton("newton", "the fluid's 'Viscosity' at any shear rate");
    const Registration<Rheology, PowerLaw>
      power_law("power law", "thins (n < 1) or thickens (n > 1) by a power");
    const Registration<Rheology, Carreau>
      carreau("carreau", "thins between two viscosities");
    const Registration<Rheology, Bingham>
      bingham("bingham",
              "flows only above a yield stress, with the fluid's 'Viscosity' "
              "as plastic viscosity");
    const Registration<Rheology, HerschelBulkley>
      herschel_bulkley("herschel bulkley",
                       "flows only above a yield stress, with a power law");
  } // namespace
} // namespace Thalweg
