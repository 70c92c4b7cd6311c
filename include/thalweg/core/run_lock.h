// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_run_lock_h
#define thalweg_core_run_lock_h

#include <thalweg/core/descriptor.h>

#include <memory>
#include <string>

namespace Thalweg
{
  /**
   * @brief Keeps a directory for one run, as long as the object lives: the file
   * `lock` in it, which the system frees when the process ends, however that
   * happens. It says which process on which machine has it.
   *
   * Where the file system knows no locks, that process decides: if it is on
   * this machine and gone, its lock is void. Belongs to one process.
   */
  class RunLock
  {
  public:
    /// @throws dealii::ExcMessage if another run has the directory
    explicit RunLock(const std::string &directory);

    RunLock(const RunLock &) = delete;

    ~RunLock();

    /// @throws dealii::ExcMessage if the directory is not where it was when
    ///   the run began
    void
    expect_directory() const;

  private:
    const std::string           directory;
    const std::string           path;
    std::unique_ptr<Descriptor> file;
  };
} // namespace Thalweg

#endif
