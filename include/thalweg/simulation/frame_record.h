// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_frame_record_h
#define thalweg_simulation_frame_record_h

#include <thalweg/core/context.h>
#include <thalweg/fluid/moving_frame.h>

namespace Thalweg
{
  /// Says in the log and above all tables in whose axes everything is, if
  /// the tank moves. Call it before tables are opened.
  template <int dim>
  void
  announce_frame(const MovingFrame<dim> &frame, Context &context);

  /// Writes the motion at @p time into the statistics, if the tank moves.
  template <int dim>
  void
  record_frame(const MovingFrame<dim> &frame,
               const double            time,
               Statistics             &statistics);
} // namespace Thalweg

#endif
