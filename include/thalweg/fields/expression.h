// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_expression_h
#define thalweg_fields_expression_h

#include <deal.II/base/function_parser.h>

#include <memory>
#include <string>

namespace Thalweg
{
  /**
   * @brief A function of x, y(, z) and t from expressions as users write
   * them in the input file.
   * @param text the components separated by semicolons
   * @param n_components how many there must be
   * @param where the parameter, for the message
   * @return a function that throws dealii::ExcMessage where it is evaluated
   *   to infinity or to what is no number, with the place and the time, or
   *   leaves that to ExpressionFaults
   * @throws dealii::ExcMessage for a wrong number of components, a comma that
   *   separates no arguments or a syntax that muParser refuses, naming
   *   @p where
   */
  template <int dim>
  std::unique_ptr<dealii::FunctionParser<dim>>
  parse_expression(const std::string &text,
                   const unsigned int n_components,
                   const std::string &where);

  /// Whether parse_expression() has no objection.
  template <int dim>
  bool
  is_expression(const std::string &text, const unsigned int n_components);

  /**
   * @brief As long as it lives, expressions that are no finite number yield 0
   * and it remembers the first of them, so that what is under way comes to an
   * end on all processes. One at a time.
   */
  class ExpressionFaults
  {
  public:
    ExpressionFaults();

    ~ExpressionFaults();

    ExpressionFaults(const ExpressionFaults &) = delete;
    ExpressionFaults &
    operator=(const ExpressionFaults &) = delete;

    /// @throws dealii::ExcMessage if an expression of this process was no
    ///   finite number, saying which, where and when
    void
    check() const;

    /// Keeps @p message if it is the first.
    /// @return whether there is one that keeps messages
    static bool
    remember(const std::string &message);

  private:
    std::string first;
  };

  /// Whether an expression depends on the time.
  bool
  mentions_time(const std::string &text);
} // namespace Thalweg

#endif
