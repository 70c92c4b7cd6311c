// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_file_series_h
#define thalweg_postprocess_file_series_h

#include <thalweg/core/context.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Files with a name and a number, `NAME/NAME_0000` with some ending,
   * in a run's directory, and those called NAME beside the folder that are
   * about all of them.
   */
  class FileSeries
  {
  public:
    /**
     * @brief Creates the folder. Collective.
     * @param context with an output directory, or nothing is done; must outlive
     *   this object
     * @param name of the series
     * @param endings of the files beside the folder, with their dots
     * @throws dealii::ExcMessage on all processes if that fails
     */
    void
    open(Context                        &context,
         const std::string              &name,
         const std::vector<std::string> &endings);

    /// Folder and files without their endings.
    std::string
    path() const;

    /// The file with this number, without its ending.
    std::string
    path_of(const unsigned int number) const;

    /// To be called on the root process before a file is written: when a
    /// resumed run writes its first one and knows nothing of what is there,
    /// that is moved aside. @param is_first of the files of this run
    void
    prepare(const bool is_first);

    /// Removes the files with this number and those behind it; what others have
    /// put there stays. Call it on the root process, in a resumed run that
    /// knows the files before.
    void
    drop_from(const unsigned int number);

  private:
    Context                 *context = nullptr;
    std::string              name;
    std::vector<std::string> endings;
    bool                     is_known = false;
  };
} // namespace Thalweg

#endif
