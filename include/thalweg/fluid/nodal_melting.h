// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_nodal_melting_h
#define thalweg_fluid_nodal_melting_h

#include <thalweg/fields/node_space.h>
#include <thalweg/materials/melting.h>

namespace Thalweg
{
  /**
   * @brief Melting at the nodes of a mesh, around which there may be two
   * fluids, of which one melts.
   *
   * Vectors of heat, value and molten part are ghosted and consistent; what is
   * divided at the nodes is interpolated at those that depend on others.
   */
  template <int dim>
  class NodalMelting
  {
  public:
    /// @param space must outlive the object
    NodalMelting(const NodeSpace<dim> &space, const Melting &law);

    /// Whether anything melts. If not, heat is the value, and nothing of the
    /// rest is needed.
    bool
    is_active() const
    {
      return law.latent > 0.;
    }

    /// What there is around the nodes, which update() has to be told of.
    Vector &
    latent_heat()
    {
      return lumped;
    }

    /// Says that the lumped latent heats, in units of the scalar times the
    /// capacity, owned values, are new. Collective. @param capacity lumped
    void
    update(const Vector &capacity);

    /// The law at an owned node.
    Melting
    at(const unsigned int node) const
    {
      return {latent.local_element(node), law.solidus, law.liquidus};
    }

    /// heat = value + latent molten
    void
    join(const Vector &value, const Vector &molten, Vector &heat) const;

    /// The value that belongs to heat. Collective.
    void
    find_value(const Vector &heat, Vector &value) const
    {
      find(heat, &Melting::value, value);
    }

    /// The molten part that belongs to heat. Collective.
    void
    find_molten(const Vector &heat, Vector &molten) const
    {
      find(heat, &Melting::molten, molten);
    }

    /// Which part is molten of all that can be. Collective.
    double
    molten_part(const Vector &molten) const;

  private:
    /// What the law at each node finds in a heat.
    void
    find(const Vector &heat,
         double (Melting::*part)(const double) const,
         Vector &result) const;

    const NodeSpace<dim> &space;
    const Melting         law;
    Vector                lumped; ///< latent heats
    Vector                latent; ///< those over the capacities
  };
} // namespace Thalweg

#endif
