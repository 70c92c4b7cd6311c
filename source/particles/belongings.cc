// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/particles/belongings.h>

namespace Thalweg
{
  template <int dim>
  void
  Belongings<dim>::fetch(
    const MPI_Comm                                           communicator,
    const std::map<unsigned int, std::vector<unsigned int>> &wanted,
    std::map<unsigned int, ParticleRows<dim>>               &rows) const
  {
    struct Fixed
    {
      ParticleId         id;
      ParticlePlace<dim> place;
    };
    std::map<unsigned int, std::vector<Fixed>>  fixed;
    std::map<unsigned int, std::vector<double>> properties;
    for (const auto &[rank, indices] : send_plain(communicator, wanted))
      for (const unsigned int index : indices)
        {
          const auto particle = home[index];
          const auto row      = particle.properties();
          fixed[rank].push_back(
            {particle.id(), {particle.position(), particle.reference()}});
          properties[rank].insert(properties[rank].end(),
                                  row.begin(),
                                  row.end());
        }
    const auto their_fixed      = send_plain(communicator, fixed);
    const auto their_properties = send_plain(communicator, properties);
    for (const auto &[rank, list] : their_fixed)
      {
        auto &theirs =
          rows.try_emplace(rank, home.n_properties()).first->second;
        const double *row = their_properties.at(rank).data();
        for (const Fixed &particle : list)
          {
            theirs.append(particle.id, particle.place, row);
            row += home.n_properties();
          }
      }
  }



  THALWEG_INSTANTIATE(Belongings)
} // namespace Thalweg
