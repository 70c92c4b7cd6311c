// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_support_whole_h
#define tests_support_whole_h

#include <thalweg/methods/solution_view.h>

/// A solution that consists of one flow.
template <int dim>
Thalweg::SolutionView<dim>
whole(const Thalweg::FlowView<dim> &flow)
{
  Thalweg::SolutionView<dim> solution{
    flow.mesh,
    {flow.time, flow.time_step, flow.step, flow.end_time, flow.last_step},
    {}};
  solution.flows.add("", flow);
  return solution;
}

/// A run that consists of one flow.
template <int dim>
Thalweg::RunOutline<dim>
whole(const Thalweg::FlowOutline<dim> &flow)
{
  Thalweg::RunOutline<dim> outline{flow.mesh, flow.fills_domain, {}};
  outline.flows.add("", flow);
  return outline;
}

#endif
