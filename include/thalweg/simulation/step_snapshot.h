// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_step_snapshot_h
#define thalweg_simulation_step_snapshot_h

#include <thalweg/fields/state.h>

#include <functional>
#include <vector>

namespace Thalweg
{
  /// A state in memory as it was before a step, should that fail.
  template <int dim>
  class StepSnapshot
  {
  public:
    /// Names all that the state consists of.
    using Keep = std::function<void(const State<dim> &)>;

    /// Remembers the state.
    void
    save(const Keep &keep);

    /// Makes what @p keep names what it was at the last save(), on the same
    /// mesh: all that was saved, or the first of it. Collective.
    void
    restore(const Keep &keep) const;

  private:
    Archive             values;
    std::vector<Vector> fields;
  };
} // namespace Thalweg

#endif
