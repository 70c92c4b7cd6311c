// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/averaging_window.h>
#include <thalweg/postprocess/flow_access.h>
#include <thalweg/postprocess/flow_means.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/postprocess/pvd_record.h>
#include <thalweg/postprocess/schedule.h>

#include <deal.II/numerics/data_out.h>

namespace Thalweg
{
  namespace
  {
    /// Mean fields and Reynolds stresses.
    template <int dim>
    class TimeAverages : public FlowPostprocessor<dim>
    {
    public:
      TimeAverages()
        : schedule(1e30)
        , means(/* with_stresses */ true)
      {}


      void
      declare_for_flow(const Section &section) override
      {
        window.declare_parameters(section);
        schedule.declare_parameters(section, "files");
      }


      void
      check_for_flow(const FlowOutline<dim> &) const override
      {
        window.check("time averages");
      }


      void
      initialize_for_flow(Context             &context,
                          const FlowView<dim> &solution) override
      {
        record.open(context, "time_averages");
        mesh_changed_for_flow(solution);
      }


      void
      mesh_changed_for_flow(const FlowView<dim> &solution) override
      {
        means.initialize(solution.mesh, flow_of(solution));
      }


      void
      keep(const State<dim> &state) override
      {
        schedule.keep(state.values());
        record.keep(state.values(),
                    schedule.was_due_for_the_end() &&
                      means.averaged_time() > 0.);
        means.keep(state);
      }


      void
      execute_for_flow(Context &context, const FlowView<dim> &solution) override
      {
        const bool is_due = schedule.is_due(solution.time, solution.last_step);
        const double weight = window.overlap(solution.time, solution.time_step);
        const FlowFields<dim> flow = flow_of(solution);
        if (weight > 0.)
          means.add(flow, weight);
        if (is_due && means.averaged_time() > 0.)
          write(context, solution, means.flow(flow));
      }

    private:
      void
      write(Context               &context,
            const FlowView<dim>   &solution,
            const FlowFields<dim> &mean)
      {
        using namespace dealii::DataComponentInterpretation;
        const std::vector<DataComponentInterpretation> is_vector(
          dim, component_is_part_of_vector);
        dealii::DataOut<dim> data;
        data.add_data_vector(mean.velocity_dofs,
                             mean.velocity,
                             std::vector<std::string>(dim, "mean_velocity"),
                             is_vector);
        data.add_data_vector(mean.pressure_dofs,
                             mean.pressure,
                             "mean_pressure");
        std::array<Vector, dim> stresses;
        for (unsigned int d = 0; d < dim; ++d)
          {
            stresses[d] = means.stress(d);
            data.add_data_vector(mean.velocity_dofs,
                                 stresses[d],
                                 std::vector<std::string>(
                                   dim,
                                   std::string("reynolds_stress_") + "xyz"[d]),
                                 is_vector);
          }
        data.build_patches(mean.mapping,
                           mean.velocity_dofs.get_fe().degree,
                           dealii::DataOut<dim>::curved_inner_cells);
        record.write(context, data, solution.time, solution.step);
      }


      AveragingWindow window;
      Schedule        schedule;
      PvdRecord       record;
      FlowMeans<dim>  means;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   TimeAverages,
                   "time averages",
                   "means of velocity and pressure and the Reynolds stresses "
                   "(mean products of the velocity's fluctuations, a row of "
                   "the tensor a vector) on the mesh, for ParaView; writes "
                   "time_averages.pvd.")
} // namespace Thalweg
