// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/dem/contact_list.h>

namespace Thalweg
{
  namespace
  {
    /// Writes the partners of each grain that are less than @p margin apart.
    THALWEG_FOR_ALL_PROCESSORS std::uint32_t
                               nearest_partners(const std::size_t    n_grains,
                                                const std::uint32_t *begin,
                                                const std::uint32_t *partner,
                                                const GrainPlace    *place,
                                                const double         margin,
                                                std::uint32_t       *new_begin,
                                                std::uint32_t       *new_partner)
    {
      std::uint32_t n = 0;
      for (std::size_t i = 0; i < n_grains; ++i)
        {
          new_begin[i]           = n;
          const GrainPlace a     = place[i];
          const double     reach = a.r + margin;
          for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k)
            {
              const std::uint32_t j     = partner[k];
              const double        least = reach + place[j].r;
              new_partner[n]            = j;
              n += norm_square(a.x - place[j].x) < least * least;
            }
        }
      new_begin[n_grains] = n;
      return n;
    }
  } // namespace



  void
  ContactList::clear(const std::size_t n_grains)
  {
    begin.assign(n_grains + 1, 0);
    partner.clear();
    touching.clear();
    slip.clear();
    roll.clear();
  }



  void
  ContactList::prune(const PairList                &neighbours,
                     const std::vector<GrainPlace> &place,
                     const double                   margin)
  {
    const std::size_t n = place.size();
    new_begin.resize(n + 1);
    // One more is written than is kept.
    new_partner.resize(neighbours.begin[n] + 1);
    const std::uint32_t n_pairs = nearest_partners(n,
                                                   neighbours.begin.data(),
                                                   neighbours.partner.data(),
                                                   place.data(),
                                                   margin,
                                                   new_begin.data(),
                                                   new_partner.data());
    new_touching.assign(n_pairs, 0);
    new_slip.assign(n_pairs, {0., 0., 0.});
    if (rolls)
      new_roll.assign(n_pairs, {0., 0., 0.});
    hits.resize(n_pairs + 1);
    for (std::size_t i = 0; i < n; ++i)
      {
        // Both lists have the order of the list of neighbours.
        std::uint32_t to = new_begin[i];
        for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k)
          if (touching[k])
            {
              while (to < new_begin[i + 1] && new_partner[to] < partner[k])
                ++to;
              if (to == new_begin[i + 1])
                break;
              if (new_partner[to] != partner[k])
                continue;
              new_touching[to] = 1;
              new_slip[to]     = slip[k];
              if (rolls)
                new_roll[to] = roll[k];
            }
      }
    begin.swap(new_begin);
    partner.swap(new_partner);
    touching.swap(new_touching);
    slip.swap(new_slip);
    roll.swap(new_roll);
  }



  void
  ContactList::remember(const std::vector<std::uint64_t> &id,
                        const std::vector<std::int32_t>  &row,
                        const ContactTable               &table)
  {
    const auto take = [&](const std::uint32_t i,
                          const std::uint32_t other,
                          const double        sign,
                          const std::uint32_t k) {
      for (std::uint32_t c = table.begin[row[i]]; c < table.begin[row[i] + 1];
           ++c)
        if (table.contacts[c].partner == id[other])
          {
            touching[k] = 1;
            slip[k]     = sign * table.contacts[c].memory.slip;
            if (rolls)
              roll[k] = sign * table.contacts[c].memory.roll;
            return;
          }
    };
    for (std::size_t i = 0; i + 1 < begin.size(); ++i)
      for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k)
        if (row[i] >= 0)
          take(i, partner[k], 1., k);
        else if (row[partner[k]] >= 0)
          take(partner[k], i, -1., k);
  }



  void
  ContactList::write(const std::vector<std::uint64_t> &id,
                     const std::vector<std::uint8_t>  &own,
                     ContactTable                     &table) const
  {
    const std::size_t          n = own.size();
    std::vector<std::uint32_t> next(n + 1, 0);
    const auto                 for_each = [&](const auto &action) {
      for (std::size_t i = 0; i < n; ++i)
        for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k)
          if (touching[k])
            {
              const std::uint32_t j = partner[k];
              if (own[i])
                action(i, j, 1., k);
              if (own[j])
                action(j, i, -1., k);
            }
    };
    for_each([&](const auto i, const auto, const double, const auto) {
      ++next[i + 1];
    });
    for (std::size_t i = 0; i < n; ++i)
      next[i + 1] += next[i];
    table.contacts.resize(next[n]);
    table.begin.assign(1, 0);
    for (std::size_t i = 0; i < n; ++i)
      if (own[i])
        table.begin.push_back(next[i + 1]);
    for_each([&](const auto i, const auto j, const double sign, const auto k) {
      table.contacts[next[i]++] = {id[j],
                                   {sign * slip[k],
                                    rolls ? sign * roll[k] : Vec3{0., 0., 0.}}};
    });
  }
} // namespace Thalweg
