// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_tracer_view_h
#define thalweg_methods_tracer_view_h

#include <thalweg/particles/tracer_cloud.h>

namespace Thalweg
{
  /// What a method with tracers offers under "tracers".
  template <int dim>
  struct TracerView
  {
    TracerCloud<dim>             cloud;
    std::vector<TracerExit<dim>> exits; ///< in the last step, on this rank
  };
} // namespace Thalweg

#endif
