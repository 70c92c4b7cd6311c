// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/spelling.h>

#include <algorithm>
#include <cctype>

namespace Thalweg
{
  unsigned int
  edit_distance(const std::string &a, const std::string &b)
  {
    const auto same = [](const char x, const char y) {
      return std::tolower(static_cast<unsigned char>(x)) ==
             std::tolower(static_cast<unsigned char>(y));
    };
    std::vector<std::vector<unsigned int>> cost(
      a.size() + 1, std::vector<unsigned int>(b.size() + 1, 0));
    for (std::size_t i = 0; i <= a.size(); ++i)
      for (std::size_t j = 0; j <= b.size(); ++j)
        if (i == 0 || j == 0)
          cost[i][j] = i + j;
        else
          {
            cost[i][j] = std::min(
              {cost[i - 1][j] + 1,
               cost[i][j - 1] + 1,
               cost[i - 1][j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1)});
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) &&
                same(a[i - 2], b[j - 1]))
              cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
          }
    return cost[a.size()][b.size()];
  }


  std::string
  nearest(const std::string &text, const std::vector<std::string> &candidates)
  {
    // More than a third of the letters wrong is another word.
    unsigned int smallest = std::max<std::size_t>(2, text.size() / 3) + 1;
    std::string  best;
    for (const std::string &candidate : candidates)
      {
        // So many letters must be added at least.
        const std::size_t more = text.size() < candidate.size()
                                   ? candidate.size() - text.size()
                                   : text.size() - candidate.size();
        if (more >= smallest)
          continue;
        const unsigned int distance = edit_distance(text, candidate);
        if (distance < smallest && distance < candidate.size())
          {
            smallest = distance;
            best     = candidate;
          }
      }
    return best;
  }


  std::string
  did_you_mean(const std::string &suggestion)
  {
    return suggestion.empty() ? "" : "; did you mean '" + suggestion + "'?";
  }


  std::string
  trimmed(const std::string &text)
  {
    const char *const blank = " \t\r\n";
    const std::size_t first = text.find_first_not_of(blank);
    if (first == std::string::npos)
      return "";
    return text.substr(first, text.find_last_not_of(blank) - first + 1);
  }


  std::string
  joined(const std::vector<std::string> &parts, const std::string &separator)
  {
    std::string text;
    for (std::size_t i = 0; i < parts.size(); ++i)
      text += (i > 0 ? separator : "") + parts[i];
    return text;
  }
} // namespace Thalweg
