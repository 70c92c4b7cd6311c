// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/machine.h>
#include <thalweg/simulation/memory_estimate.h>

#include <deal.II/base/exceptions.h>

#include <sstream>

namespace Thalweg
{
  namespace
  {
    // Measured with 65,000 cells in 2D and 33,000 in 3D: 4.2 and 13.5 kB
    // a cell, 230 bytes a particle.
    constexpr double bytes_per_cell_2d  = 3000.;
    constexpr double bytes_per_cell_3d  = 10000.;
    constexpr double bytes_per_particle = 200.;
    constexpr double giga               = 1e9;
  } // namespace



  MemoryEstimate::MemoryEstimate(const MPI_Comm communicator,
                                 const int      dim,
                                 const double   particles_per_cell,
                                 const double   limit)
    : bytes_per_cell((dim == 2 ? bytes_per_cell_2d : bytes_per_cell_3d) +
                     particles_per_cell * bytes_per_particle)
    , particles_per_cell(particles_per_cell)
    , limit(limit > 0. ? limit * giga : memory_of_machines(communicator))
    , is_given(limit > 0.)
  {}



  double
  MemoryEstimate::most_cells() const
  {
    return limit / bytes_per_cell;
  }



  void
  MemoryEstimate::check(const double n_cells) const
  {
    if (n_cells <= most_cells())
      return;
    std::ostringstream message;
    message.precision(3);
    message << "The mesh would have " << n_cells << " cells or more, with "
            << particles_per_cell << " particles each. They need at least "
            << n_cells * bytes_per_cell / giga << " GB of memory, but "
            << (is_given ? "'Refinement/Memory limit' is " : "there are only ")
            << limit / giga
            << " GB. Make fewer cells ('Geometry', 'Refinement') or particles "
               "('Particles'), or use more machines. 'Refinement/Memory limit' "
               "can be set if you know better.";
    AssertThrow(false, dealii::ExcMessage(message.str()));
  }
} // namespace Thalweg
