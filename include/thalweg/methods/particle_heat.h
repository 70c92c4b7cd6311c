// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_particle_heat_h
#define thalweg_methods_particle_heat_h

#include <thalweg/materials/melting.h>

#include <array>

namespace Thalweg
{
  /// Where particles carry a scalar and their molten part, and how each of the
  /// fluids melts. Both get the increments of the mesh, where they are
  /// balanced: what is between nodes that melt and others is a bit of either.
  struct ParticleHeat
  {
    unsigned int           value  = 0; ///< place in the row of a particle
    unsigned int           molten = 0; ///< likewise, if something melts
    std::array<Melting, 2> laws{};

    bool
    melts(const unsigned int fluid) const
    {
      return laws[fluid].latent > 0.;
    }

    /// In units of the scalar. @param row of a particle of that fluid
    template <typename Row>
    double
    of(const unsigned int fluid, const Row &row) const
    {
      return melts(fluid) ? laws[fluid].heat(row[value], row[molten])
                          : row[value];
    }
  };
} // namespace Thalweg

#endif
