// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_spelling_h
#define thalweg_core_spelling_h

#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief How many letters must be inserted, deleted, replaced or swapped
   * with their neighbour to make @p b out of @p a; upper and lower case count
   * as the same letter.
   */
  unsigned int
  edit_distance(const std::string &a, const std::string &b);

  /**
   * @brief The one of @p candidates that is most like @p text, or an empty
   * string if none is so close that it could be meant.
   */
  std::string
  nearest(const std::string &text, const std::vector<std::string> &candidates);

  /// "; did you mean 'X'?" for a nonempty @p suggestion, or nothing.
  std::string
  did_you_mean(const std::string &suggestion);

  /// @p text without white space at both ends.
  std::string
  trimmed(const std::string &text);

  /// @p parts with @p separator between them.
  std::string
  joined(const std::vector<std::string> &parts, const std::string &separator);
} // namespace Thalweg

#endif
