#include <thalweg/fields/expression.h>

#include <deal.II/base/utilities.h>

namespace Thalweg
{
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
    auto function =
      std::make_unique<dealii::FunctionParser<dim>>(n_components);
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
    catch (const dealii::ExceptionBase &exception)
      {
        std::string reason = exception.what();
        const auto  begin  = reason.find("Message:");
        if (begin != std::string::npos)
          {
            reason = reason.substr(begin + 8);
            reason = reason.substr(0, reason.find('\n'));
          }
        AssertThrow(false,
                    dealii::ExcMessage(
                      "The expression '" + where + " = " + text +
                      "' cannot be understood:" + reason +
                      ". Expressions know x, y" + (dim == 3 ? ", z" : "") +
                      ", t, pi and the functions of muParser, as in "
                      "'if(x < 0.5, 1, sin(2*pi*t))'."));
      }
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
