// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/instances.h>
#include <thalweg/core/plain_text.h>
#include <thalweg/core/spelling.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    /// Whether a name can be that of a section and of columns.
    bool
    can_be_name(const std::string &name)
    {
      return !name.empty() && name != "Names" &&
             name.find_first_of("/,:;=#\"'\\|") == std::string::npos;
    }


    void
    check_model(const InstanceName             &instance,
                const std::string              &where,
                const std::vector<std::string> &models)
    {
      if (std::find(models.begin(), models.end(), instance.model) !=
          models.end())
        return;
      throw dealii::ExcMessage("In '" + where + "' '" + excerpt(instance.name) +
                               "' is to be a '" + excerpt(instance.model) +
                               "', and the models are '" +
                               joined(models, "', '") + "'" +
                               did_you_mean(nearest(instance.model, models)));
    }
  } // namespace



  std::vector<InstanceName>
  parse_instances(const std::string              &list,
                  const std::string              &where,
                  const std::vector<std::string> &models)
  {
    std::vector<InstanceName> instances;
    for (const std::string &item :
         dealii::Utilities::split_string_list(list, ','))
      {
        const auto words = dealii::Utilities::split_string_list(item, ':');
        AssertThrow(
          words.size() == 2 && can_be_name(words[0]),
          dealii::ExcMessage(
            "'" + where + "' has '" + excerpt(item) +
            "', which is no name and model: write 'water: pfem2', "
            "with commas between several. A name has none of "
            "/ , : ; = # | and quotation marks, and is not 'Names'."));
        const InstanceName instance{words[0], words[1]};
        check_model(instance, where, models);
        for (const InstanceName &other : instances)
          AssertThrow(other.name != instance.name,
                      dealii::ExcMessage("'" + where + "' has the name '" +
                                         excerpt(instance.name) +
                                         "' twice. Give each its own."));
        instances.push_back(instance);
      }
    return instances;
  }
} // namespace Thalweg
