#include <thalweg/simulation/settings.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    /// Sections and parameters that give the state its meaning.
    const std::vector<std::string> critical_names{"Dimension",
                                                  "Geometry/",
                                                  "Fluids/",
                                                  "Method/",
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

    bool
    begins_with(const std::string &line, const std::string &word)
    {
      return line.compare(0, word.size(), word) == 0;
    }
  } // namespace



  Settings
  settings_of(const dealii::ParameterHandler &prm)
  {
    std::stringstream text;
    prm.print_parameters(text,
                         static_cast<dealii::ParameterHandler::OutputStyle>(
                           dealii::ParameterHandler::PRM |
                           dealii::ParameterHandler::Short));
    Settings                 settings;
    std::vector<std::string> sections;
    for (std::string line; std::getline(text, line);)
      {
        line = dealii::Utilities::trim(line);
        if (begins_with(line, "subsection "))
          sections.push_back(line.substr(11) + "/");
        else if (line == "end")
          sections.pop_back();
        else if (begins_with(line, "set "))
          {
            const auto  equals = line.find('=');
            std::string name;
            for (const std::string &section : sections)
              name += section;
            name += dealii::Utilities::trim(line.substr(4, equals - 4));
            settings[name] = dealii::Utilities::trim(line.substr(equals + 1));
          }
      }
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
          .push_back("'" + name + "' was '" + old->second + "' and is '" +
                     value + "'");
      }
    return difference;
  }
} // namespace Thalweg
