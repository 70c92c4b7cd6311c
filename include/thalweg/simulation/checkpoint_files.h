// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_checkpoint_files_h
#define thalweg_simulation_checkpoint_files_h

#include <thalweg/mesh/curve_cells.h>
#include <thalweg/simulation/settings.h>
#include <thalweg/transfer/mesh_transfer.h>

#include <cstdint>
#include <string>
#include <vector>

namespace Thalweg
{
  /// What the manifest says of a file.
  struct CheckpointFile
  {
    std::uint64_t size     = 0; ///< in bytes
    std::uint64_t checksum = 0;
    /// How many cells it has, if it is one with cells.
    std::uint64_t n_cells = 0;
  };

  /// What is known of a checkpoint without reading all of it.
  struct CheckpointOutline
  {
    std::string   directory;
    unsigned int  step        = 0;
    double        time        = 0; ///< s
    std::uint64_t coarse_mesh = 0; ///< a number that other meshes do not have
    /// The file with the values, and that with the cells of each rank.
    CheckpointFile              values;
    std::vector<CheckpointFile> cells;
    Settings                    settings;
  };

  /// What the files of a checkpoint are called.
  namespace CheckpointNames
  {
    constexpr auto manifest = "manifest.json";
    constexpr auto values   = "values.cbor";

    std::string
    cells(const unsigned int rank);
  } // namespace CheckpointNames

  /// The text of `manifest.json`, with a checksum of its own.
  std::string
  manifest_of(const CheckpointOutline &outline);

  /**
   * @brief Reads the manifest in @p directory.
   * @param outline is what it says, if nothing is wrong with it
   * @return what is wrong; empty: nothing
   */
  std::string
  read_manifest(const std::string &directory, CheckpointOutline &outline);

  /// What is wrong with a file of a checkpoint, in comparison with the
  /// manifest; empty: nothing.
  std::string
  fault_of_file(const std::string    &directory,
                const std::string    &name,
                const CheckpointFile &file);

  /// Writes the cells of a rank to the disk.
  /// @return what the manifest is to say, from what is in memory
  /// @throws dealii::ExcMessage if not all of it can be written
  CheckpointFile
  write_cells(const std::string            &path,
              const std::vector<CurveCell> &cells,
              const PackedCells            &packed);

  /// Reads the cells with the numbers from @p begin up to before @p end among
  /// those of all ranks. @throws dealii::ExcMessage with the file that cannot
  /// be read or does not have them
  std::vector<CurveCell>
  read_curve_cells(const CheckpointOutline &checkpoint,
                   const std::uint64_t      begin,
                   const std::uint64_t      end);

  /// Reads what the same cells carry. Throws the same.
  PackedCells
  read_packed_cells(const CheckpointOutline &checkpoint,
                    const std::uint64_t      begin,
                    const std::uint64_t      end);
} // namespace Thalweg

#endif
