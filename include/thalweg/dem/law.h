// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_law_h
#define thalweg_dem_law_h

#include <thalweg/dem/pair_loop.h>
#include <thalweg/dem/wall_loop.h>

#include <string>
#include <vector>

namespace Thalweg
{
  class Section;

  /// How rolling is resisted.
  enum class RollingModel
  {
    none,
    constant_torque,
    epsd
  };

  /// What two materials are to each other in a contact.
  struct PairMaterial
  {
    double   effective_young; ///< 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2, Pa
    double   effective_shear; ///< 1/G* = 2(2 - nu1)(1 + nu1)/E1 + ..., Pa
    double   young;           ///< 2 E1 E2 / (E1 + E2), Pa
    double   poisson;         ///< the mean
    double   restitution;
    double   cohesion; ///< N/m^2, on pi R*^2
    Friction friction;
  };

  /// What the shortest contact depends on.
  struct ImpactScale
  {
    double radius; ///< of the smallest grain, m
    double mass;   ///< half of the smallest mass, kg
    double speed;  ///< of the fastest impact, m/s
  };

  /// Springs of a contact, for the sum of energies.
  struct ElasticEnergy
  {
    double normal, tangential, rolling; ///< J
  };

  /**
   * @brief A law of contact as the rest of the program sees it: one virtual
   * call for all pairs; registered.
   *
   * Who writes a law writes its pure functions (see ContactLawOf) and no more.
   */
  class ContactLaw
  {
  public:
    virtual ~ContactLaw() = default;

    virtual void
    declare_parameters(const Section &section) = 0;

    /// What cannot be with these materials. @throws dealii::ExcMessage
    virtual void
    check(const std::vector<PairMaterial> &) const
    {}

    /// Takes over the table of pairs, n * n of them for n materials.
    virtual void
    prepare(const std::vector<PairMaterial> &table,
            const RollingModel               rolling) = 0;

    /// Adds the forces of all pairs. @param counts whether work is summed up
    virtual void
    add_pairs(const PairLoop &loop, const bool counts) const = 0;

    /// The same at walls.
    virtual void
    add_walls(const WallLoop &loop, const bool counts) const = 0;

    /// How long the shortest contact of these materials lasts, s.
    virtual double
    shortest_contact(const ImpactScale &scale) const = 0;

    /// The force of elasticity that two of the given materials need to overlap.
    virtual Response
    response(const unsigned int pair, const Touch &touch) const = 0;

    /// Energy of the springs of a contact, J.
    virtual ElasticEnergy
    energy(const unsigned int   pair,
           const Touch         &touch,
           const ContactMemory &memory) const = 0;
  };
} // namespace Thalweg

#endif
