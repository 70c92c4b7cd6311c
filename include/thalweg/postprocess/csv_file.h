#ifndef thalweg_postprocess_csv_file_h
#define thalweg_postprocess_csv_file_h

#include <thalweg/core/context.h>

#include <fstream>
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
     * @brief Creates the file and writes its header. Collective.
     * @param context where; without an output directory nothing is written
     * @param name of the file in the output directory
     * @param columns with their units, as in "time [s]"
     * @throws dealii::ExcMessage on all processes if it cannot be written
     */
    void
    open(const Context                  &context,
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

  private:
    std::string   path;
    std::ofstream file;
    std::size_t   n_columns = 0;
  };
} // namespace Thalweg

#endif
