// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/dem/contact_forces.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Pairs that touch, of which each has its two grains by itself: so the
    /// load of the first is the force of the pair.
    struct SinglePairs
    {
      std::vector<GrainPlace>    place;
      std::vector<GrainMotion>   motion;
      std::vector<std::uint8_t>  material, own, touching;
      std::vector<std::uint32_t> begin, partner;
      std::vector<Vec3>          slip, roll;

      void
      add(const GrainArrays  &grains,
          const ContactList  &list,
          const std::uint32_t i,
          const std::uint32_t k)
      {
        begin.push_back(partner.size());
        begin.push_back(partner.size() + 1);
        partner.push_back(place.size() + 1);
        for (const std::uint32_t grain : {i, list.partner[k]})
          {
            place.push_back(grains.place[grain]);
            motion.push_back(grains.motion[grain]);
            material.push_back(grains.material[grain]);
            own.push_back(true);
          }
        touching.push_back(true);
        slip.push_back(list.slip[k]);
        roll.push_back(list.roll.empty() ? Vec3{0., 0., 0.} : list.roll[k]);
      }
    };



    /// Whether a pair is counted here, and not on the rank of its other grain.
    bool
    is_counted(const GrainArrays  &grains,
               const std::uint32_t i,
               const std::uint32_t j)
    {
      return (grains.own[i] && grains.own[j]) ||
             (grains.own[i] && grains.id[i] < grains.id[j]) ||
             (grains.own[j] && grains.id[j] < grains.id[i]);
    }
  } // namespace



  std::vector<GrainContact>
  contact_forces(const GrainSystem &system,
                 const ContactLaw  &law,
                 const unsigned int n_materials)
  {
    const GrainArrays        &grains = system.grains();
    const ContactList        &list   = system.contacts();
    SinglePairs               pairs;
    std::vector<GrainContact> found;
    for (std::uint32_t i = 0; i + 1 < list.begin.size(); ++i)
      for (std::uint32_t k = list.begin[i]; k < list.begin[i + 1]; ++k)
        {
          const std::uint32_t j = list.partner[k];
          const double        overlap =
            grains.place[i].r + grains.place[j].r -
            std::sqrt(norm_square(grains.place[i].x - grains.place[j].x));
          if (!(overlap > 0.) || !is_counted(grains, i, j))
            continue;
          pairs.add(grains, list, i, k);
          found.push_back({i, j, {0., 0., 0.}, overlap});
        }
    pairs.begin.push_back(pairs.partner.size());
    std::vector<GrainLoad>    load(pairs.place.size(), GrainLoad());
    std::vector<TouchingPair> hits(found.size() + 1);
    ContactWork               work;
    // In no time: as they are now.
    const PairLoop loop{pairs.place.size(),
                        pairs.place.data(),
                        pairs.motion.data(),
                        load.data(),
                        pairs.material.data(),
                        pairs.own.data(),
                        pairs.begin.data(),
                        pairs.partner.data(),
                        hits.data(),
                        pairs.touching.data(),
                        pairs.slip.data(),
                        pairs.roll.data(),
                        n_materials,
                        system.inertia_factor(),
                        0.,
                        &work};
    law.add_pairs(loop, false);
    for (std::size_t c = 0; c < found.size(); ++c)
      found[c].force = load[2 * c].force;
    return found;
  }
} // namespace Thalweg
