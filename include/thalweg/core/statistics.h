// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_statistics_h
#define thalweg_core_statistics_h

#include <thalweg/core/archive.h>
#include <thalweg/core/growing_file.h>
#include <thalweg/core/log.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief A table with one row a time step, written to a CSV file as the
   * run goes on.
   *
   * Columns are named with their unit, "time [s]". They stand in the order in
   * which they were declared, the others behind them in that of their first
   * use. All columns must be set before the first row ends; later rows keep
   * the first row's header, and a column that is not set in a row stays empty;
   * one that is set later for the first time is not written.
   */
  class Statistics
  {
  public:
    /**
     * @brief As long as it lives, columns that are set are those of a part of
     * the run: "particles" of the part "water" is "water: particles". Those
     * that are read are the part's own, or else of the run.
     */
    class Group
    {
    public:
      /// @param name of the part; empty: its columns are the run's
      Group(Statistics &statistics, const std::string &name);

      Group(const Group &) = delete;

      Group &
      operator=(const Group &) = delete;

      ~Group();

    private:
      Statistics       &statistics;
      const std::string outer_prefix;
    };

    /// Collects only; nothing is written before open() was called.
    Statistics() = default;

    /// Writes to @p path from now on. Call it on the root process only.
    /// @param resumed the file is left as it is, for keep() to go on with
    /// @throws dealii::ExcMessage if the file cannot be written
    void
    open(const std::string &path, const bool resumed = false);

    /// Lets the table begin with these columns, as far as the first row has
    /// them. Call it before any value is set.
    void
    declare(const std::vector<std::string> &leading_columns);

    /// Sets the value of column @p name in the current row.
    void
    set(const std::string &name, const double value);

    /// Adds to the value of column @p name in the current row.
    void
    add(const std::string &name, const double value);

    /// The value in the current row, or in the last complete one if the
    /// current row has none. @throws dealii::ExcMessage without such a column
    double
    get(const std::string &name) const;

    /// Whether a column of this name exists.
    bool
    has(const std::string &name) const;

    /// The columns in their order, with those that have no value yet.
    const std::vector<std::string> &
    column_names() const
    {
      return columns;
    }

    /// The name of a column whose value in the current row is no finite
    /// number; empty: there is none.
    std::string
    column_without_number() const;

    /// Ends the row: writes it and starts the next.
    void
    end_row();

    /**
     * @brief Keeps columns and values and, on the process that writes, the
     * length of the file.
     *
     * When restoring, after open(), rows that were written later vanish from
     * the file. Is it shorter than it was, or not there, the table begins
     * anew.
     * @param log says so
     * @throws dealii::ExcMessage if the file cannot be written
     */
    void
    keep(const Archive &archive, Log &log);

  private:
    std::string
    header() const;

    /// The value of a column of this very name, or nothing.
    const double *
    find(const std::string &name) const;

    /// Of the present group.
    std::string                   prefix;
    std::string                   path;
    GrowingFile                   file;
    std::vector<std::string>      columns;
    std::map<std::string, double> row;
    std::map<std::string, double> last_row;
    bool                          first_row         = true;
    std::size_t                   n_columns_in_file = 0;
  };
} // namespace Thalweg

#endif
