// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_checkpoint_parameters_h
#define thalweg_simulation_checkpoint_parameters_h

#include <thalweg/core/section.h>

namespace Thalweg
{
  /// The section "Checkpoint".
  struct CheckpointParameters
  {
    /// Declares the section below @p root.
    void
    declare_parameters(const Section &root);

    unsigned int steps   = 0;
    double       minutes = 30.;
    bool         at_end  = true;
  };
} // namespace Thalweg

#endif
