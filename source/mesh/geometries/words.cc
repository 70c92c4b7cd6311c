// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/plain_text.h>
#include <thalweg/mesh/geometries/words.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace Thalweg
{
  namespace Geometries
  {
    namespace
    {
      bool
      is_blank(const char letter)
      {
        return letter == ' ' || letter == '\t' || letter == '\n';
      }
    } // namespace


    Words::Words(const std::string &text, const std::string &refusal)
      : text(text)
      , refusal(refusal)
    {}


    void
    Words::refuse(const std::string &why) const
    {
      throw dealii::ExcMessage(refusal + ": in line " +
                               std::to_string(line_number) + " " + why + ".");
    }


    void
    Words::skip_blanks()
    {
      for (; position < text.size() && is_blank(text[position]); ++position)
        next_line += text[position] == '\n';
    }


    bool
    Words::at_end()
    {
      skip_blanks();
      return position == text.size();
    }


    std::string
    Words::next(const std::string &name)
    {
      skip_blanks();
      line_number             = next_line;
      const std::size_t begin = position;
      while (position < text.size() && !is_blank(text[position]))
        ++position;
      if (begin == position)
        refuse("it ends where " + name + " must follow; is it complete?");
      return text.substr(begin, position - begin);
    }


    std::string
    Words::rest_of_line(const bool ends_it)
    {
      line_number             = next_line;
      const std::size_t begin = position;
      position                = std::min(text.find('\n', begin), text.size());
      const std::string line  = text.substr(begin, position - begin);
      if (ends_it && position < text.size())
        {
          ++position;
          ++next_line;
        }
      return line;
    }


    void
    Words::skip_to(const std::size_t place)
    {
      for (; position < std::min(place, text.size()); ++position)
        next_line += text[position] == '\n';
    }


    void
    Words::expect(const std::string &word)
    {
      const std::string found = next("'" + word + "'");
      if (found != word)
        refuse("stands '" + excerpt(found) + "' where '" + word +
               "' must follow");
    }


    void
    Words::skip_behind(const std::string &word)
    {
      while (next("'" + word + "'") != word)
        ;
    }


    std::int64_t
    Words::whole(const std::string &name,
                 const std::int64_t least,
                 const std::int64_t most)
    {
      const std::string found = next(name);
      std::int64_t      value = 0;
      const char *const end   = found.data() + found.size();
      const auto        read  = std::from_chars(found.data(), end, value);
      if (read.ec != std::errc() || read.ptr != end || value < least ||
          value > most)
        refuse(name + " is '" + excerpt(found) +
               "', but must be a whole number from " + std::to_string(least) +
               " to " + std::to_string(most));
      return value;
    }


    std::size_t
    Words::count(const std::string &name, const unsigned int words)
    {
      // A word and what separates it from the next one.
      const std::size_t room = (text.size() - position) / (2 * words) + 1;
      const auto n = whole(name, 0, std::numeric_limits<std::int64_t>::max());
      if (static_cast<std::size_t>(n) > room)
        refuse(name + " is " + std::to_string(n) +
               ", but the rest of the file has room for " +
               std::to_string(room) + " at the most");
      return n;
    }


    double
    Words::number(const std::string &name)
    {
      const std::string found = next(name);
      char             *end   = nullptr;
      const double      value = std::strtod(found.c_str(), &end);
      if (end != found.c_str() + found.size() || !std::isfinite(value))
        refuse(name + " is '" + excerpt(found) +
               "', but must be a finite number");
      return value;
    }
  } // namespace Geometries
} // namespace Thalweg
