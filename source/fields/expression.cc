// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/plain_text.h>
#include <thalweg/fields/expression.h>

#include <deal.II/base/utilities.h>

#include <cctype>
#include <cmath>
#include <iostream>
#include <sstream>
#include <vector>

namespace Thalweg
{
  namespace
  {
    /// Keeps what others write to the error stream off the terminal as long
    /// as it lives: deal.II writes half of what is wrong with an expression
    /// there, and throws the other half.
    class SilentErrors
    {
    public:
      SilentErrors()
        : terminal(std::cerr.rdbuf(caught.rdbuf()))
      {}

      ~SilentErrors()
      {
        std::cerr.rdbuf(terminal);
      }

      /// What was caught between "Message:  <" and the end of that line.
      std::string
      message() const
      {
        const std::string text  = caught.str();
        const std::size_t begin = text.find('<') + 1;
        return text.substr(begin, text.find(">\n") - begin);
      }

    private:
      std::ostringstream caught;
      std::streambuf    *terminal;
    };



    bool
    is_part_of_name(const char c)
    {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    }



    /// The place of the first comma that does not separate the arguments of a
    /// function. muParser takes 'y - 0,5' as a list, whose value is its last
    /// entry, 5.
    std::size_t
    find_stray_comma(const std::string &text)
    {
      std::vector<bool> is_call;
      char              previous = ' ';
      for (std::size_t i = 0; i < text.size(); ++i)
        {
          const char c = text[i];
          if (c == '(')
            is_call.push_back(is_part_of_name(previous));
          else if (c == ')' && !is_call.empty())
            is_call.pop_back();
          else if (c == ',' && (is_call.empty() || !is_call.back()))
            return i;
          if (c != ' ')
            previous = c;
        }
      return std::string::npos;
    }



    /// Throws unless all commas in @p text separate arguments of functions.
    void
    check_commas(const std::string &text, const std::string &where)
    {
      const std::size_t comma = find_stray_comma(text);
      if (comma == std::string::npos)
        return;
      std::size_t begin = comma, end = comma + 1;
      while (begin > 0 && is_part_of_name(text[begin - 1]))
        --begin;
      while (end < text.size() && is_part_of_name(text[end]))
        ++end;
      const std::string found     = text.substr(begin, end - begin);
      std::string       corrected = found;
      corrected[comma - begin]    = '.';
      AssertThrow(false,
                  dealii::ExcMessage(
                    "The comma of '" + found + "' in the expression '" + where +
                    " = " + excerpt(text) +
                    "' separates no arguments of a function. Decimals are "
                    "written with a point: '" +
                    corrected + "'; components are separated by semicolons."));
    }



    /// A function of the input that refuses values that are no finite
    /// numbers.
    template <int dim>
    class FiniteFunction : public dealii::FunctionParser<dim>
    {
    public:
      FiniteFunction(const unsigned int n_components, const std::string &name)
        : dealii::FunctionParser<dim>(n_components)
        , name(name)
      {}

      double
      value(const dealii::Point<dim> &x,
            const unsigned int        component = 0) const override
      {
        const double value = dealii::FunctionParser<dim>::value(x, component);
        if (std::isfinite(value))
          return value;
        const std::string message = describe(x, value, component);
        if (!ExpressionFaults::remember(message))
          throw dealii::ExcMessage(message);
        return 0.;
      }

      /// The value, whatever it is.
      double
      try_value(const dealii::Point<dim> &x, const unsigned int component) const
      {
        return dealii::FunctionParser<dim>::value(x, component);
      }

    private:
      std::string
      describe(const dealii::Point<dim> &x,
               const double              value,
               const unsigned int        component) const
      {
        std::ostringstream message;
        message.precision(10);
        message << "The expression '" << name << "' is "
                << (std::isnan(value) ? "not a number" : "infinite") << " at ("
                << x << "), t = " << this->get_time() << " s";
        if (this->n_components > 1)
          message << " (its component " << component + 1 << ")";
        message << ". It must be a finite number in all of the domain at all "
                   "times; 'if(condition, value, otherwise)' can keep it away "
                   "from roots of negative numbers and divisions by zero.";
        return message.str();
      }

      const std::string name;
    };



    /// The one that lives.
    ExpressionFaults *keeper = nullptr;
  } // namespace



  ExpressionFaults::ExpressionFaults()
  {
    Assert(keeper == nullptr, dealii::ExcInternalError());
    keeper = this;
  }



  ExpressionFaults::~ExpressionFaults()
  {
    keeper = nullptr;
  }



  void
  ExpressionFaults::check() const
  {
    AssertThrow(first.empty(), dealii::ExcMessage(first));
  }



  bool
  ExpressionFaults::remember(const std::string &message)
  {
    if (keeper == nullptr)
      return false;
    if (keeper->first.empty())
      keeper->first = message;
    return true;
  }



  template <int dim>
  std::unique_ptr<dealii::FunctionParser<dim>>
  parse_expression(const std::string &text,
                   const unsigned int n_components,
                   const std::string &where)
  {
    const auto components   = dealii::Utilities::split_string_list(text, ';');
    const std::string shown = where + " = " + excerpt(text);
    AssertThrow(components.size() == n_components,
                dealii::ExcMessage(
                  "'" + shown + "' has " + std::to_string(components.size()) +
                  " expressions, but " + std::to_string(n_components) +
                  " are needed, separated by semicolons."));
    check_commas(text, where);
    auto function = std::make_unique<FiniteFunction<dim>>(n_components, shown);
    std::string reason;
    {
      const SilentErrors errors;
      try
        {
          function->initialize(
            dealii::FunctionParser<dim>::default_variable_names() + ",t",
            components,
            {{"pi", dealii::numbers::PI}},
            true);
          for (unsigned int i = 0; i < n_components; ++i)
            function->try_value(dealii::Point<dim>(), i);
        }
      catch (const dealii::ExceptionBase &)
        {
          reason = errors.message();
          if (!reason.empty() && reason.back() == '.')
            reason.pop_back();
          if (reason.empty())
            reason = "it is wrong";
        }
    }
    AssertThrow(reason.empty(),
                dealii::ExcMessage(
                  "The expression '" + shown +
                  "' cannot be understood: " + bounded_message(reason, 500) +
                  ". Expressions know x, y" + (dim == 3 ? ", z" : "") +
                  ", t, pi and the functions of muParser, as in "
                  "'if(x < 0.5, 1, sin(2*pi*t))'."));
    return function;
  }



  template <int dim>
  bool
  is_expression(const std::string &text, const unsigned int n_components)
  {
    try
      {
        parse_expression<dim>(text, n_components, "");
        return true;
      }
    catch (const dealii::ExceptionBase &)
      {
        return false;
      }
  }



  bool
  mentions_time(const std::string &text)
  {
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == 't' && (i == 0 || !is_part_of_name(text[i - 1])) &&
          (i + 1 == text.size() || !is_part_of_name(text[i + 1])))
        return true;
    return false;
  }



  template std::unique_ptr<dealii::FunctionParser<2>>
  parse_expression<2>(const std::string &,
                      const unsigned int,
                      const std::string &);
  template std::unique_ptr<dealii::FunctionParser<3>>
  parse_expression<3>(const std::string &,
                      const unsigned int,
                      const std::string &);
  template bool
  is_expression<2>(const std::string &, const unsigned int);
  template bool
  is_expression<3>(const std::string &, const unsigned int);
} // namespace Thalweg
