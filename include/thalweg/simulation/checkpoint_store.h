// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_checkpoint_store_h
#define thalweg_simulation_checkpoint_store_h

#include <thalweg/core/context.h>
#include <thalweg/simulation/checkpoint_files.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /// All that a checkpoint holds, on each rank.
  struct CheckpointContent
  {
    std::string            values; ///< of the root process
    std::vector<CurveCell> cells;  ///< of this rank
    PackedCells            packed; ///< what they carry
  };

  /**
   * @brief The checkpoints in an output directory: `checkpoints/step_000120/`
   * and so on, the last two of them. Whatever has other names there belongs to
   * the user and is not touched.
   *
   * A checkpoint is written under another name and renamed when all of it is
   * on the disk; its `manifest.json` has its own checksum and the length and
   * the checksum of each file, as they were in memory. So one that was cut
   * short, or whose files were damaged, is never taken for whole.
   */
  class CheckpointStore
  {
  public:
    /// @param context its output directory is where checkpoints go; must
    ///   outlive the store
    explicit CheckpointStore(Context &context);

    /// @throws dealii::ExcMessage if no run has written checkpoints into the
    ///   output directory @p directory
    static void
    expect_any(const std::string &directory);

    /**
     * @brief Writes a checkpoint. When that has succeeded, all but the last
     * two are removed; before, none is. Collective.
     * @param outline but for its directory and its files
     * @return why it could not be written, the same on all processes; empty:
     *   it is on the disk
     */
    std::string
    write(CheckpointOutline outline, const CheckpointContent &content);

    /**
     * @brief The newest checkpoint that is whole; a warning says for each
     * newer one what is wrong with it. Collective.
     * @throws dealii::ExcMessage on all processes if there is none
     */
    CheckpointOutline
    find_newest();

  private:
    /// Writes all files into @p directory. @throws dealii::ExcMessage on all
    /// processes if that fails
    void
    write_files(const std::string       &directory,
                CheckpointOutline       &outline,
                const CheckpointContent &content) const;

    /// Gives what was written its name and removes what is too old.
    void
    take_over(const std::string &directory, const unsigned int step) const;

    /// What is wrong with a checkpoint. Collective.
    std::string
    fault_of(const std::string &directory, CheckpointOutline &outline) const;

    Context    &context;
    std::string root;
  };
} // namespace Thalweg

#endif
