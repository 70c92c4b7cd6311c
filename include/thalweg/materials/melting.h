// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_materials_melting_h
#define thalweg_materials_melting_h

#include <algorithm>
#include <cstdint>

namespace Thalweg
{
  /**
   * @brief How what a volume holds is divided between a scalar s, its
   * temperature, and its molten part f.
   *
   * Heat, in units of the scalar (what is held over the capacity), is
   * h = s + latent f. Below the solidus f is 0, above the liquidus 1, and
   * between them it grows with s in a straight line; if both are the same, s
   * stays there until all has molten (the enthalpy method, V. R. Voller and
   * M. Cross, Int. J. Heat Mass Transfer 24, 1981, p. 545).
   */
  struct Melting
  {
    double latent   = 0.; ///< latent heat over the capacity; 0: nothing melts
    double solidus  = 0.;
    double liquidus = 0.;

    /// How much heat it takes from the first melt to the last solid.
    double
    range() const
    {
      return liquidus - solidus + latent;
    }

    /// The molten part.
    double
    molten(const double heat) const
    {
      return range() > 0.      ? std::clamp((heat - solidus) / range(), 0., 1.)
             : heat > liquidus ? 1.
                               : 0.;
    }

    /// The molten part of what has come to a value by itself; of a solid at a
    /// single melting point nothing.
    double
    molten_at(const double value) const
    {
      return value <= solidus    ? 0.
             : value >= liquidus ? 1.
                                 : (value - solidus) / (liquidus - solidus);
    }

    double
    heat(const double value, const double molten_part) const
    {
      return value + latent * molten_part;
    }

    double
    value(const double heat) const
    {
      return heat - latent * molten(heat);
    }

    enum class State : std::uint8_t
    {
      solid,
      melting,
      liquid
    };

    State
    state(const double heat) const
    {
      return heat <= solidus             ? State::solid
             : heat >= solidus + range() ? State::liquid
                                         : State::melting;
    }

    /// How much the value changes with the heat.
    double
    slope(const State state) const
    {
      return state == State::melting ? (liquidus - solidus) / range() : 1.;
    }
  };
} // namespace Thalweg

#endif
