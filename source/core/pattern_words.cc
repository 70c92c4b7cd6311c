#include <thalweg/core/pattern_words.h>
#include <thalweg/core/spelling.h>

#include <deal.II/base/utilities.h>

#include <cstdlib>

namespace Thalweg
{
  using namespace dealii::Patterns;

  namespace
  {
    /// @p kind with the bounds in @p description, as in
    /// "[Double 0...MAX_DOUBLE (inclusive)]".
    std::string
    bounded(const std::string &kind, const std::string &description)
    {
      const std::size_t dots = description.find("...");
      if (dots == std::string::npos)
        return kind;
      const std::size_t begin = description.rfind(' ', dots) + 1;
      const std::string lower = description.substr(begin, dots - begin);
      const std::string upper =
        description.substr(dots + 3, description.find(' ', dots) - dots - 3);
      const bool from = lower != "-MAX_DOUBLE" &&
                        lower != std::to_string(Integer::min_int_value);
      const bool to = upper != "MAX_DOUBLE" &&
                      upper != std::to_string(Integer::max_int_value);
      if (from && to)
        return kind + " from " + lower + " to " + upper;
      // The smallest positive number as a bound says that zero is excluded.
      const double bound = from ? std::strtod(lower.c_str(), nullptr) : 0.;
      if (bound > 0. && bound < 1e-300)
        return kind + " greater than 0";
      if (from)
        return kind + " that is at least " + lower;
      return to ? kind + " that is at most " + upper : kind;
    }


    /// The names that a selection offers, out of its description
    /// "[Selection a|b|c ]".
    std::vector<std::string>
    names_in(const std::string &description)
    {
      const std::size_t        begin = description.find(' ') + 1;
      std::vector<std::string> names = dealii::Utilities::split_string_list(
        description.substr(begin, description.rfind(']') - begin), '|');
      for (std::string &name : names)
        name = trimmed(name);
      return names;
    }


    /// "'a', 'b' or 'c'"
    std::string
    alternatives(const std::string &description)
    {
      std::vector<std::string> names = names_in(description);
      for (std::string &name : names)
        name = "'" + name + "'";
      if (names.size() < 2)
        return joined(names, "");
      const std::string last = names.back();
      names.pop_back();
      return joined(names, ", ") + " or " + last;
    }


    /// How many items a list has, as far as its @p description,
    /// "[List of <...> of length 2...2 (inclusive)]", prescribes it.
    std::string
    count(const std::string &description)
    {
      const std::string key   = "of length ";
      const std::size_t begin = description.rfind(key) + key.size();
      const std::size_t dots  = description.find("...", begin);
      const std::string least = description.substr(begin, dots - begin);
      const std::string most =
        description.substr(dots + 3, description.find(' ', dots) - dots - 3);
      if (least == most)
        return least + " ";
      if (most != std::to_string(List::max_int_value))
        return least + " to " + most + " ";
      return least != "0" ? "at least " + least + " " : "";
    }


    std::string
    separator_in_words(const std::string &separator)
    {
      return separator == ","   ? "commas"
             : separator == ";" ? "semicolons"
             : separator == ":" ? "colons"
                                : "'" + separator + "'";
    }
  } // namespace


  std::string
  in_words(const dealii::Patterns::PatternBase &pattern)
  {
    const std::string description = pattern.description(PatternBase::Machine);
    if (dynamic_cast<const Double *>(&pattern) != nullptr)
      return bounded("a number", description);
    if (dynamic_cast<const Integer *>(&pattern) != nullptr)
      return bounded("a whole number", description);
    if (dynamic_cast<const Bool *>(&pattern) != nullptr)
      return "'true' or 'false'";
    if (dynamic_cast<const MultipleSelection *>(&pattern) != nullptr)
      return "any of " + alternatives(description) + ", separated by commas";
    if (dynamic_cast<const Selection *>(&pattern) != nullptr)
      return alternatives(description);
    if (const auto *list = dynamic_cast<const List *>(&pattern))
      return count(description) + "items separated by " +
             separator_in_words(list->get_separator()) + ", each " +
             in_words(list->get_base_pattern());
    if (dynamic_cast<const FileName *>(&pattern) != nullptr)
      return "the name of a file";
    if (dynamic_cast<const DirectoryName *>(&pattern) != nullptr)
      return "the name of a directory";
    if (dynamic_cast<const Anything *>(&pattern) != nullptr)
      return "any text";
    return pattern.description(PatternBase::Text);
  }


  std::string
  nearest_in(const PatternBase &pattern, const std::string &value)
  {
    if (const auto *list = dynamic_cast<const List *>(&pattern))
      {
        for (const std::string &item :
             dealii::Utilities::split_string_list(value, list->get_separator()))
          if (!list->get_base_pattern().match(item))
            return nearest_in(list->get_base_pattern(), item);
        return "";
      }
    if (dynamic_cast<const Selection *>(&pattern) == nullptr)
      return "";
    return nearest(value, names_in(pattern.description(PatternBase::Machine)));
  }
} // namespace Thalweg
