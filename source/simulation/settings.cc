// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/declared.h>
#include <thalweg/core/plain_text.h>
#include <thalweg/simulation/settings.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    /// Sections and parameters that give the state its meaning.
    const std::vector<std::string> critical_names{"Dimension",
                                                  "Geometry/",
                                                  "Fluids/",
                                                  "Method/",
                                                  "Partition/",
                                                  "Particles/Carry",
                                                  "Particles/Distance band"};

    bool
    is_critical(const std::string &name)
    {
      return std::any_of(critical_names.begin(),
                         critical_names.end(),
                         [&](const std::string &critical) {
                           return name.compare(0, critical.size(), critical) ==
                                  0;
                         });
    }
  } // namespace



  Settings
  settings_of(const dealii::ParameterHandler &prm)
  {
    Settings settings;
    for (const DeclaredParameter &parameter : Declared(prm).parameters)
      settings[parameter.path] = dealii::Utilities::trim(parameter.value);
    return settings;
  }



  SettingsDifference
  compare(const Settings &saved, const Settings &present)
  {
    SettingsDifference difference;
    for (const auto &[name, value] : present)
      {
        const auto old = saved.find(name);
        if (old == saved.end() || old->second == value)
          continue;
        (is_critical(name) ? difference.critical : difference.others)
          .push_back("'" + name + "' was '" + excerpt(old->second) +
                     "' and is '" + excerpt(value) + "'");
      }
    return difference;
  }
} // namespace Thalweg
