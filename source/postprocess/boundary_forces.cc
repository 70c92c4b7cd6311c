// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/q1_cell.h>
#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/scheduled_output.h>

namespace Thalweg
{
  namespace
  {
    /// The forces that the fluids exert on boundaries.
    template <int dim>
    class BoundaryForces : public TableOutput<dim>
    {
    public:
      BoundaryForces()
        : TableOutput<dim>("boundary_forces.csv")
      {}


      void
      check_for_flow(const FlowOutline<dim> &outline) const override
      {
        for (const std::string &name : names)
          outline.mesh.boundary_id(name);
      }

    private:
      void
      declare_own_parameters(const Section &section) override
      {
        section.add("Boundaries",
                    names,
                    "",
                    "Names of boundaries, separated by commas; empty: all.");
      }


      std::vector<std::string>
      columns(const FlowView<dim> &solution) override
      {
        if (names.empty())
          for (const auto &[name, id] : solution.mesh.boundary_names())
            names.push_back(name);
        std::vector<std::string> columns;
        for (const std::string &name : names)
          {
            ids.push_back(solution.mesh.boundary_id(name));
            for (const std::string part : {"pressure", "viscous"})
              for (unsigned int d = 0; d < dim; ++d)
                columns.push_back(name + " " + part + " force " + "xyz"[d] +
                                  (dim == 2 ? " [N/m]" : " [N]"));
          }
        return columns;
      }


      std::vector<double>
      row(const FlowView<dim> &solution) override
      {
        const CellGraph<dim> &graph = solution.mesh.graph();
        std::vector<double>   values(2 * dim * names.size(), 0.);
        for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
          for (unsigned int f = 0; f < graph.n_faces; ++f)
            {
              const auto &face = graph.cell(c).faces[f];
              if (face.behind != CellGraph<dim>::Behind::boundary)
                continue;
              for (std::size_t b = 0; b < ids.size(); ++b)
                if (ids[b] == face.boundary_id)
                  add_face(solution, c, f, &values[2 * dim * b]);
            }
        dealii::Utilities::MPI::sum(
          values, solution.mesh.triangulation().get_communicator(), values);
        return values;
      }


      /// Adds a face's pressure and viscous force, p n and -mu (grad v +
      /// grad v^T) n with n out of the fluid.
      static void
      add_face(const FlowView<dim> &solution,
               const unsigned int   c,
               const unsigned int   f,
               double *const        forces)
      {
        static const Q1::Gauss<dim> gauss;
        const auto                 &nodes = solution.space.nodes(c);
        const auto                  phi   = cell_level_set(solution, c);
        for (unsigned int q = 0; q < gauss.n_points; ++q)
          {
            // Of two points that fall together on the face one is enough.
            if (((q >> (f / 2)) & 1u) == 1u)
              continue;
            dealii::Point<dim> xi = gauss.points[q];
            xi[f / 2]             = f % 2;
            const auto shape =
              Q1::evaluate<dim>(solution.mesh.graph().cell(c),
                                Q1::values<dim>(xi),
                                Q1::reference_gradients<dim>(xi));
            dealii::Tensor<1, dim> reference_normal;
            reference_normal[f / 2] = f % 2 ? 1. : -1.;
            const dealii::Tensor<1, dim> normal_dS =
              2. * gauss.weight * shape.determinant *
              (shape.covariant * reference_normal);

            double                 pressure = 0., level_set = 0.;
            dealii::Tensor<2, dim> gradient;
            for (unsigned int v = 0; v < nodes.size(); ++v)
              {
                pressure +=
                  shape.values[v] * solution.pressure.local_element(nodes[v]);
                level_set += shape.values[v] * phi[v];
                for (unsigned int d = 0; d < dim; ++d)
                  gradient[d] +=
                    solution.velocity.local_element(dim * nodes[v] + d) *
                    shape.gradients[v];
              }
            const dealii::Tensor<1, dim> viscous =
              -solution.fluids.at(level_set).viscosity *
              ((gradient + transpose(gradient)) * normal_dS);
            for (unsigned int d = 0; d < dim; ++d)
              {
                forces[d] += pressure * normal_dS[d];
                forces[dim + d] += viscous[d];
              }
          }
      }


      std::vector<std::string>                names;
      std::vector<dealii::types::boundary_id> ids;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   BoundaryForces,
                   "boundary forces",
                   "the force of pressure and the viscous force on "
                   "boundaries; writes boundary_forces.csv.")
} // namespace Thalweg
