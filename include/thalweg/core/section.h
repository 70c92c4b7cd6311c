// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_section_h
#define thalweg_core_section_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace Thalweg
{
  class ParameterFile;

  /**
   * @brief One section of the input file, while its parameters are declared.
   *
   * A parameter is one line: its name, the variable that holds its default
   * and receives its value, its unit, and a text. Subsections nest by
   * enter(), and the order of declaration is the order in the generated
   * reference. Several sections may be in use at the same time.
   */
  class Section
  {
  public:
    /// The root of @p prm, which must outlive this object.
    explicit Section(dealii::ParameterHandler &prm);

    /// The same section, which knows what the user wrote. @param file must
    /// outlive the sections that are made out of it
    Section
    with(const ParameterFile &file) const;

    /// What the user gives the parameter @p name of this section, before that
    /// is declared: for lists of names that decide which sections there are.
    std::string
    given(const std::string &name, const std::string &otherwise) const;

    /// The subsection @p name. It exists from now on, even if nothing is
    /// declared in it.
    Section
    enter(const std::string &name) const;

    /**
     * @brief Declares a parameter.
     *
     * @param name as written in the input file
     * @param variable holds the default now and the value after parsing; it
     *   must outlive the ParameterHandler
     * @param unit in SI, for example "m/s"; empty where there is none
     * @param text one or two sentences for the reference
     * @param pattern which values are allowed
     */
    template <typename T>
    void
    add(const std::string                   &name,
        T                                   &variable,
        const std::string                   &unit,
        const std::string                   &text,
        const dealii::Patterns::PatternBase &pattern =
          *natural_pattern<T>()) const
    {
      enter_path();
      prm->add_parameter(name,
                         variable,
                         unit.empty() ? text : text + " [" + unit + "]",
                         pattern);
      leave_path();
    }

  private:
    /// All that a variable of type @p T can hold. deal.II's own pattern for
    /// unsigned numbers lets negative ones pass.
    template <typename T>
    static std::unique_ptr<dealii::Patterns::PatternBase>
    natural_pattern()
    {
      if constexpr (std::is_same_v<T, unsigned int>)
        return std::make_unique<dealii::Patterns::Integer>(0);
      else if constexpr (std::is_same_v<T, std::vector<unsigned int>>)
        return std::make_unique<dealii::Patterns::List>(
          dealii::Patterns::Integer(0));
      else
        return dealii::Patterns::Tools::Convert<T>::to_pattern();
    }

    void
    enter_path() const;

    void
    leave_path() const;

    dealii::ParameterHandler *prm;
    const ParameterFile      *input = nullptr;
    std::vector<std::string>  path; ///< from the root to this section
  };
} // namespace Thalweg

#endif
