#include <thalweg/simulation/simulation.h>

#include <cmath>
#include <sstream>

namespace Thalweg
{
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
    AssertThrow(false, dealii::ExcMessage(message.str()));
  }



  template void
  Simulation<2>::check_courant_number(const double) const;
  template void
  Simulation<3>::check_courant_number(const double) const;
} // namespace Thalweg
