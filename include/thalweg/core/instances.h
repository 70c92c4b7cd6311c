// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_instances_h
#define thalweg_core_instances_h

#include <thalweg/core/registry.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Thalweg
{
  /// A name and what it is an instance of, as users write them.
  struct InstanceName
  {
    std::string name;
    std::string model;
  };

  /**
   * @brief Reads "water: pfem2, dye: tracers".
   * @param where the parameter, for messages
   * @param models that there are
   * @throws dealii::ExcMessage for a model that is not there, a name that is
   *   given twice or that cannot be the name of a section
   */
  std::vector<InstanceName>
  parse_instances(const std::string              &list,
                  const std::string              &where,
                  const std::vector<std::string> &models);

  /**
   * @brief Any number of objects of registered models, each with a name of
   * the user's: several may be of the same model.
   */
  template <typename Interface>
  class Instances
  {
  public:
    struct Instance
    {
      std::string                name;
      std::string                model;
      std::unique_ptr<Interface> object;
    };

    /// Makes those of a list, see parse_instances().
    void
    make(const std::string &list, const std::string &where)
    {
      std::vector<std::string> models;
      for (const auto &[model, entry] : Registry<Interface>::entries())
        models.push_back(model);
      for (const auto &[name, model] : parse_instances(list, where, models))
        instances.push_back(
          {name, model, Registry<Interface>::entries().at(model).make()});
    }

    bool
    empty() const
    {
      return instances.empty();
    }

    auto
    begin() const
    {
      return instances.begin();
    }

    auto
    end() const
    {
      return instances.end();
    }

  private:
    std::vector<Instance> instances;
  };
} // namespace Thalweg

#endif
