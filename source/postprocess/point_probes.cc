// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/q1_cell.h>
#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/flow_access.h>
#include <thalweg/postprocess/scheduled_output.h>

namespace Thalweg
{
  namespace
  {
    /// The fields at given points.
    template <int dim>
    class PointProbes : public TableOutput<dim>
    {
    public:
      PointProbes()
        : TableOutput<dim>("point_probes.csv")
      {}


      void
      check_for_flow(const FlowOutline<dim> &outline) const override
      {
        AssertThrow(!points.empty(),
                    dealii::ExcMessage("'point probes' has no 'Points'; give "
                                       "some or take it off the list."));
        if (outline.fills_domain)
          check_points(outline.mesh, points, "The point probe");
      }

    private:
      void
      declare_own_parameters(const Section &section) override
      {
        section.add("Points",
                    points,
                    "m",
                    "The points, separated by semicolons, their coordinates "
                    "by commas.");
      }


      std::vector<std::string>
      columns(const FlowView<dim> &) override
      {
        std::vector<std::string> names;
        for (std::size_t p = 0; p < points.size(); ++p)
          {
            const std::string number = " " + std::to_string(p);
            names.push_back("pressure" + number + " [Pa]");
            for (unsigned int d = 0; d < dim; ++d)
              names.push_back(std::string("velocity ") + "xyz"[d] + number +
                              " [m/s]");
            names.push_back("level set" + number + " [m]");
          }
        return names;
      }


      std::vector<double>
      row(const FlowView<dim> &solution) override
      {
        const auto flow = evaluate_at(solution, points, "The point probe");
        const auto phi  = level_sets(solution);
        std::vector<double> values;
        for (std::size_t p = 0; p < points.size(); ++p)
          {
            values.push_back(flow[p].pressure);
            for (unsigned int d = 0; d < dim; ++d)
              values.push_back(flow[p].velocity[d]);
            values.push_back(phi[p]);
          }
        return values;
      }


      /// The level set at the points; negative for a single fluid.
      std::vector<double>
      level_sets(const FlowView<dim> &solution) const
      {
        std::vector<double> values(points.size(), -1.);
        if (solution.fluids.size() == 1)
          return values;
        const auto located = locate(solution.mesh, points, "The point probe");
        for (std::size_t p = 0; p < points.size(); ++p)
          {
            values[p] = 0.;
            if (!located[p].is_here)
              continue;
            const auto shape = Q1::values<dim>(located[p].xi);
            const auto phi   = cell_level_set(solution, located[p].cell);
            for (unsigned int v = 0; v < shape.size(); ++v)
              values[p] += shape[v] * phi[v];
          }
        dealii::Utilities::MPI::sum(
          values, solution.mesh.triangulation().get_communicator(), values);
        return values;
      }


      std::vector<dealii::Point<dim>> points;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   PointProbes,
                   "point probes",
                   "pressure, velocity and level set at given points; writes "
                   "point_probes.csv.")
} // namespace Thalweg
