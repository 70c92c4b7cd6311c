// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_law_of_h
#define thalweg_dem_law_of_h

#include <thalweg/dem/law.h>

namespace Thalweg
{
  template <typename Law, typename Rolling, bool one_material, bool counts>
  THALWEG_FOR_ALL_PROCESSORS void
  run_pairs(const PairLoop &loop, const PairConstants<Law> *constants)
  {
    for_all_pairs<Law, Rolling, one_material, counts>(loop, constants);
  }

  template <typename Law, typename Rolling, bool counts>
  THALWEG_FOR_ALL_PROCESSORS void
  run_walls(const WallLoop &loop, const PairConstants<Law> *constants)
  {
    for_all_walls<Law, Rolling, counts>(loop, constants);
  }

  /**
   * @brief A law of contact out of pure functions, which are compiled into the
   * loops over contacts. @p Law is derived from this class and has
   *
   * - `struct Constants`, what it knows of two materials;
   * - `Constants constants(const PairMaterial &) const`;
   * - `static Response respond(const Constants &, const Touch &)`, inline;
   * - `static double elastic_energy(const Constants &, const Touch &)`, J;
   * - `static double duration(const Constants &, const ImpactScale &)`, s.
   */
  template <typename Law>
  class ContactLawOf : public ContactLaw
  {
  public:
    void
    prepare(const std::vector<PairMaterial> &pairs,
            const RollingModel               rolling_) override
    {
      rolling = rolling_;
      table.clear();
      for (const PairMaterial &pair : pairs)
        table.push_back(
          {static_cast<const Law &>(*this).constants(pair), pair.friction});
    }

    void
    add_pairs(const PairLoop &loop, const bool counts) const override
    {
      with_rolling([&](const auto resistance) {
        using Rolling = std::decay_t<decltype(resistance)>;
        if (table.size() == 1)
          counts ? run_pairs<Law, Rolling, true, true>(loop, table.data())
                 : run_pairs<Law, Rolling, true, false>(loop, table.data());
        else
          counts ? run_pairs<Law, Rolling, false, true>(loop, table.data())
                 : run_pairs<Law, Rolling, false, false>(loop, table.data());
      });
    }

    void
    add_walls(const WallLoop &loop, const bool counts) const override
    {
      with_rolling([&](const auto resistance) {
        using Rolling = std::decay_t<decltype(resistance)>;
        counts ? run_walls<Law, Rolling, true>(loop, table.data())
               : run_walls<Law, Rolling, false>(loop, table.data());
      });
    }

    double
    shortest_contact(const ImpactScale &scale) const override
    {
      double shortest = std::numeric_limits<double>::infinity();
      for (const PairConstants<Law> &pair : table)
        shortest = std::min(shortest, Law::duration(pair.law, scale));
      return shortest;
    }

    Response
    response(const unsigned int pair, const Touch &touch) const override
    {
      return Law::respond(table[pair].law, touch);
    }

    ElasticEnergy
    energy(const unsigned int   pair,
           const Touch         &touch,
           const ContactMemory &memory) const override
    {
      const Response response = Law::respond(table[pair].law, touch);
      const double arm = table[pair].friction.rolling * touch.effective_radius;
      return {Law::elastic_energy(table[pair].law, touch),
              .5 * response.tangential_stiffness * norm_square(memory.slip),
              rolling == RollingModel::epsd
                ? .5 * 2.25 * response.stiffness * arm * arm *
                    norm_square(memory.roll)
                : 0.};
    }

  private:
    template <typename Action>
    void
    with_rolling(const Action &action) const
    {
      if (rolling == RollingModel::none)
        action(FreeRolling());
      else if (rolling == RollingModel::constant_torque)
        action(ConstantTorque());
      else
        action(ElasticPlasticRolling());
    }

    std::vector<PairConstants<Law>> table;
    RollingModel                    rolling = RollingModel::none;
  };
} // namespace Thalweg

#endif
