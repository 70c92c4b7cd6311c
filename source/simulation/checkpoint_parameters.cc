// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/simulation/checkpoint_parameters.h>

namespace Thalweg
{
  void
  CheckpointParameters::declare_parameters(const Section &root)
  {
    const Section section = root.enter("Checkpoint");
    section.add("Steps between",
                steps,
                "",
                "After so many steps the state is saved, for --resume to go "
                "on from; 0: not by the number of steps.",
                dealii::Patterns::Integer(0));
    section.add("Time between",
                minutes,
                "min",
                "The same by the clock, in minutes of the run; 0: not by the "
                "clock. Besides, SIGUSR1 saves the state, and SIGTERM, SIGINT "
                "and SIGHUP save it and end the run.",
                dealii::Patterns::Double(0.));
    section.add("At the end",
                at_end,
                "",
                "Whether the state is saved when the run ends, to go on to a "
                "later end time.");
  }
} // namespace Thalweg
