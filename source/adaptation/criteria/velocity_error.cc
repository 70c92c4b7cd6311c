// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/adaptation/refinement_criterion.h>
#include <thalweg/postprocess/flow_access.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/numerics/error_estimator.h>

namespace Thalweg
{
  namespace
  {
    /// Kelly's estimator.
    template <int dim>
    class VelocityError : public FlowCriterion<dim>
    {
    public:
      void
      declare_for_flow(const Section &) override
      {}



      void
      evaluate_for_flow(const FlowView<dim> &solution,
                        const LevelRange &,
                        const double,
                        CellWishes &wishes) override
      {
        const FlowFields<dim> flow = flow_of(solution);
        const auto           &mesh = solution.mesh;
        dealii::Vector<float> errors(mesh.triangulation().n_active_cells());
        dealii::KellyErrorEstimator<dim>::estimate(
          flow.mapping,
          flow.velocity_dofs,
          dealii::QGauss<dim - 1>(flow.velocity_dofs.get_fe().degree + 1),
          {},
          flow.velocity,
          errors,
          dealii::ComponentMask(),
          nullptr,
          dealii::numbers::invalid_unsigned_int,
          mesh.triangulation().locally_owned_subdomain());
        for (unsigned int c = 0; c < wishes.indicator.size(); ++c)
          wishes.indicator[c] =
            errors[mesh.graph().iterator(c)->active_cell_index()];
      }
    };
  } // namespace

  THALWEG_REGISTER(RefinementCriterion,
                   VelocityError,
                   "velocity error",
                   "Kelly's estimator: the jumps of the velocity's normal "
                   "derivative over the faces of a cell, in m^(d/2)/s.")
} // namespace Thalweg
