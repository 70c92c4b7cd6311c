// SPDX-License-Identifier: LGPL-2.1-or-later
// What Simulation says before the first step, and what it checks in each.
#include <thalweg/core/errors.h>
#include <thalweg/simulation/simulation.h>

#include <algorithm>
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
      " cells, " + methods.size());
    const std::string warning =
      parameters.time.warning(parameters.scheme.step_numbers());
    if (!warning.empty())
      context.log.warning(warning);
    if (!context.resumed)
      methods.warn_at_start();
  }



  template <int dim>
  double
  Simulation<dim>::courant_number() const
  {
    double largest = 0.;
    for (const StepNumber &number : numbers)
      if (number.name == StepNumber::courant)
        {
          if (!std::isfinite(number.rate * dt))
            return number.rate * dt;
          largest = std::max(largest, number.rate * dt);
        }
    return largest;
  }



  template <int dim>
  void
  Simulation<dim>::check_courant_number() const
  {
    constexpr double largest = 1e4;
    const double     number  = courant_number();
    if (std::isfinite(number) && number < largest)
      return;
    std::ostringstream message;
    message << "In step " << step + 1 << " (t = " << time
            << " s) the Courant number is " << number
            << ": either the solution diverges, or the step is far too long. "
               "Reduce 'Time/Courant number' or 'Time/Time step', and check "
               "velocities and units in the input.";
    throw StepRefused(message.str());
  }



  template void
  Simulation<2>::announce();
  template void
  Simulation<3>::announce();
  template double
  Simulation<2>::courant_number() const;
  template double
  Simulation<3>::courant_number() const;
  template void
  Simulation<2>::check_courant_number() const;
  template void
  Simulation<3>::check_courant_number() const;
} // namespace Thalweg
