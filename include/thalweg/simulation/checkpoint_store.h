#ifndef thalweg_simulation_checkpoint_store_h
#define thalweg_simulation_checkpoint_store_h

#include <thalweg/core/context.h>
#include <thalweg/simulation/settings.h>

#include <cstdint>
#include <string>
#include <vector>

namespace Thalweg
{
  /// What is known of a checkpoint without reading all of it.
  struct CheckpointOutline
  {
    std::string   directory;
    unsigned int  step        = 0;
    double        time        = 0; ///< s
    std::uint64_t coarse_mesh = 0; ///< a number that other meshes do not have
    /// How many cells each rank had.
    std::vector<unsigned int> cells_of_ranks;
    Settings                  settings;
  };

  /**
   * @brief The checkpoints in an output directory: `checkpoints/step_000120/`
   * and so on, the last two of them.
   *
   * A checkpoint is written under another name and renamed when all of it is
   * on the disk; its `manifest.json` has the length and the checksum of each
   * file. So one that was cut short, or whose files were damaged, is never
   * taken for whole.
   */
  class CheckpointStore
  {
  public:
    /// @param context its output directory is where checkpoints go; must
    ///   outlive the store
    explicit CheckpointStore(Context &context);

    /// Gives the checkpoints of an earlier run another name, so that this one,
    /// which does not go on from them, is not taken for it. Collective.
    void
    set_aside();

    /// @throws dealii::ExcMessage if no run has written checkpoints into the
    ///   output directory @p directory
    static void
    expect_any(const std::string &directory);

    /// Creates an empty directory for a checkpoint, which it returns; all
    /// files of it go there. Collective.
    /// @throws dealii::ExcMessage on all processes if that fails
    std::string
    begin(const unsigned int step);

    /**
     * @brief Ends the checkpoint that begin() began: from now on it exists,
     * and all but the last two are removed. Collective.
     * @param outline but for its directory
     * @throws dealii::ExcMessage on all processes if the disk is full
     */
    void
    commit(const CheckpointOutline &outline);

    /**
     * @brief The newest checkpoint that is whole; a warning says for each
     * newer one what is wrong with it. Collective.
     * @throws dealii::ExcMessage on all processes if there is none
     */
    CheckpointOutline
    find_newest();

  private:
    Context    &context;
    std::string root;
    std::string unfinished;
  };
} // namespace Thalweg

#endif
