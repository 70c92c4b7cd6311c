// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_options_h
#define thalweg_core_options_h

#include <string>
#include <vector>

namespace Thalweg
{
  /// What the command line asks for.
  struct Options
  {
    std::string              file;       ///< the input file; may be empty
    std::vector<std::string> overrides;  ///< "Section/Name=value"
    std::string              output;     ///< where results go; empty: default
    std::string              parameters; ///< "", "prm", "json" or "markdown"
    bool                     resume   = false;
    bool                     validate = false;
    bool                     help     = false;
    bool                     version  = false;
  };

  /**
   * @brief Reads the command line.
   * @throws dealii::ExcMessage that names the nearest right option
   */
  Options
  read_options(const int argc, const char *const *argv);

  /// What `--help` prints.
  std::string
  help_text();

  /// What `--version` prints: Thalweg and the libraries it was built with.
  std::string
  version_text();
} // namespace Thalweg

#endif
