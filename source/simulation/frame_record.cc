// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/simulation/frame_record.h>

namespace Thalweg
{
  template <int dim>
  void
  announce_frame(const MovingFrame<dim> &frame, Context &context)
  {
    if (!frame.is_active())
      return;
    context.table_comment =
      "in the axes of the tank, which moves ('Moving frame')";
    context.log.line(frame.description());
  }



  template <int dim>
  void
  record_frame(const MovingFrame<dim> &frame,
               const double            time,
               Statistics             &statistics)
  {
    if (!frame.is_active())
      return;
    const auto state = frame.at(time);
    statistics.set("angle of the tank [rad]", state.angle);
    for (unsigned int d = 0; d < dim; ++d)
      statistics.set(std::string("acceleration of the tank ") + "xyz"[d] +
                       " [m/s^2]",
                     state.acceleration[d]);
  }



#define INSTANTIATE(dim)                                             \
  template void announce_frame(const MovingFrame<dim> &, Context &); \
  template void record_frame(const MovingFrame<dim> &,               \
                             const double,                           \
                             Statistics &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Thalweg
