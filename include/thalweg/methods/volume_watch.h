// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_volume_watch_h
#define thalweg_methods_volume_watch_h

#include <thalweg/core/archive.h>
#include <thalweg/materials/fluids.h>

#include <array>
#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Finds what of the fluids' volumes a user should know of.
   */
  class VolumeWatch
  {
  public:
    /// A part of a fluid's volume that is worth a warning when the mesh is
    /// corrected by it, or does not show it; and again when it has doubled.
    static constexpr double notable = .01;
    /// The same a second, 1/s.
    static constexpr double notable_rate = .02;

    /// What there is at the end of a step, m^dim.
    struct State
    {
      double time; ///< s
      /// What there was of each fluid at the start, and has come in since.
      std::array<double, 2> ever;
      /// What the shift of the level set added to the first fluid.
      double correction;
      /// What is carried of the first fluid, but not shown by the mesh.
      double debt;
    };

    /// What to say after a step.
    std::vector<std::string>
    after_step(const Fluids &fluids, const State &state);

    void
    keep(const Archive &archive);

  private:
    double corrected      = 0; ///< the part that was last said
    double missing        = 0; ///< likewise
    double restored       = 0; ///< likewise, 1/s
    double second_begins  = 0; ///< s
    double old_correction = 0; ///< m^dim, when the second began
  };
} // namespace Thalweg

#endif
