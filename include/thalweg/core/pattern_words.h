#ifndef thalweg_core_pattern_words_h
#define thalweg_core_pattern_words_h

#include <deal.II/base/patterns.h>

#include <string>

namespace Thalweg
{
  /**
   * @brief What @p pattern allows, in words that complete "must be ...",
   * for example "a number that is at least 0".
   */
  std::string
  in_words(const dealii::Patterns::PatternBase &pattern);

  /**
   * @brief The name out of those that @p pattern offers that somebody may
   * have meant by @p value, one name or a list of names.
   * @return an empty string if @p pattern offers no names or none is near
   */
  std::string
  nearest_in(const dealii::Patterns::PatternBase &pattern,
             const std::string                   &value);
} // namespace Thalweg

#endif
