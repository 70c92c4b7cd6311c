#include <thalweg/fields/expression.h>

#include <deal.II/base/utilities.h>

#include <iostream>
#include <sstream>

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
  } // namespace



  template <int dim>
  std::unique_ptr<dealii::FunctionParser<dim>>
  parse_expression(const std::string &text,
                   const unsigned int n_components,
                   const std::string &where)
  {
    const auto components = dealii::Utilities::split_string_list(text, ';');
    AssertThrow(components.size() == n_components,
                dealii::ExcMessage("'" + where + " = " + text + "' has " +
                                   std::to_string(components.size()) +
                                   " expressions, but " +
                                   std::to_string(n_components) +
                                   " are needed, separated by semicolons."));
    auto function = std::make_unique<dealii::FunctionParser<dim>>(n_components);
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
          dealii::Vector<double> values(n_components);
          function->vector_value(dealii::Point<dim>(), values);
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
                  "The expression '" + where + " = " + text +
                  "' cannot be understood: " + reason +
                  ". Expressions know x, y" + (dim == 3 ? ", z" : "") +
                  ", t, pi and the functions of muParser, as in "
                  "'if(x < 0.5, 1, sin(2*pi*t))'."));
    return function;
  }



  template std::unique_ptr<dealii::FunctionParser<2>>
  parse_expression<2>(const std::string &,
                      const unsigned int,
                      const std::string &);
  template std::unique_ptr<dealii::FunctionParser<3>>
  parse_expression<3>(const std::string &,
                      const unsigned int,
                      const std::string &);
} // namespace Thalweg
