#ifndef thalweg_core_section_h
#define thalweg_core_section_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <memory>
#include <string>

namespace Thalweg
{
  /**
   * @brief One section of the input file, while its parameters are declared.
   *
   * A parameter is one line: its name, the variable that holds its default
   * and receives its value, its unit, and a text. Subsections nest by
   * enter(), and the order of declaration is the order in the generated
   * reference.
   */
  class Section
  {
  public:
    /// The root of @p prm, which must outlive this object.
    explicit Section(dealii::ParameterHandler &prm);

    /// Leaves the subsection it entered.
    ~Section();

    Section(const Section &) = delete;
    Section &
    operator=(const Section &) = delete;
    Section(Section &&other) noexcept;

    /// The subsection @p name, open for declarations as long as the returned
    /// object lives.
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
    add(const std::string                       &name,
        T                                       &variable,
        const std::string                       &unit,
        const std::string                       &text,
        const dealii::Patterns::PatternBase     &pattern =
          *dealii::Patterns::Tools::Convert<T>::to_pattern()) const
    {
      prm->add_parameter(name,
                         variable,
                         unit.empty() ? text : text + " [" + unit + "]",
                         pattern);
    }

  private:
    Section(dealii::ParameterHandler &prm, const std::string &name);

    dealii::ParameterHandler *prm;
    bool                      entered;
  };
} // namespace Thalweg

#endif
