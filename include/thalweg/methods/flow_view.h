// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_flow_view_h
#define thalweg_methods_flow_view_h

#include <thalweg/fields/flow_fields.h>
#include <thalweg/fields/node_space.h>
#include <thalweg/materials/fluids.h>
#include <thalweg/particles/population.h>

#include <deal.II/base/tensor.h>

namespace Thalweg
{
  /// What is known of a flow before a run begins.
  template <int dim>
  struct FlowOutline
  {
    /// The mesh, or a coarser one of the same domain.
    const Mesh<dim> &mesh;
    const Fluids    &fluids;
    /// Whether the mesh fills the domain exactly; a coarse one with curved
    /// sides does not.
    bool fills_domain = true;
    /// Whether there can be drops and bubbles, see FlowView.
    bool has_dispersed = true;
  };



  /**
   * @brief A flow as those see it who only look.
   *
   * Vectors are ghosted and consistent with their constraints.
   */
  template <int dim>
  struct FlowView
  {
    const Mesh<dim>       &mesh;
    const NodeSpace<dim>  &space;
    const Fluids          &fluids;
    const Population<dim> &population;
    const Vector          &velocity; ///< m/s, on space.velocity()
    const Vector          &pressure; ///< Pa, on space.scalar()
    const Vector &level_set;         ///< negative in fluid 0, on space.scalar()

    double time      = 0.; ///< s
    double time_step = 0.; ///< s; 0 at the start
    /// The time of the velocity in s: half a step ahead if it is staggered.
    double       velocity_time = 0.;
    unsigned int step          = 0;
    double       end_time      = 0.; ///< s
    bool         last_step     = false;

    /// The flow in its own spaces, where the method has such; then velocity
    /// and pressure above are its values at the vertices. Else nullptr.
    const FlowFields<dim> *flow = nullptr;

    /// Drops and bubbles that take no part in the flow; nullptr where there
    /// can be none.
    const Population<dim> *dispersed = nullptr;
  };
} // namespace Thalweg

#endif
