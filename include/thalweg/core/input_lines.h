// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_input_lines_h
#define thalweg_core_input_lines_h

#include <string>
#include <vector>

namespace Thalweg
{
  /// One `set` line of an input file.
  struct InputEntry
  {
    std::string path;  ///< "Section/Subsection/Name"
    std::string value; ///< without white space at its ends
    std::string place; ///< "file:line", or the option it came from
    std::string file;  ///< which file it is in; empty for an option
    /// The sections that are open there: "Section/Subsection". Names with a
    /// slash may add to them.
    std::string section;
  };

  /// One `subsection` line of an input file.
  struct InputSection
  {
    std::string path;   ///< "Section/Subsection"
    std::string parent; ///< the one that is open around it; empty: none
    std::string place;  ///< "file:line"
  };

  /// The lines of an input file and of the files it includes, in order.
  struct InputLines
  {
    std::vector<InputEntry>   entries;
    std::vector<InputSection> sections;
    std::vector<std::string>  faults; ///< "file:line: what is wrong"
  };

  /**
   * @brief Reads the lines `subsection NAME`, `set NAME = VALUE`, `end` and
   * `include FILE` of the file @p path.
   *
   * `#` begins a comment, and a backslash at the end of a line continues it
   * on the next. Included files are looked for beside the file that includes
   * them. Whatever cannot be understood goes to `faults`, with what stands
   * there and what may stand there; nothing is thrown. Files, lines, sections
   * in each other and faults are bounded in number, and only plain files are
   * read.
   */
  InputLines
  read_input_lines(const std::string &path);

  /// The same for @p text, which messages call @p name.
  InputLines
  read_input_lines(const std::string &text, const std::string &name);
} // namespace Thalweg

#endif
