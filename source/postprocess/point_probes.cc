#include <thalweg/fields/q1_cell.h>
#include <thalweg/postprocess/cell_access.h>
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
      check(const RunOutline<dim> &outline) const override
      {
        AssertThrow(!points.empty(),
                    dealii::ExcMessage("'point probes' has no 'Points'; give "
                                       "some or take it off the list."));
        if (outline.fills_domain)
          locate(outline.mesh, points, "The point probe");
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
      columns(const SolutionView<dim> &) override
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
      row(const SolutionView<dim> &solution) override
      {
        // Located anew each time, since the mesh may have changed.
        const auto located = locate(solution.mesh, points, "The point probe");
        std::vector<double> values(points.size() * (dim + 2), 0.);
        for (std::size_t p = 0; p < points.size(); ++p)
          if (located[p].is_here)
            evaluate(solution, located[p], &values[p * (dim + 2)]);
        dealii::Utilities::MPI::sum(
          values, solution.mesh.triangulation().get_communicator(), values);
        return values;
      }


      /// Writes pressure, velocity and level set to @p values.
      static void
      evaluate(const SolutionView<dim> &solution,
               const LocatedPoint<dim> &point,
               double *const            values)
      {
        const auto  shape = Q1::values<dim>(point.xi);
        const auto &nodes = solution.space.nodes(point.cell);
        const auto  phi   = cell_level_set(solution, point.cell);
        for (unsigned int v = 0; v < shape.size(); ++v)
          {
            values[0] += shape[v] * solution.pressure.local_element(nodes[v]);
            for (unsigned int d = 0; d < dim; ++d)
              values[1 + d] +=
                shape[v] * solution.velocity.local_element(dim * nodes[v] + d);
            values[dim + 1] += shape[v] * phi[v];
          }
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
