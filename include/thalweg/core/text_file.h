// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_text_file_h
#define thalweg_core_text_file_h

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace Thalweg
{
  /// @p path with the home directory instead of '~' at its beginning, as
  /// shells have it.
  /// @throws dealii::ExcMessage for '~NAME/', and if there is no home
  std::string
  with_home(const std::string &path);

  /// A file that a user wrote.
  struct TextFile
  {
    std::string content;
    /// The same for all names of one file.
    std::pair<std::uint64_t, std::uint64_t> identity;
  };

  /**
   * @brief Reads a whole file that a user wrote.
   *
   * Only plain files are read: pipes and devices could block, or never end.
   * @param what names the file at the beginning of a message, as in "The mesh
   *   file 'a.msh'"
   * @param longest in bytes
   * @throws dealii::ExcMessage that says what is wrong with the file
   */
  TextFile
  read_text_file(const std::string &path,
                 const std::string &what,
                 const std::size_t  longest);

  /**
   * @brief The lines in @p content, each ended by a newline whatever system the
   * file came from.
   * @param what as above
   * @throws dealii::ExcMessage if it is no text in ASCII or UTF-8
   */
  std::string
  plain_lines(const std::string &content, const std::string &what);
} // namespace Thalweg

#endif
