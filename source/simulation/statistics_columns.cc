// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/step_number.h>
#include <thalweg/simulation/statistics_columns.h>

namespace Thalweg
{
  const std::vector<std::string> &
  leading_columns()
  {
    static const std::vector<std::string> columns{
      "step",
      "time [s]",
      "dt [s]",
      StepNumber::courant,
      StepNumber::fourier,
      "cells",
      "dofs",
      "particles",
      "particles added",
      "particles removed",
      "particles left",
      "particles lost",
      "particles lost in all",
      "volume 1 before shift [m^d]",
      "volume 1 [m^d]",
      "volume 2 [m^d]",
      "target volume 1 [m^d]",
      "correction of volume 1 [m^d]",
      "debt of volume 1 [m^d]",
      "drops of volume 1 [m^d]",
      "bubbles of volume 2 [m^d]",
      "carried volume 1 [m^d]",
      "carried volume 2 [m^d]",
      "volume 1 in [m^d]",
      "volume 1 out [m^d]",
      "volume 2 in [m^d]",
      "volume 2 out [m^d]",
      "volume 1 lost [m^d]",
      "volume 2 lost [m^d]",
      "volume 1 owed [m^d]",
      "volume 2 owed [m^d]",
      "level set shift",
      "velocity time [s]",
      "kinetic energy [J]",
      "potential energy [J]",
      "momentum x [kg m/s]",
      "momentum y [kg m/s]",
      "momentum z [kg m/s]",
      "max velocity 1 [m/s]",
      "max velocity 2 [m/s]"};
    return columns;
  }
} // namespace Thalweg
