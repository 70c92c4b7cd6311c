// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/dem/law_of.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /**
     * @brief The contact of a continuum's parts (Eq. 109-115 of seed 000): a bar
     * between the centers with the section pi r_c^2.
     *
     * K_n = a pi r_c^2 E / d, C_n = 2 pi r_c a x sqrt(m K_n) / d (112), and
     * K_s = K_n / (2 (1 + nu)) (115), with the contact radius r_c twice the
     * effective one, which is the grain's for equal grains, and d the sum of
     * the radii. At walls these are those of a grain and its mirror image.
     */
    class ContinuumLinearLaw : public ContactLawOf<ContinuumLinearLaw>
    {
    public:
      struct Constants
      {
        double stiffness;  ///< a pi E, Pa
        double damping;    ///< 2 pi a x
        double tangential; ///< 1 / (2 (1 + nu))
        double cohesion;   ///< N/m^2
      };

      void
      declare_parameters(const Section &section) override
      {
        using dealii::Patterns::Double;
        section.add("Packing factor",
                    packing_factor,
                    "",
                    "alpha_ij of (110), for numbers of contacts and packings "
                    "that are not optimal.",
                    Double(std::numeric_limits<double>::min()));
        section.add("Damping",
                    damping,
                    "",
                    "xi of (112), a part of the critical damping; the "
                    "restitution of the materials is not used.",
                    Double(0));
      }

      void
      check(const std::vector<PairMaterial> &table) const override
      {
        for (const PairMaterial &pair : table)
          AssertThrow(pair.young > 0.,
                      dealii::ExcMessage("The law 'continuum linear' needs "
                                         "Young's moduli above zero."));
      }

      Constants
      constants(const PairMaterial &pair) const
      {
        return {packing_factor * M_PI * pair.young,
                2. * M_PI * packing_factor * damping,
                .5 / (1. + pair.poisson),
                pair.cohesion};
      }

      static THALWEG_INLINE Response
      respond(const Constants &c, const Touch &touch)
      {
        const double adhesion =
          c.cohesion * M_PI * touch.effective_radius * touch.effective_radius;
        const double distance = touch.distance + touch.overlap;
        // At walls the second is the distance.
        const double radius = std::min(2. * touch.effective_radius, distance);
        const double stiffness = c.stiffness * radius * radius / distance;
        const double damping   = c.damping * radius / distance *
                               std::sqrt(touch.effective_mass * stiffness);
        return {stiffness * touch.overlap - adhesion,
                stiffness,
                damping,
                c.tangential * stiffness,
                c.tangential * damping,
                adhesion,
                1. / (c.tangential * stiffness)};
      }

      static double
      elastic_energy(const Constants &c, const Touch &touch)
      {
        const Response response = respond(c, touch);
        return .5 * response.stiffness * touch.overlap * touch.overlap -
               response.adhesion * touch.overlap;
      }

      static double
      duration(const Constants &c, const ImpactScale &scale)
      {
        return M_PI * std::sqrt(scale.mass / (.5 * c.stiffness * scale.radius));
      }

    private:
      double packing_factor = 1., damping = .1;
    };



    const Registration<ContactLaw, ContinuumLinearLaw> continuum_linear_law(
      "continuum linear",
      "a bar between the centers whose stiffness follows from Young's modulus "
      "(Celigueta et al. 2017, Eq. 109-115).");
  } // namespace
} // namespace Thalweg
