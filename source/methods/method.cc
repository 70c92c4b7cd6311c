#include <thalweg/methods/method.h>

namespace Thalweg
{
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
    statistics.set("particles lost", report.n_lost);
    statistics.set("particle substeps", report.n_substeps);
    if (report.n_lost > 0)
      parts.context.log.warning(
        std::to_string(report.n_lost) +
        " particles were lost: their velocity is not a number or they could "
        "not be located.");
  }



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
