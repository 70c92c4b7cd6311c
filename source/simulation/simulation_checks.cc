// SPDX-License-Identifier: LGPL-2.1-or-later
// What Simulation says before the first step, and what it checks in each.
#include <thalweg/core/errors.h>
#include <thalweg/simulation/missing_fluid.h>
#include <thalweg/simulation/simulation.h>

#include <cmath>
#include <sstream>

namespace Thalweg
{
  template <int dim>
  void
  Simulation<dim>::announce()
  {
    context.log.line(
      std::to_string(mesh.triangulation().n_global_active_cells()) +
      " cells, " + std::to_string(parts->nodes().n_dofs()) +
      " degrees of freedom, " +
      std::to_string(parts->particles().n_global_particles()) + " particles");
    const std::string warning = parameters.time.warning(viscous);
    if (!warning.empty())
      context.log.warning(warning);
    std::string missing;
    if (!context.resumed && parameters.method->computes_flow())
      missing = missing_fluid(parts->particles(), parameters.fluids);
    if (!missing.empty())
      context.log.warning(missing);
  }



  template <int dim>
  void
  Simulation<dim>::check_courant_number(const double courant_number) const
  {
    constexpr double largest = 1e4;
    if (std::isfinite(courant_number) && courant_number < largest)
      return;
    std::ostringstream message;
    message << "In step " << step + 1 << " (t = " << time
            << " s) the Courant number is " << courant_number
            << ": either the solution diverges, or the step is far too long. "
               "Reduce 'Time/Courant number' or 'Time/Time step', and check "
               "velocities and units in the input.";
    throw StepRefused(message.str());
  }



  template void
  Simulation<2>::announce();
  template void
  Simulation<3>::announce();
  template void
  Simulation<2>::check_courant_number(const double) const;
  template void
  Simulation<3>::check_courant_number(const double) const;
} // namespace Thalweg
