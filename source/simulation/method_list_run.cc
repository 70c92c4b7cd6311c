// SPDX-License-Identifier: LGPL-2.1-or-later
// What MethodList does during a run.
#include <thalweg/simulation/method_list.h>

namespace Thalweg
{
  template <int dim>
  void
  MethodList<dim>::create(Context         &context_,
                          Mesh<dim>       &mesh,
                          BodyForces<dim> &forces)
  {
    context = &context_;
    for (const Entry &entry : used())
      entry.method->create({entry.name, *context, mesh, forces, ports});
  }



  template <int dim>
  void
  MethodList<dim>::release()
  {
    ports = {};
    for (const Entry &entry : used())
      entry.method->release();
  }



  template <int dim>
  void
  MethodList<dim>::attach()
  {
    for (const Entry &entry : used())
      {
        entry.method->attach();
        entry.method->offer(ports);
      }
  }



  template <int dim>
  void
  MethodList<dim>::initialize()
  {
    for (const Entry &entry : used())
      {
        entry.method->initialize();
        entry.method->offer(ports);
      }
  }



  template <int dim>
  void
  MethodList<dim>::clear()
  {
    for (const Entry &entry : used())
      entry.method->clear();
  }



  template <int dim>
  void
  MethodList<dim>::keep_constants(const Archive &archive)
  {
    for (const Entry &entry : used())
      entry.method->keep_constants(archive.enter(entry.prefix() + "method"));
  }



  template <int dim>
  void
  MethodList<dim>::keep(const State<dim> &state)
  {
    for (const Entry &entry : used())
      entry.method->keep(state.enter(entry.prefix() + "method"));
  }



  template <int dim>
  void
  MethodList<dim>::update()
  {
    for (const Entry &entry : used())
      entry.method->update();
  }



  template <int dim>
  void
  MethodList<dim>::repopulate()
  {
    for (const Entry &entry : used())
      entry.method->repopulate();
  }



  template <int dim>
  void
  MethodList<dim>::check_conditions(const double time) const
  {
    for (const Entry &entry : used())
      entry.method->check_conditions(time);
  }



  template <int dim>
  void
  MethodList<dim>::check_conditions_of_step(const double end) const
  {
    for (const Entry &entry : used())
      entry.method->check_conditions_of_step(end);
  }



  template <int dim>
  StepNumbers
  MethodList<dim>::step_numbers() const
  {
    StepNumbers all;
    for (const Entry &entry : used())
      for (StepNumber number : entry.method->step_numbers())
        {
          number.method = entry.name;
          all.push_back(number);
        }
    return all;
  }



  template <int dim>
  void
  MethodList<dim>::record(const double time)
  {
    for (const Entry &entry : used())
      {
        const Statistics::Group group(context->statistics, entry.name);
        entry.method->record(time);
      }
  }



  template <int dim>
  void
  MethodList<dim>::warn_at_start() const
  {
    for (const Entry &entry : used())
      entry.method->warn_at_start();
  }



#define THALWEG_INSTANTIATE_RUN(dim)                                           \
  template void MethodList<dim>::create(Context &,                             \
                                        Mesh<dim> &,                           \
                                        BodyForces<dim> &);                    \
  template void MethodList<dim>::release();                                    \
  template void MethodList<dim>::attach();                                     \
  template void MethodList<dim>::initialize();                                 \
  template void MethodList<dim>::clear();                                      \
  template void MethodList<dim>::keep_constants(const Archive &);              \
  template void MethodList<dim>::keep(const State<dim> &);                     \
  template void MethodList<dim>::update();                                     \
  template void MethodList<dim>::repopulate();                                 \
  template void MethodList<dim>::check_conditions(const double) const;         \
  template void MethodList<dim>::check_conditions_of_step(const double) const; \
  template StepNumbers MethodList<dim>::step_numbers() const;                  \
  template void        MethodList<dim>::record(const double);                  \
  template void        MethodList<dim>::warn_at_start() const;
  THALWEG_INSTANTIATE_RUN(2)
  THALWEG_INSTANTIATE_RUN(3)
#undef THALWEG_INSTANTIATE_RUN
} // namespace Thalweg
