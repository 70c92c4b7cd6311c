// SPDX-License-Identifier: LGPL-2.1-or-later
// What Simulation writes of the fluids' volumes.
#include <thalweg/simulation/simulation.h>

namespace Thalweg
{
  template <int dim>
  void
  Simulation<dim>::record_volumes()
  {
    if (parameters.fluids.size() == 1)
      return;
    auto                  &statistics = context.statistics;
    const PhaseField<dim> &phase      = parts->phases();
    const VolumeBooks     &books      = parts->books();
    const FluidVolumes     carried    = parts->carried_volumes();
    const FluidVolumes     in = books.in(), out = books.out();
    const double correction      = phase.volume() - phase.volume_before_shift();
    const FluidVolumes dispersed = parts->dispersed_volumes();
    const double       debt      = carried[0] - phase.volume();

    statistics.set("target volume 1 [m^d]", books.inside()[0]);
    statistics.set("correction of volume 1 [m^d]", correction);
    statistics.set("debt of volume 1 [m^d]", debt);
    statistics.set("drops of volume 1 [m^d]", dispersed[0]);
    statistics.set("bubbles of volume 2 [m^d]", dispersed[1]);
    FluidVolumes ever = books.start;
    for (unsigned int f = 0; f < 2; ++f)
      {
        const std::string fluid = "volume " + std::to_string(f + 1);
        statistics.set("carried " + fluid + " [m^d]",
                       carried[f] + dispersed[f]);
        statistics.set(fluid + " in [m^d]", in[f]);
        statistics.set(fluid + " out [m^d]", out[f]);
        statistics.set(fluid + " lost [m^d]", books.lost[f]);
        statistics.set(fluid + " owed [m^d]", books.owed[f]);
        ever[f] += in[f];
      }
    for (const std::string &warning :
         watch.after_step(parameters.fluids, {time, ever, correction, debt}))
      context.log.warning(warning);
  }



  template void
  Simulation<2>::record_volumes();
  template void
  Simulation<3>::record_volumes();
} // namespace Thalweg
