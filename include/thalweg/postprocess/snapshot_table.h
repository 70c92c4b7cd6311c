// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_snapshot_table_h
#define thalweg_postprocess_snapshot_table_h

#include <thalweg/core/archive.h>
#include <thalweg/core/context.h>
#include <thalweg/postprocess/file_series.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief A table that is written as a whole, one file a time.
   *
   * The files are called `NAME/NAME_0000.csv`; the latest is `NAME.csv` too,
   * which is therefore valid at any moment.
   */
  class SnapshotTable
  {
  public:
    /**
     * @brief Creates the directory. Collective.
     * @param context where; without an output directory nothing is written;
     *   must outlive this object
     * @param name of the tables, without ending
     * @param columns with their units
     * @throws dealii::ExcMessage on all processes if that fails
     */
    void
    open(Context                        &context,
         const std::string              &name,
         const std::vector<std::string> &columns);

    /**
     * @brief Writes the next file with the rows of the root process; what is
     * not a number stays empty. Collective.
     * @throws dealii::ExcMessage on all processes if the disk is full
     */
    void
    write(const Context &context, const std::vector<std::vector<double>> &rows);

    /**
     * @brief Keeps how many files there are. When restoring, after open(),
     * those behind them are removed, and the last of them becomes the latest
     * again. Collective.
     * @param without_last whether the last file is not to be there when the
     *   run goes on
     * @throws dealii::ExcMessage on all processes if the disk is full
     */
    void
    keep(const Archive &archive, const bool without_last = false);

  private:
    /// Where a file stands.
    std::string
    path_of(const unsigned int number) const;

    std::string
    latest() const;

    const Context           *context = nullptr;
    FileSeries               series;
    std::vector<std::string> columns;
    unsigned int             n_written = 0;
  };
} // namespace Thalweg

#endif
