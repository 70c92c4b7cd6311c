#ifndef thalweg_postprocess_pvd_record_h
#define thalweg_postprocess_pvd_record_h

#include <thalweg/core/context.h>

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
    /// @param context where; without an output directory nothing is written
    /// @param name of the series
    /// @throws dealii::ExcMessage on all processes if the directory cannot
    ///   be created
    void
    open(const Context &context, const std::string &name);

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

  private:
    void
    write_record(const Context &context) const;

    std::string                                 name;
    std::vector<std::pair<double, std::string>> files;
  };
} // namespace Thalweg

#endif
