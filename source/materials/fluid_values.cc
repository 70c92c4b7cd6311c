// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/plain_text.h>
#include <thalweg/materials/fluid_values.h>

#include <deal.II/base/utilities.h>

namespace Thalweg
{
  namespace
  {
    double
    read_value(const std::string &text,
               const double       least,
               const std::string &where)
    {
      const auto value = finite_number(text);
      AssertThrow(value.has_value(),
                  dealii::ExcMessage("'" + where + "' has '" + excerpt(text) +
                                     "' where a number is expected: write "
                                     "'0.1', or 'water: 0.1, air: 2' with the "
                                     "names in 'Fluids'."));
      AssertThrow(*value >= least,
                  dealii::ExcMessage(
                    "'" + where + "' has " + excerpt(text) +
                    ", but it must be " +
                    (least > 0. ? "positive." : "at least 0.")));
      return *value;
    }
  } // namespace



  std::array<double, 2>
  read_fluid_values(const std::string &text,
                    const Fluids      &fluids,
                    const double       least,
                    const std::string &where)
  {
    using dealii::Utilities::trim;
    if (text.find(':') == std::string::npos)
      {
        const double value = read_value(trim(text), least, where);
        return {{value, value}};
      }
    std::array<double, 2> values{};
    std::array<bool, 2>   is_given{};
    for (const std::string &entry :
         dealii::Utilities::split_string_list(text, ','))
      {
        const auto colon = entry.find(':');
        AssertThrow(colon != std::string::npos,
                    dealii::ExcMessage("'" + excerpt(entry) + "' in '" + where +
                                       "' should be 'fluid: number'."));
        const unsigned int f = fluids.index(trim(entry.substr(0, colon)));
        AssertThrow(!is_given[f],
                    dealii::ExcMessage("'" + where + "' has '" +
                                       fluids[f].name +
                                       "' twice; remove one of them."));
        is_given[f] = true;
        values[f]   = read_value(trim(entry.substr(colon + 1)), least, where);
      }
    for (unsigned int f = 0; f < fluids.size(); ++f)
      AssertThrow(is_given[f],
                  dealii::ExcMessage("'" + where + "' says nothing of '" +
                                     fluids[f].name + "': add '" +
                                     fluids[f].name + ": number'."));
    if (fluids.size() == 1)
      values[1] = values[0];
    return values;
  }
} // namespace Thalweg
