// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_step_snapshot_h
#define thalweg_simulation_step_snapshot_h

#include <thalweg/particles/population_snapshot.h>
#include <thalweg/simulation/simulation_parts.h>

#include <vector>

namespace Thalweg
{
  /// The state in memory as it was before a step, should that fail.
  template <int dim>
  class StepSnapshot
  {
  public:
    /// Remembers the state. Collective.
    void
    save(SimulationParts<dim> &parts);

    /// Makes the state what it was at the last save(), on the same mesh.
    /// Collective.
    void
    restore(SimulationParts<dim> &parts) const;

  private:
    Archive                 values;
    std::vector<Vector>     fields;
    PopulationSnapshot<dim> particles, dispersed;
  };
} // namespace Thalweg

#endif
