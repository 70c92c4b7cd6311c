// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/scheduled_output.h>

namespace Thalweg
{
  template <int dim>
  void
  ScheduledOutput<dim>::declare_for_flow(const Section &section)
  {
    declare_own_parameters(section);
    schedule.declare_parameters(section, what);
  }


  template <int dim>
  void
  ScheduledOutput<dim>::execute_for_flow(Context             &context,
                                         const FlowView<dim> &solution)
  {
    if (schedule.is_due(solution.time, solution.last_step))
      write(context, solution);
  }


  template <int dim>
  void
  ScheduledOutput<dim>::keep(const State<dim> &state)
  {
    schedule.keep(state.values());
    keep_files(state.values(), schedule.was_due_for_the_end());
  }


  template <int dim>
  void
  TableOutput<dim>::initialize_for_flow(Context             &context,
                                        const FlowView<dim> &solution)
  {
    std::vector<std::string> names = columns(solution);
    names.insert(names.begin(), "time [s]");
    file.open(context, file_name, names);
  }


  template <int dim>
  void
  TableOutput<dim>::write(Context &context, const FlowView<dim> &solution)
  {
    std::vector<double> values = row(solution);
    values.insert(values.begin(), solution.time);
    file.write_row(context, values);
  }


  template <int dim>
  void
  TableOutput<dim>::keep_files(const Archive &archive, const bool without_last)
  {
    file.keep(archive, without_last);
  }


  template <int dim>
  void
  SeriesOutput<dim>::initialize_for_flow(Context &context,
                                         const FlowView<dim> &)
  {
    record.open(context, name);
  }


  template <int dim>
  void
  SeriesOutput<dim>::keep_files(const Archive &archive, const bool without_last)
  {
    record.keep(archive, without_last);
  }


  THALWEG_INSTANTIATE(ScheduledOutput)
  THALWEG_INSTANTIATE(TableOutput)
  THALWEG_INSTANTIATE(SeriesOutput)
} // namespace Thalweg
