// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_settings_h
#define thalweg_simulation_settings_h

#include <map>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Thalweg
{
  /// All parameters with their values, by "Section/Name".
  using Settings = std::map<std::string, std::string>;

  Settings
  settings_of(const dealii::ParameterHandler &prm);

  /// Differences between the settings of two runs, one sentence each.
  struct SettingsDifference
  {
    /// Those with which the state of one run means nothing in the other: the
    /// dimension, what particles carry, and whatever is in the sections
    /// "Geometry", "Fluids" and "Method".
    std::vector<std::string> critical;
    std::vector<std::string> others;
  };

  SettingsDifference
  compare(const Settings &saved, const Settings &present);
} // namespace Thalweg

#endif
