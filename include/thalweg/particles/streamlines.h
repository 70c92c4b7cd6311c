// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_streamlines_h
#define thalweg_particles_streamlines_h

#include <thalweg/particles/streamline_walk.h>

namespace Thalweg
{
  /**
   * @brief What a method with a velocity offers others, under "streamlines".
   */
  template <int dim>
  class Streamlines
  {
  public:
    virtual ~Streamlines() = default;

    /// Along the velocity of the last step, with the walls of the flow.
    virtual StreamlineWalk<dim>
    streamlines() const = 0;
  };
} // namespace Thalweg

#endif
