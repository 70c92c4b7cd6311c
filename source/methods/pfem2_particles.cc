// SPDX-License-Identifier: LGPL-2.1-or-later
// How Pfem2 moves particles, drops and bubbles, and what they carry.
#include <thalweg/methods/dispersed_motion.h>
#include <thalweg/methods/pfem2.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Where fluids are mixed finely the projected level set is flat, and its
    /// contour moves by several times what particles take: with all of the
    /// shift it would swing.
    constexpr double kept_part_of_shift = .1;
  } // namespace



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



  template <int dim>
  void
  Pfem2<dim>::keep_distance(const double dt)
  {
    // New particles take the level set without the shift, of which the others
    // carry a small part: else the shifts of all steps would add up in them.
    if (!carries_distances())
      {
        parts->space.copy_to_cells(level_set, cell_level_set);
        return;
      }
    dealii::TimerOutput::Scope scope(parts->context.timers, "interface");
    carried_distance->find_rates(parts->phase.level_set(), convecting_velocity);
    carried_distance->apply(parts->population, dt);
    Vector distances(level_set);
    carried_distance->apply(distances, dt);
    parts->space.copy_to_cells(distances, cell_level_set);
  }



  template <int dim>
  void
  Pfem2<dim>::keep_shift()
  {
    const Vector *shift = parts->phase.shifts_at_nodes();
    if (shift == nullptr || !carries_distances())
      return;
    // Beside the surface only: who shifts for which body is clear there.
    const double beside = .5 * parts->phase.shortest_edge();
    Vector       kept(*shift);
    kept.zero_out_ghost_values();
    for (unsigned int n = 0; n < kept.locally_owned_size(); ++n)
      if (std::abs(parts->phase.level_set().local_element(n)) > beside)
        kept.local_element(n) = 0.;
    parts->space.interpolate(kept, 1);
    shift_level_sets(parts->population, parts->space, kept, kept_part_of_shift);
  }



  template double
  Pfem2<2>::time_of_particles(const double, const double) const;
  template ConvectionReport
  Pfem2<2>::move_particles(const double, const double);
  template void
  Pfem2<2>::disperse(const double, const double);
  template void
  Pfem2<2>::keep_distance(const double);
  template void
  Pfem2<2>::keep_shift();
  template double
  Pfem2<3>::time_of_particles(const double, const double) const;
  template ConvectionReport
  Pfem2<3>::move_particles(const double, const double);
  template void
  Pfem2<3>::disperse(const double, const double);
  template void
  Pfem2<3>::keep_distance(const double);
  template void
  Pfem2<3>::keep_shift();
} // namespace Thalweg
