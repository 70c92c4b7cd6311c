// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/pattern_words.h>
#include <thalweg/core/spelling.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <set>
#include <vector>

namespace Thalweg
{
  using namespace dealii::Patterns;

  namespace
  {
    /// A description "[Kind and the rest]", taken apart.
    struct Description
    {
      explicit Description(const std::string &text)
      {
        const std::size_t end = text.find_first_of(" ]", 1);
        kind                  = text.substr(1, end - 1);
        rest = trimmed(text.substr(end, text.rfind(']') - end));
        for (std::size_t i = 0; i < rest.size(); ++i)
          if (rest[i] == '<')
            {
              const std::size_t begin = i + 1;
              for (unsigned int depth = 1; depth > 0 && ++i < rest.size();)
                depth += (rest[i] == '<') - (rest[i] == '>');
              parts.push_back(rest.substr(begin, i - begin));
            }
      }

      std::string              kind; ///< "List"
      std::string              rest;
      std::vector<std::string> parts; ///< in angle brackets, outermost ones
    };



    /// @p kind with the bounds in @p range, as in "0...MAX_DOUBLE
    /// (inclusive)".
    std::string
    bounded(const std::string &kind, const std::string &range)
    {
      const std::size_t dots = range.find("...");
      if (dots == std::string::npos)
        return kind;
      const std::size_t begin = range.rfind(' ', dots) + 1;
      const std::string lower = range.substr(begin, dots - begin);
      const std::string upper =
        range.substr(dots + 3, range.find(' ', dots) - dots - 3);
      const bool from = lower != "-MAX_DOUBLE" &&
                        lower != std::to_string(Integer::min_int_value);
      const bool to = upper != "MAX_DOUBLE" &&
                      upper != std::to_string(Integer::max_int_value);
      // A tiny positive number as a bound says that zero is excluded.
      const double bound    = from ? std::strtod(lower.c_str(), nullptr) : 0.;
      const bool   positive = bound > 0. && bound < 1e-299;
      if (from && to)
        return kind +
               (positive ? " greater than 0 and up to "
                         : " from " + lower + " to ") +
               upper;
      if (positive)
        return kind + " greater than 0";
      if (from)
        return kind + " that is at least " + lower;
      return to ? kind + " that is at most " + upper : kind;
    }



    std::vector<std::string>
    names_in(const Description &selection)
    {
      std::vector<std::string> names =
        dealii::Utilities::split_string_list(selection.rest, '|');
      for (std::string &name : names)
        name = trimmed(name);
      return names;
    }



    /// "'a', 'b' or 'c'"
    std::string
    alternatives(const Description &selection)
    {
      std::vector<std::string> names = names_in(selection);
      for (std::string &name : names)
        name = "'" + name + "'";
      if (names.size() < 2)
        return joined(names, "");
      const std::string last = names.back();
      names.pop_back();
      return joined(names, ", ") + " or " + last;
    }



    /// How many items a list has, as far as "of length 2...2 (inclusive)"
    /// prescribes it.
    std::string
    count(const Description &list)
    {
      const std::string key   = "of length ";
      const std::size_t begin = list.rest.rfind(key) + key.size();
      const std::size_t dots  = list.rest.find("...", begin);
      const std::string least = list.rest.substr(begin, dots - begin);
      const std::string most =
        list.rest.substr(dots + 3, list.rest.find(' ', dots) - dots - 3);
      if (least == most)
        return least + (least == "1" ? " item" : " items");
      if (most != std::to_string(List::max_int_value))
        return least + " to " + most + " items";
      return least == "0" ? "items" : "at least " + least + " items";
    }



    /// What stands between the items of @p pattern, whose description says
    /// so only where it is not @p otherwise.
    std::string
    separator(const Description &pattern, const std::string &otherwise)
    {
      const std::string key   = "separated by <";
      const std::size_t found = pattern.rest.rfind(key);
      // Those of inner patterns are within angle brackets themselves.
      if (found == std::string::npos || pattern.parts.empty() ||
          pattern.rest.substr(found + key.size(),
                              pattern.parts.back().size()) !=
            pattern.parts.back())
        return otherwise;
      return pattern.parts.back();
    }



    std::string
    separator_in_words(const std::string &separator)
    {
      return separator == ","   ? "commas"
             : separator == ";" ? "semicolons"
             : separator == ":" ? "colons"
                                : "'" + separator + "'";
    }



    std::string
    list_in_words(const Description &list)
    {
      const std::string item = in_words(list.parts.at(0));
      return count(list) + " separated by " +
             separator_in_words(separator(list, ",")) +
             (item == "any text" ? "" : ", each " + item);
    }



    std::string
    tuple_in_words(const Description &tuple)
    {
      const unsigned int       n = std::atoi(tuple.parts.at(0).c_str());
      std::vector<std::string> items;
      for (unsigned int i = 1; i <= n; ++i)
        items.push_back(in_words(tuple.parts.at(i)));
      const bool alike = std::count(items.begin(), items.end(), items[0]) == n;
      return std::to_string(n) + " parts separated by " +
             separator_in_words(separator(tuple, ":")) +
             (alike ? ", each " + items[0] : ": " + joined(items, "; "));
    }
  } // namespace



  std::string
  in_words(const std::string &description)
  {
    const Description pattern(description);
    if (pattern.kind == "Double")
      return bounded("a number", pattern.rest);
    if (pattern.kind == "Integer")
      return bounded("a whole number", pattern.rest);
    if (pattern.kind == "Bool")
      return "'true' or 'false'";
    if (pattern.kind == "Selection")
      return alternatives(pattern);
    if (pattern.kind == "MultipleSelection")
      return "any of " + alternatives(pattern) + ", separated by commas";
    if (pattern.kind == "List")
      return list_in_words(pattern);
    if (pattern.kind == "Tuple")
      return tuple_in_words(pattern);
    if (pattern.kind == "Map")
      return "items 'KEY:VALUE' separated by commas, KEY being " +
             in_words(pattern.parts.at(0)) + " and VALUE " +
             in_words(pattern.parts.at(1));
    if (pattern.kind == "FileName")
      return "the name of a file";
    if (pattern.kind == "DirectoryName")
      return "the name of a directory";
    return "any text";
  }



  std::string
  nearest_in(const std::string &description, const std::string &value)
  {
    const Description pattern(description);
    if (pattern.kind == "Selection")
      {
        const std::vector<std::string> names = names_in(pattern);
        return std::count(names.begin(), names.end(), value) > 0
                 ? ""
                 : nearest(value, names);
      }
    if (pattern.kind == "List")
      for (const std::string &item :
           dealii::Utilities::split_string_list(value, separator(pattern, ",")))
        if (const std::string name = nearest_in(pattern.parts.at(0), item);
            !name.empty())
          return name;
    return "";
  }



  std::string
  repeated_in(const std::string &description, const std::string &value)
  {
    const Description pattern(description);
    if (pattern.kind != "List" ||
        Description(pattern.parts.at(0)).kind != "Selection")
      return "";
    std::set<std::string> names;
    for (const std::string &name :
         dealii::Utilities::split_string_list(value, separator(pattern, ",")))
      if (!names.insert(name).second)
        return name;
    return "";
  }
} // namespace Thalweg
