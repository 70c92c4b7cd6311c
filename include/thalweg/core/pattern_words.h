// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_pattern_words_h
#define thalweg_core_pattern_words_h

#include <string>

namespace Thalweg
{
  /**
   * @brief What a pattern allows, in words that complete "must be ...", for
   * example "a number that is at least 0".
   *
   * @param description by the pattern's own description(), as in
   *   "[Double 0...MAX_DOUBLE (inclusive)]"; that, and not the pattern, because
   *   a ParameterHandler hands out nothing else, and deal.II cannot make
   *   patterns out of the descriptions of nested ones
   */
  std::string
  in_words(const std::string &description);

  /**
   * @brief The name out of those that a pattern offers that somebody may
   * have meant by @p value, one name or a list of names.
   * @param description of the pattern, as for in_words()
   * @param value what was given instead
   * @return an empty string if the pattern offers no names or none is near
   */
  std::string
  nearest_in(const std::string &description, const std::string &value);

  /**
   * @brief A name that is twice in the list @p value.
   * @param description of the pattern, as for in_words()
   * @return an empty string if there is none, or the pattern is no list of
   *   names
   */
  std::string
  repeated_in(const std::string &description, const std::string &value);
} // namespace Thalweg

#endif
