// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/flow_access.h>
#include <thalweg/postprocess/scheduled_output.h>

#include <deal.II/numerics/data_out.h>

namespace Thalweg
{
  namespace
  {
    /// The fields for ParaView.
    template <int dim>
    class FieldOutput : public SeriesOutput<dim>
    {
    public:
      FieldOutput()
        : SeriesOutput<dim>("fields")
      {}

    private:
      void
      write(Context &context, const FlowView<dim> &solution) override
      {
        using namespace dealii::DataComponentInterpretation;
        const Vector          density = nodal_density(solution);
        dealii::DataOut<dim>  data;
        const FlowFields<dim> flow = flow_of(solution);
        data.add_data_vector(flow.velocity_dofs,
                             flow.velocity,
                             std::vector<std::string>(dim, "velocity"),
                             std::vector<DataComponentInterpretation>(
                               dim, component_is_part_of_vector));
        const auto &scalar = solution.space.scalar();
        data.add_data_vector(flow.pressure_dofs, flow.pressure, "pressure");
        data.add_data_vector(scalar, density, "density");
        if (solution.fluids.size() == 2)
          data.add_data_vector(scalar, solution.level_set, "level_set");

        const auto           &mesh = solution.mesh.triangulation();
        dealii::Vector<float> subdomain(mesh.n_active_cells());
        subdomain = mesh.locally_owned_subdomain();
        data.add_data_vector(subdomain, "subdomain");
        data.build_patches(flow.mapping,
                           flow.velocity_dofs.get_fe().degree,
                           dealii::DataOut<dim>::curved_inner_cells);
        this->record.write(context, data, solution.time, solution.step);
      }


      /// The density of the fluid at each node.
      static Vector
      nodal_density(const FlowView<dim> &solution)
      {
        Vector density;
        solution.space.initialize_scalar(density);
        for (unsigned int c = 0; c < solution.mesh.graph().n_cells(); ++c)
          for (const unsigned int node : solution.space.nodes(c))
            density.local_element(node) =
              solution.fluids.at(solution.level_set.local_element(node))
                .density;
        return density;
      }
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   FieldOutput,
                   "fields",
                   "velocity, pressure, level set and density on the mesh, "
                   "for ParaView; writes fields.pvd.")
} // namespace Thalweg
