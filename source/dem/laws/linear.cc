// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/dem/law_of.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// The damping ratio of an oscillator that loses as much in half a period
    /// as a contact of this restitution.
    double
    damping_ratio(const double restitution)
    {
      const double logarithm = std::log(restitution);
      return -logarithm / std::sqrt(M_PI * M_PI + logarithm * logarithm);
    }



    /**
     * @brief A linear spring and a dashpot (Eq. 10-17 of seed 001): contacts last
     * equally long whatever the speed.
     *
     * With a stiffness from a velocity v the spring stores as much at the
     * greatest overlap of Hertz's contact at v.
     */
    class LinearLaw : public ContactLawOf<LinearLaw>
    {
    public:
      struct Constants
      {
        double stiffness;            ///< N/m
        double damping;              ///< 2 zeta, of critical at unit mass
        double tangential_stiffness; ///< part of the normal one
        double tangential_damping;   ///< part of the normal one
        double cohesion;             ///< N/m^2
        double compliance;           ///< at right angles, m/N
      };

      void
      declare_parameters(const Section &section) override
      {
        using dealii::Patterns::Double;
        section.add("Normal stiffness",
                    normal_stiffness,
                    "N/m",
                    "Of all contacts; 0: from the velocity below.",
                    Double(0));
        section.add("Velocity",
                    velocity,
                    "m/s",
                    "Where no stiffness is given: of impacts at which contacts "
                    "of the smallest grains are as stiff as Young's moduli and "
                    "Hertz's theory say.",
                    Double(0));
        section.add("Radius",
                    radius,
                    "m",
                    "The effective radius r1 r2/(r1 + r2) of that impact.",
                    Double(0));
        section.add("Density",
                    density,
                    "kg/m^3",
                    "That of the grains of that impact.",
                    Double(0));
        section.add("Tangential stiffness",
                    tangential_stiffness,
                    "",
                    "As a part of the normal one.",
                    Double(std::numeric_limits<double>::min()));
        section.add("Tangential damping",
                    tangential_damping,
                    "",
                    "As a part of the normal one.",
                    Double(0));
      }

      void
      check(const std::vector<PairMaterial> &) const override
      {
        AssertThrow(normal_stiffness > 0. ||
                      (velocity > 0. && radius > 0. && density > 0.),
                    dealii::ExcMessage(
                      "The law 'linear' has no stiffness: set "
                      "'Contact/linear/Normal stiffness', or 'Velocity', "
                      "'Radius' and 'Density' there."));
      }

      Constants
      constants(const PairMaterial &pair) const
      {
        const double stiffness =
          normal_stiffness > 0. ? normal_stiffness : stiffness_of_impact(pair);
        return {stiffness,
                2. * damping_ratio(pair.restitution),
                tangential_stiffness,
                tangential_damping,
                pair.cohesion,
                1. / (tangential_stiffness * stiffness)};
      }

      static THALWEG_INLINE Response
      respond(const Constants &c, const Touch &touch)
      {
        const double adhesion =
          c.cohesion * M_PI * touch.effective_radius * touch.effective_radius;
        const double damping =
          c.damping * std::sqrt(c.stiffness * touch.effective_mass);
        return {c.stiffness * touch.overlap - adhesion,
                c.stiffness,
                damping,
                c.tangential_stiffness * c.stiffness,
                c.tangential_damping * damping,
                adhesion,
                c.compliance};
      }

      static double
      elastic_energy(const Constants &c, const Touch &touch)
      {
        const double adhesion =
          c.cohesion * M_PI * touch.effective_radius * touch.effective_radius;
        return (.5 * c.stiffness * touch.overlap - adhesion) * touch.overlap;
      }

      static double
      duration(const Constants &c, const ImpactScale &scale)
      {
        return M_PI * std::sqrt(scale.mass / c.stiffness /
                                (1. - .25 * c.damping * c.damping));
      }

    private:
      /// The spring whose greatest force at this velocity is Hertz's: k = 16/15
      /// E* sqrt(R) (15 m v^2 / (16 E* sqrt(R)))^(1/5).
      double
      stiffness_of_impact(const PairMaterial &pair) const
      {
        const double mass =
          density * 4. / 3. * M_PI * std::pow(2. * radius, 3.) / 2.;
        const double c = 16. / 15. * pair.effective_young * std::sqrt(radius);
        return c * std::pow(mass * velocity * velocity / c, .2);
      }

      double normal_stiffness = 0., velocity = 0., radius = 0., density = 0.;
      double tangential_stiffness = 2. / 7., tangential_damping = .5;
    };



    const Registration<ContactLaw, LinearLaw> linear_law(
      "linear",
      "a linear spring and a dashpot: contacts last equally long whatever the "
      "speed.");
  } // namespace
} // namespace Thalweg
