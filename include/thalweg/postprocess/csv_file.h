// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_csv_file_h
#define thalweg_postprocess_csv_file_h

#include <thalweg/core/archive.h>
#include <thalweg/core/context.h>
#include <thalweg/core/growing_file.h>

#include <cstdint>
#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief A table that grows by rows of numbers, written by the root
   * process.
   *
   * Each row is on the disk when write_row() returns, so that a run that is
   * ended from outside leaves all its rows.
   */
  class CsvFile
  {
  public:
    /**
     * @brief Creates the file and writes its header; in a resumed run only
     * the first row does, unless keep() finds the file. Collective.
     * @param context where; without an output directory nothing is written;
     *   must outlive this object
     * @param name of the file in the output directory
     * @param columns with their units, as in "time [s]"
     * @throws dealii::ExcMessage on all processes if it cannot be written
     */
    void
    open(Context                        &context,
         const std::string              &name,
         const std::vector<std::string> &columns);

    /**
     * @brief Appends a row, with as many values as there are columns; what
     * is not a number stays empty. Collective.
     * @throws dealii::ExcMessage on all processes if the disk is full
     */
    void
    write_row(const Context &context, const std::vector<double> &values);

    /// The same for any number of rows; those of the root process count.
    void
    write_rows(const Context                          &context,
               const std::vector<std::vector<double>> &rows);

    /**
     * @brief Keeps how long the file is. When restoring, after open(), rows
     * that were written later vanish; is the file gone, shorter or of other
     * columns, it begins anew with a warning. Collective.
     * @param without_last whether the last write_row() or write_rows() is not
     *   to be there when the run goes on
     * @throws dealii::ExcMessage on all processes if it cannot be written
     */
    void
    keep(const Archive &archive, const bool without_last = false);

  private:
    /// Tells all processes what the root process knows. Collective.
    void
    share_lengths();

    Context    *context = nullptr;
    std::string path;
    std::string header;
    GrowingFile file; ///< of the root process
    std::size_t n_columns = 0;
    /// In bytes, the same on all processes: now and before the last rows.
    std::uint64_t length = 0, last_length = 0;
  };
} // namespace Thalweg

#endif
