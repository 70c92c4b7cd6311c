// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/plain_text.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Thalweg
{
  namespace
  {
    unsigned char
    byte(const std::string &text, const std::size_t i)
    {
      return i < text.size() ? text[i] : 0;
    }


    /// How many bytes the character at @p i has that can be shown; zero if it
    /// is a control character or no UTF-8.
    std::size_t
    length_of_visible(const std::string &text, const std::size_t i)
    {
      const unsigned char first = byte(text, i), second = byte(text, i + 1);
      if (first < 0x80)
        return first >= 0x20 && first != 0x7f ? 1 : 0;
      const std::size_t n = first >= 0xf0 && first < 0xf5   ? 4
                            : first >= 0xe0 && first < 0xf0 ? 3
                            : first >= 0xc2 && first < 0xe0 ? 2
                                                            : 0;
      for (std::size_t k = 1; k < n; ++k)
        if ((byte(text, i + k) & 0xc0) != 0x80)
          return 0;
      // The second set of control characters; lengths that are too long;
      // halves of pairs of UTF-16; beyond the last character.
      if ((first == 0xc2 && second < 0xa0) ||
          (first == 0xe0 && second < 0xa0) ||
          (first == 0xed && second >= 0xa0) ||
          (first == 0xf0 && second < 0x90) || (first == 0xf4 && second >= 0x90))
        return 0;
      return n;
    }


    std::string
    escaped(const unsigned char byte)
    {
      static const char *const digits = "0123456789abcdef";
      return std::string("\\x") + digits[byte / 16] + digits[byte % 16];
    }


    /// The characters of @p text from @p begin on, made visible, as long as
    /// they have not more than @p longest bytes.
    /// @param end becomes where the rest begins
    std::string
    visible(const std::string &text,
            const std::size_t  begin,
            const std::size_t  longest,
            const bool         keeps_lines,
            std::size_t       &end)
    {
      std::string result;
      for (end = begin; end < text.size();)
        {
          const bool is_kept =
            keeps_lines && (text[end] == '\n' || text[end] == '\t');
          const std::size_t n = is_kept ? 1 : length_of_visible(text, end);
          const std::string character =
            n > 0 ? text.substr(end, n) : escaped(text[end]);
          if (result.size() + character.size() > longest)
            break;
          result += character;
          end += n > 0 ? n : 1;
        }
      return result;
    }


    std::string
    left_out(const std::size_t n)
    {
      return "[... " + std::to_string(n) + " bytes ...]";
    }
  } // namespace



  std::string
  excerpt(const std::string &text, const std::size_t longest)
  {
    std::size_t end;
    std::string whole = visible(text, 0, longest, false, end);
    if (end == text.size())
      return whole;
    const std::string head = visible(text, 0, longest / 2, false, end);
    std::size_t       begin =
      std::max(end, text.size() - std::min(text.size(), longest / 4));
    // Not into the middle of a character.
    while (begin < text.size() && (byte(text, begin) & 0xc0) == 0x80)
      ++begin;
    std::size_t       tail_end;
    const std::string tail = visible(text, begin, longest, false, tail_end);
    return head + (begin > end ? left_out(begin - end) : "") + tail;
  }



  std::string
  bounded_message(const std::string &text, const std::size_t longest)
  {
    std::size_t       end;
    const std::string head = visible(text, 0, longest, true, end);
    return end == text.size() ? head : head + left_out(text.size() - end);
  }


  std::optional<double>
  finite_number(const std::string &text)
  {
    try
      {
        std::size_t  end   = 0;
        const double value = std::stod(text, &end);
        if (end == text.size() && std::isfinite(value))
          return value;
      }
    catch (const std::logic_error &)
      {}
    return {};
  }
} // namespace Thalweg
