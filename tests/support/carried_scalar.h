// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_support_carried_scalar_h
#define tests_support_carried_scalar_h

#include "support/input.h"

/// A scalar in a flow of a given velocity.
inline std::string
carried_by(const std::string              &velocity,
           const std::vector<std::string> &settings,
           const std::string              &conditions = "",
           const std::string              &flow       = "",
           const std::string              &fluids     = one_fluid(1., 1.))
{
  return section("Methods",
                 {"Names = water: advection, heat: scalar"},
                 section("water", {"Velocity = " + velocity}, fluids + flow) +
                   section("heat", settings, conditions));
}

#endif
