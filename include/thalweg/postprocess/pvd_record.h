// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_pvd_record_h
#define thalweg_postprocess_pvd_record_h

#include <thalweg/core/archive.h>
#include <thalweg/core/context.h>
#include <thalweg/postprocess/file_series.h>

#include <deal.II/base/data_out_base.h>

#include <string>
#include <utility>
#include <vector>

namespace Thalweg
{
  /**
   * @brief A series of .vtu files with the .pvd record that ParaView opens.
   *
   * The files are called `NAME/NAME_0000.vtu`, the record `NAME.pvd`. It is
   * replaced as a whole after each file, so that it is valid at any moment.
   */
  class PvdRecord
  {
  public:
    /// @param context where; without an output directory nothing is written;
    ///   must outlive this object
    /// @param name of the series
    /// @throws dealii::ExcMessage on all processes if the directory cannot
    ///   be created
    void
    open(Context &context, const std::string &name);

    /**
     * @brief Writes the patches of @p data as the next file. Collective.
     * @param time in s
     * @param step number of the time step
     * @throws dealii::ExcMessage on all processes if the disk is full
     */
    template <int dim, int spacedim>
    void
    write(const Context                           &context,
          dealii::DataOutInterface<dim, spacedim> &data,
          const double                             time,
          const unsigned int                       step);

    /**
     * @brief Keeps the list of files. When restoring, after open(), the
     * record is written with these alone, and the files behind them are
     * removed; files that are gone are left out with a warning.
     * Collective.
     * @param without_last whether the last file is not to be there when the
     *   run goes on
     * @throws dealii::ExcMessage on all processes if the disk is full
     */
    void
    keep(const Archive &archive, const bool without_last = false);

  private:
    void
    write_record(const Context &context) const;

    /// Takes files off the list that are not there. Collective.
    void
    drop_missing_files();

    Context    *context = nullptr;
    std::string name;
    FileSeries  series;
    /// Of all files, those too that are gone.
    unsigned int                                n_written = 0;
    std::vector<std::pair<double, std::string>> files;
  };
} // namespace Thalweg

#endif
