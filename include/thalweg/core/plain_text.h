// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_plain_text_h
#define thalweg_core_plain_text_h

#include <cstddef>
#include <optional>
#include <string>

namespace Thalweg
{
  /// Messages are not longer than this, bytes.
  constexpr std::size_t longest_message = 3800;

  /**
   * @brief What somebody wrote, made fit to be quoted in a message.
   *
   * Control characters, with which a file could write anywhere on a terminal,
   * and bytes that are no UTF-8 are shown as `\x1b`, line ends too. Of a text
   * that is too long the middle is left out.
   * @param longest about how many bytes remain
   */
  std::string
  excerpt(const std::string &text, const std::size_t longest = 160);

  /// The same for a whole message: line ends stay, and its end is left out.
  std::string
  bounded_message(const std::string &text,
                  const std::size_t  longest = longest_message);

  /// The number that a text is; nothing if it is more than that, no number, or
  /// not finite.
  std::optional<double>
  finite_number(const std::string &text);
} // namespace Thalweg

#endif
