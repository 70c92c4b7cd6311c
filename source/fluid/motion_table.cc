// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/plain_text.h>
#include <thalweg/core/spelling.h>
#include <thalweg/core/text_file.h>
#include <thalweg/fluid/motion_table.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    /// The words of a line without its comment.
    std::vector<std::string>
    words_of(std::string line)
    {
      line = line.substr(0, line.find('#'));
      for (char &letter : line)
        if (letter == ',' || letter == ';' || letter == '\r')
          letter = ' ';
      std::istringstream       stream(line);
      std::vector<std::string> words;
      for (std::string word; stream >> word;)
        words.push_back(word);
      return words;
    }


    void
    check_names(const std::vector<std::string> &names,
                const std::vector<std::string> &allowed,
                const std::string              &place)
    {
      AssertThrow(names.size() > 1 && names[0] == "t",
                  dealii::ExcMessage(
                    place +
                    ": the first line must name the columns, 't' and "
                    "then some of " +
                    joined(allowed, ", ") + "; it is '" +
                    excerpt(joined(names, " ")) + "'."));
      for (unsigned int c = 1; c < names.size(); ++c)
        {
          AssertThrow(std::find(allowed.begin(), allowed.end(), names[c]) !=
                        allowed.end(),
                      dealii::ExcMessage(
                        place + ": unknown column '" + excerpt(names[c]) +
                        "'; it may be one of " + joined(allowed, ", ") + "."));
          AssertThrow(std::count(names.begin(), names.end(), names[c]) == 1,
                      dealii::ExcMessage(place + ": two columns are called '" +
                                         names[c] + "'."));
        }
    }


    double
    number(const std::string &word, const std::string &place)
    {
      const auto value = finite_number(word);
      AssertThrow(value.has_value(),
                  dealii::ExcMessage(place + ": '" + excerpt(word) +
                                     "' is not a number."));
      return *value;
    }


    void
    check_times(const std::vector<double> &t,
                const double               end,
                const std::string         &file)
    {
      std::ostringstream range;
      if (!t.empty())
        range << " It goes from t = " << t.front() << " s to " << t.back()
              << " s.";
      AssertThrow(t.size() > 1,
                  dealii::ExcMessage(file + " has fewer than two rows." +
                                     range.str()));
      std::ostringstream message;
      message << file << " must cover the whole run, from 0 to 'Time/End time' "
              << "= " << end << " s." << range.str();
      AssertThrow(t.front() <= 0. && t.back() >= end * (1. - 1e-12),
                  dealii::ExcMessage(message.str()));
    }
  } // namespace



  std::map<std::string, std::vector<double>>
  read_motion_table(const std::string              &path,
                    const std::vector<std::string> &allowed,
                    const double                    end,
                    const std::string              &where)
  {
    const std::string what =
      "The table '" + excerpt(path) + "' of '" + where + "'";
    constexpr std::size_t most_bytes = 100000000;
    std::istringstream    stream(
      plain_lines(read_text_file(with_home(path), what, most_bytes).content,
                  what));
    std::vector<std::string>         names;
    std::vector<std::vector<double>> columns;
    unsigned int                     line_number = 0;
    for (std::string line; std::getline(stream, line);)
      {
        const std::string place =
          excerpt(path) + ":" + std::to_string(++line_number);
        const auto words = words_of(line);
        if (words.empty())
          continue;
        if (names.empty())
          {
            check_names(words, allowed, place);
            names = words;
            columns.resize(names.size());
            continue;
          }
        AssertThrow(words.size() == names.size(),
                    dealii::ExcMessage(
                      place + ": " + std::to_string(words.size()) +
                      " numbers for " + std::to_string(names.size()) +
                      " columns."));
        for (unsigned int c = 0; c < words.size(); ++c)
          columns[c].push_back(number(words[c], place));
        const auto &t = columns[0];
        AssertThrow(t.size() < 2 || t[t.size() - 1] > t[t.size() - 2],
                    dealii::ExcMessage(place +
                                       ": the time must grow from row to "
                                       "row."));
      }
    AssertThrow(!names.empty(), dealii::ExcMessage(what + " is empty."));
    check_times(columns[0], end, what);
    std::map<std::string, std::vector<double>> table;
    for (unsigned int c = 0; c < names.size(); ++c)
      table[names[c]] = columns[c];
    return table;
  }
} // namespace Thalweg
