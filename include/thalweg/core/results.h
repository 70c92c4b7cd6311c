// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_results_h
#define thalweg_core_results_h

#include <set>
#include <string>

namespace Thalweg
{
  /**
   * @brief The names of all that a run writes into its directory, kept in
   * `files.txt` there: a later run without --resume moves these aside, and
   * nothing else. Belongs to the root process.
   */
  class Results
  {
  public:
    /// From now on names go into the list in @p directory; those that are
    /// there remain.
    void
    open(const std::string &directory);

    /// Adds a file or directory, relative to the run's directory.
    /// @throws dealii::ExcMessage if the list cannot be written
    void
    add(const std::string &name);

    /**
     * @brief Moves what an earlier run has left in @p directory to a directory
     * `old` in it, or `old.2` and so on; a run that did no step has left
     * nothing that is worth it, which is removed.
     * @return where; empty: there was nothing
     * @throws dealii::ExcMessage if that fails
     */
    static std::string
    set_aside(const std::string &directory);

  private:
    std::string           path;
    std::set<std::string> names;
  };
} // namespace Thalweg

#endif
