// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/dem/law_of.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /**
     * @brief Hertz's contact with Mindlin's tangential stiffness.
     *
     * F = 4/3 E* sqrt(R*) d^(3/2), k_t = 8 G* sqrt(R* d). A dashpot of
     * sqrt(5) b sqrt(m* 4/3 E* sqrt(R*)) d^(1/4) with
     * b = -ln e / sqrt(pi^2 + ln^2 e) gives the restitution e exactly at any
     * speed (Antypov and Elliott 2011).
     */
    class HertzMindlinLaw : public ContactLawOf<HertzMindlinLaw>
    {
    public:
      struct Constants
      {
        double normal;     ///< 4/3 E*, Pa
        double tangential; ///< 8 G*, Pa
        double damping;    ///< sqrt(5) b
        double damping_ratio;
        double cohesion; ///< N/m^2
      };

      void
      declare_parameters(const Section &) override
      {}

      void
      check(const std::vector<PairMaterial> &table) const override
      {
        for (const PairMaterial &pair : table)
          AssertThrow(pair.effective_young > 0.,
                      dealii::ExcMessage(
                        "The law 'hertz mindlin' needs Young's "
                        "moduli above zero."));
      }

      Constants
      constants(const PairMaterial &pair) const
      {
        const double logarithm = std::log(pair.restitution);
        const double b =
          -logarithm / std::sqrt(M_PI * M_PI + logarithm * logarithm);
        return {4. / 3. * pair.effective_young,
                8. * pair.effective_shear,
                std::sqrt(5.) * b,
                b,
                pair.cohesion};
      }

      static THALWEG_INLINE Response
      respond(const Constants &c, const Touch &touch)
      {
        const double adhesion =
          c.cohesion * M_PI * touch.effective_radius * touch.effective_radius;
        const double root = std::sqrt(touch.effective_radius * touch.overlap);
        const double stiffness = 1.5 * c.normal * root;
        const double damping =
          c.damping * std::sqrt(touch.effective_mass * c.normal * root);
        const double tangential = c.tangential * root;
        return {c.normal * root * touch.overlap - adhesion,
                stiffness,
                damping,
                tangential,
                c.damping *
                  std::sqrt(touch.effective_mass * tangential * 2. / 3.),
                adhesion,
                1. / (tangential)};
      }

      static double
      elastic_energy(const Constants &c, const Touch &touch)
      {
        const double adhesion =
          c.cohesion * M_PI * touch.effective_radius * touch.effective_radius;
        return .4 * c.normal *
                 std::sqrt(touch.effective_radius * touch.overlap) *
                 touch.overlap * touch.overlap -
               adhesion * touch.overlap;
      }

      /// That of an elastic impact, 2.94 (m^2 / (R E^2 v))^(1/5) and so on.
      static double
      duration(const Constants &c, const ImpactScale &scale)
      {
        const double k = c.normal * std::sqrt(.5 * scale.radius);
        const double overlap =
          std::pow(1.25 * scale.mass * scale.speed * scale.speed / k, .4);
        return 2.94328 * overlap / scale.speed;
      }
    };



    const Registration<ContactLaw, HertzMindlinLaw> hertz_mindlin_law(
      "hertz mindlin",
      "Hertz's contact with Mindlin's tangential stiffness, and damping that "
      "gives the restitution at any speed.");
  } // namespace
} // namespace Thalweg
