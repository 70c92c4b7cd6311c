// SPDX-License-Identifier: LGPL-2.1-or-later
// How Pfem2 moves particles, drops and bubbles.
#include <thalweg/methods/dispersed_motion.h>
#include <thalweg/methods/pfem2.h>

namespace Thalweg
{
  template <int dim>
  double
  Pfem2<dim>::time_of_particles(const double time, const double dt) const
  {
    // The first half of the acceleration is theirs before they move.
    return time_integration == "trapezoidal" ? time + .5 * dt : flow_time;
  }



  template <int dim>
  ConvectionReport
  Pfem2<dim>::move_particles(const double time, const double dt)
  {
    ConvectionReport report =
      parts->convection.move(parts->population, cell_velocity, dt);
    if (parts->dispersed == nullptr || parts->dispersed->is_empty())
      return report;
    parts->forces.set_time(time + .5 * dt);
    parts->space.copy_to_cells(parts->phase.level_set(), cell_distance);
    std::vector<NewParticle<dim>> landed;
    report.add(
      parts->dispersed->move(cell_distance,
                             cell_velocity,
                             dispersed_motion(parts->forces, parts->fluids),
                             dt,
                             time_of_particles(time, dt) - time,
                             landed));
    report.add(
      parts->convection.insert(parts->population, landed, cell_velocity));
    return report;
  }



  template <int dim>
  void
  Pfem2<dim>::disperse(const double time, const double dt)
  {
    if (parts->dispersed == nullptr)
      return;
    dealii::TimerOutput::Scope scope(parts->context.timers, "population");
    const double               end = time + dt;
    parts->forces.set_time(end);
    parts->space.copy_to_cells(parts->phase.level_set(), cell_distance);
    parts->dispersed->exchange(parts->population,
                               cell_distance,
                               dispersed_motion(parts->forces, parts->fluids),
                               time_of_particles(time, dt) - end);
  }



  template double
  Pfem2<2>::time_of_particles(const double, const double) const;
  template ConvectionReport
  Pfem2<2>::move_particles(const double, const double);
  template void
  Pfem2<2>::disperse(const double, const double);
  template double
  Pfem2<3>::time_of_particles(const double, const double) const;
  template ConvectionReport
  Pfem2<3>::move_particles(const double, const double);
  template void
  Pfem2<3>::disperse(const double, const double);
} // namespace Thalweg
