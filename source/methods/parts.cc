// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/parts.h>
#include <thalweg/transfer/feet_in_place.h>

#include <cmath>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    const std::string all_lost = "particles lost in all";

    /// Adds @p n to those that were lost before, and returns the sum.
    double
    record_lost(Statistics &statistics, const std::uint64_t n)
    {
      const double before =
        statistics.has(all_lost) ? statistics.get(all_lost) : 0.;
      statistics.set("particles lost", n);
      statistics.set(all_lost, before + n);
      return before + n;
    }



    /// Whether a count reached another power of two with the last @p n: a
    /// run of a million steps is to say so twenty times, not a million.
    bool
    has_doubled(const double so_far, const std::uint64_t n)
    {
      return n > 0 &&
             std::ilogb(so_far) > (so_far == n ? -1 : std::ilogb(so_far - n));
    }



    template <int dim>
    std::string
    describe(const Statistics       &statistics,
             const ConvectionReport &report,
             const std::uint64_t     so_far)
    {
      std::ostringstream text;
      if (statistics.has("step"))
        text << "Step " << statistics.get("step")
             << " (t = " << statistics.get("time [s]") << " s): ";
      text << report.n_lost
           << (report.n_lost == 1 ? " particle was" : " particles were")
           << " lost, number " << report.first_lost.id
           << " in the cell with the centre (";
      for (unsigned int d = 0; d < dim; ++d)
        text << (d > 0 ? ", " : "") << report.first_lost.place[d];
      text << "): the velocity or the way there is not a number, or the "
              "particle was not in the domain. ";
      if (so_far > report.n_lost)
        text << so_far << " have been lost so far. ";
      text << "This is said again when the number has doubled.";
      return text.str();
    }
  } // namespace



  template <int dim>
  void
  repopulate_in_place(const Parts<dim>         &parts,
                      const LagrangeSpace<dim> &velocity_space,
                      const Vector             &velocity,
                      const Vector             &level_set)
  {
    parts.control.fill_empty_cells(parts.population,
                                   [&](const auto &cells, const auto &points) {
                                     return feet_in_place(cells,
                                                          points,
                                                          velocity_space,
                                                          velocity,
                                                          parts.space,
                                                          level_set);
                                   });
    parts.control.limit(parts.population);
  }



  template <int dim>
  unsigned int
  pass_boundaries(const Parts<dim>        &parts,
                  const ConvectionReport  &report,
                  const Vector            &velocity,
                  const CellVelocity<dim> &cell_velocity,
                  const double             middle,
                  const double             dt)
  {
    if (parts.fluids.size() == 1)
      return 0;
    parts.conditions.set_time(middle);
    return parts.exchange.pass(
      parts.population, report, velocity, cell_velocity, dt);
  }



  template <int dim>
  void
  record_particles(const Parts<dim>       &parts,
                   const ConvectionReport &local_report,
                   const unsigned int      n_added,
                   const unsigned int      n_removed)
  {
    const MPI_Comm         communicator = parts.context.communicator;
    const ConvectionReport report       = local_report.sum(communicator);
    auto                  &statistics   = parts.context.statistics;
    statistics.set("particles", parts.population.n_global_particles());
    statistics.set("particles added",
                   dealii::Utilities::MPI::sum(n_added, communicator));
    statistics.set("particles removed",
                   dealii::Utilities::MPI::sum(n_removed, communicator));
    statistics.set("particles left", report.n_left());
    statistics.set("particle substeps", report.n_substeps);
    const double so_far = record_lost(statistics, report.n_lost);
    if (has_doubled(so_far, report.n_lost))
      parts.context.log.warning(
        describe<dim>(statistics, report, static_cast<std::uint64_t>(so_far)));
  }



  template void
  repopulate_in_place(const Parts<2> &,
                      const LagrangeSpace<2> &,
                      const Vector &,
                      const Vector &);
  template void
  repopulate_in_place(const Parts<3> &,
                      const LagrangeSpace<3> &,
                      const Vector &,
                      const Vector &);
  template unsigned int
  pass_boundaries(const Parts<2> &,
                  const ConvectionReport &,
                  const Vector &,
                  const CellVelocity<2> &,
                  const double,
                  const double);
  template unsigned int
  pass_boundaries(const Parts<3> &,
                  const ConvectionReport &,
                  const Vector &,
                  const CellVelocity<3> &,
                  const double,
                  const double);
  template void
  record_particles<2>(const Parts<2> &,
                      const ConvectionReport &,
                      const unsigned int,
                      const unsigned int);
  template void
  record_particles<3>(const Parts<3> &,
                      const ConvectionReport &,
                      const unsigned int,
                      const unsigned int);
} // namespace Thalweg
