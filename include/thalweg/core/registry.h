// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_registry_h
#define thalweg_core_registry_h

#include <thalweg/core/section.h>

#include <deal.II/base/exceptions.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief The models of one kind that can be chosen by name.
   *
   * A model registers itself in its own source file with THALWEG_REGISTER;
   * the allowed names, the parameters of each model and the generated
   * reference follow from that one line.
   *
   * @tparam Interface the base class, with a virtual destructor and
   *   `virtual void declare_parameters(const Section &)`
   */
  template <typename Interface>
  class Registry
  {
  public:
    /// How to make a model, and what to say of it.
    struct Entry
    {
      std::string                                 text;
      std::function<std::unique_ptr<Interface>()> make;
    };

    /// All registered models by name.
    static std::map<std::string, Entry> &
    entries()
    {
      static std::map<std::string, Entry> all;
      return all;
    }

    /// The names joined by '|', as patterns want them.
    static std::string
    names()
    {
      std::string joined;
      for (const auto &[name, entry] : entries())
        joined += (joined.empty() ? "" : "|") + name;
      return joined;
    }

    /// A list of the models, a line each, for the reference.
    static std::string
    description()
    {
      std::string text;
      for (const auto &[name, entry] : entries())
        text += "\n`" + name + "`: " + entry.text;
      return text;
    }
  };

  /// Registers @p Model while the library is loaded.
  template <typename Interface, typename Model>
  struct Registration
  {
    Registration(const std::string &name, const std::string &text)
    {
      Registry<Interface>::entries()[name] = {
        text, []() { return std::make_unique<Model>(); }};
    }
  };

  /**
   * @brief One model out of a registry, chosen in the input file.
   *
   * Every model's parameters are declared (each in a subsection of its own
   * name), so that the reference shows them and a file may keep the
   * settings of a model that it does not use at the moment.
   */
  template <typename Interface>
  class Choice
  {
  public:
    /**
     * @brief Declares "Model" and the subsections of all models.
     * @param section where the choice stands
     * @param default_name the model that is used when the file is silent
     * @param what completes "Which ... is used."
     */
    void
    declare_parameters(const Section     &section,
                       const std::string &default_name,
                       const std::string &what)
    {
      name = default_name;
      section.add("Model",
                  name,
                  "",
                  "Which " + what + " is used." +
                    Registry<Interface>::description(),
                  dealii::Patterns::Selection(Registry<Interface>::names()));
      for (const auto &[model_name, entry] : Registry<Interface>::entries())
        {
          const Section subsection = section.enter(model_name);
          models[model_name]       = entry.make();
          models[model_name]->declare_parameters(subsection);
        }
    }

    /// The chosen model; valid after the input was read.
    Interface &
    operator*() const
    {
      return *models.at(name);
    }

    /// The chosen model; valid after the input was read.
    Interface *
    operator->() const
    {
      return models.at(name).get();
    }

    /// The model called @p model_name, chosen or not; nullptr: there is none.
    Interface *
    find(const std::string &model_name) const
    {
      const auto model = models.find(model_name);
      return model == models.end() ? nullptr : model->second.get();
    }

    /// The chosen model's name.
    const std::string &
    model_name() const
    {
      return name;
    }

  private:
    std::string                                       name;
    std::map<std::string, std::unique_ptr<Interface>> models;
  };

  /**
   * @brief Any number of models out of a registry, each with a "Use" switch
   * by a list of names.
   */
  template <typename Interface>
  class Choices
  {
  public:
    /**
     * @brief Declares "Models" and the subsections of all models.
     * @param section where the choices stand
     * @param what completes "Which ... are used, separated by commas."
     */
    void
    declare_parameters(const Section &section, const std::string &what)
    {
      section.add("Models",
                  names,
                  "",
                  "Which " + what + " are used, separated by commas." +
                    Registry<Interface>::description(),
                  dealii::Patterns::List(
                    dealii::Patterns::Selection(Registry<Interface>::names())));
      for (const auto &[model_name, entry] : Registry<Interface>::entries())
        {
          const Section subsection = section.enter(model_name);
          models[model_name]       = entry.make();
          models[model_name]->declare_parameters(subsection);
        }
    }

    /// The chosen models in the order of the input file.
    std::vector<Interface *>
    chosen() const
    {
      std::vector<Interface *> list;
      for (const std::string &name : names)
        list.push_back(models.at(name).get());
      return list;
    }

    /// Their names, in the same order.
    const std::vector<std::string> &
    chosen_names() const
    {
      return names;
    }

  private:
    std::vector<std::string>                          names;
    std::map<std::string, std::unique_ptr<Interface>> models;
  };
} // namespace Thalweg

/// Registers the class template @p Model, in two and three dimensions, as a
/// model of the kind @p Interface under @p name with the description @p text.
#define THALWEG_REGISTER(Interface, Model, name, text)                      \
  namespace                                                                 \
  {                                                                         \
    const ::Thalweg::Registration<Interface<2>, Model<2>> Model##_2d(name,  \
                                                                     text); \
    const ::Thalweg::Registration<Interface<3>, Model<3>> Model##_3d(name,  \
                                                                     text); \
  }

/// Instantiates a class template in two and three dimensions.
#define THALWEG_INSTANTIATE(Class) \
  template class Class<2>;         \
  template class Class<3>;

#endif
