// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/particles/volume_sharing.h>

#include <cmath>

namespace Thalweg
{
  template <int dim>
  void
  share_volume(const std::vector<ParticleReference<dim, false>> &particles)
  {
    constexpr unsigned int volume = Population<dim>::volume_offset;
    double                 sum    = 0;
    for (const auto &particle : particles)
      sum += particle.properties()[volume];
    const double       equal = sum / particles.size();
    const unsigned int n     = particles[0].properties().size();
    for (unsigned int k = Population<dim>::n_properties; k < n; ++k)
      {
        double given = 0., mixture = 0.;
        for (const auto &particle : particles)
          {
            const auto   row    = particle.properties();
            const double excess = row[volume] - equal;
            if (!(excess > 0.) || std::isnan(row[k]))
              continue;
            given += excess;
            mixture += excess * row[k];
          }
        if (!(given > 0.))
          continue;
        mixture /= given;
        for (const auto &particle : particles)
          {
            const auto   row     = particle.properties();
            const double missing = equal - row[volume];
            if (!(missing > 0.))
              continue;
            if (std::isnan(row[k]))
              row[k] = mixture;
            else if (row[volume] > 0.)
              row[k] += missing / equal * (mixture - row[k]);
          }
      }
    for (const auto &particle : particles)
      particle.properties()[volume] = equal;
  }



  template <int dim>
  void
  merge(const ParticleReference<dim, false> &from,
        const ParticleReference<dim, false> &into)
  {
    constexpr unsigned int velocity = Population<dim>::velocity_offset;
    const auto             given    = from.properties();
    const auto             kept     = into.properties();
    const double           added    = given[Population<dim>::volume_offset];
    double                &sum      = kept[Population<dim>::volume_offset];
    sum += added;
    if (sum > 0)
      {
        const auto mix = [&](const unsigned int k) {
          kept[k] += added / sum * (given[k] - kept[k]);
        };
        for (unsigned int d = 0; d < dim; ++d)
          mix(velocity + d);
      }
    for (unsigned int k = Population<dim>::n_properties; k < kept.size(); ++k)
      if (std::isnan(kept[k])) // it says nothing that the other did not
        kept[k] = given[k];
      else if (sum > 0 && !std::isnan(given[k]))
        kept[k] += added / sum * (given[k] - kept[k]);
  }

  template void
  share_volume(const std::vector<ParticleReference<2, false>> &);
  template void
  share_volume(const std::vector<ParticleReference<3, false>> &);
  template void
  merge(const ParticleReference<2, false> &,
        const ParticleReference<2, false> &);
  template void
  merge(const ParticleReference<3, false> &,
        const ParticleReference<3, false> &);
} // namespace Thalweg
