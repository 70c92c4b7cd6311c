// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/postprocessor.h>

namespace Thalweg
{
  template <int dim>
  void
  FlowPostprocessor<dim>::declare_parameters(const Section &section)
  {
    declare_for_flow(section);
    declare_flow_choice(section, method);
  }



  template <int dim>
  void
  FlowPostprocessor<dim>::check(const RunOutline<dim> &outline) const
  {
    check_for_flow(outline.flow(method));
  }



  template <int dim>
  void
  FlowPostprocessor<dim>::initialize(Context                 &context,
                                     const SolutionView<dim> &solution)
  {
    initialize_for_flow(context, solution.flow(method));
  }



  template <int dim>
  void
  FlowPostprocessor<dim>::execute(Context                 &context,
                                  const SolutionView<dim> &solution)
  {
    execute_for_flow(context, solution.flow(method));
  }



  template <int dim>
  void
  FlowPostprocessor<dim>::mesh_changed(const SolutionView<dim> &solution)
  {
    mesh_changed_for_flow(solution.flow(method));
  }



  THALWEG_INSTANTIATE(FlowPostprocessor)
} // namespace Thalweg
