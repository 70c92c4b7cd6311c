// SPDX-License-Identifier: LGPL-2.1-or-later
// What a flow writes into the statistics.
#include <thalweg/core/step_number.h>
#include <thalweg/methods/interface_flow.h>
#include <thalweg/methods/missing_fluid.h>

namespace Thalweg
{
  template <int dim>
  std::vector<std::string>
  InterfaceFlow<dim>::columns()
  {
    return {StepNumber::courant,
            StepNumber::fourier,
            "cells",
            "dofs",
            "particles",
            "particles added",
            "particles removed",
            "particles left",
            "particles lost",
            "particles lost in all",
            "volume 1 before shift [m^d]",
            "volume 1 [m^d]",
            "volume 2 [m^d]",
            "target volume 1 [m^d]",
            "correction of volume 1 [m^d]",
            "debt of volume 1 [m^d]",
            "drops of volume 1 [m^d]",
            "bubbles of volume 2 [m^d]",
            "carried volume 1 [m^d]",
            "carried volume 2 [m^d]",
            "volume 1 in [m^d]",
            "volume 1 out [m^d]",
            "volume 2 in [m^d]",
            "volume 2 out [m^d]",
            "volume 1 lost [m^d]",
            "volume 2 lost [m^d]",
            "volume 1 owed [m^d]",
            "volume 2 owed [m^d]",
            "level set shift",
            "velocity time [s]",
            "kinetic energy [J]",
            "potential energy [J]",
            "momentum x [kg m/s]",
            "momentum y [kg m/s]",
            "momentum z [kg m/s]",
            "max velocity 1 [m/s]",
            "max velocity 2 [m/s]"};
  }



  template <int dim>
  void
  InterfaceFlow<dim>::record_volumes(const double time)
  {
    auto &statistics = context.statistics;
    statistics.set("volume 1 before shift [m^d]", phase->volume_before_shift());
    statistics.set("volume 1 [m^d]", phase->volume());
    statistics.set("volume 2 [m^d]", phase->total_volume() - phase->volume());
    statistics.set("level set shift", phase->shift());
    if (parameters.fluids.size() == 1)
      return;
    const VolumeBooks &books = exchange->books();
    const FluidVolumes carried =
      sum_over_ranks(volumes_of_cells(), context.communicator);
    const FluidVolumes in = books.in(), out = books.out();
    const double correction = phase->volume() - phase->volume_before_shift();
    const FluidVolumes dispersed =
      dispersed_phase ? dispersed_phase->volumes() : FluidVolumes();
    const double debt = carried[0] - phase->volume();

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



  template <int dim>
  void
  InterfaceFlow<dim>::warn_at_start() const
  {
    if (!parameters.computes_flow)
      return;
    const std::string missing = missing_fluid(population, parameters.fluids);
    if (!missing.empty())
      context.log.warning(missing);
  }



#define THALWEG_INSTANTIATE_RECORD(dim)                            \
  template std::vector<std::string> InterfaceFlow<dim>::columns(); \
  template void InterfaceFlow<dim>::record_volumes(const double);  \
  template void InterfaceFlow<dim>::warn_at_start() const;
  THALWEG_INSTANTIATE_RECORD(2)
  THALWEG_INSTANTIATE_RECORD(3)
#undef THALWEG_INSTANTIATE_RECORD
} // namespace Thalweg
