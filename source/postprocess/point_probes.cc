#include <thalweg/fields/q1_cell.h>
#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/csv_file.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/postprocess/schedule.h>

namespace Thalweg
{
  namespace
  {
    /// The fields at given points.
    template <int dim>
    class PointProbes : public Postprocessor<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        section.add("Points",
                    points,
                    "m",
                    "The points, separated by semicolons, their coordinates "
                    "by commas.");
        schedule.declare_parameters(section, "rows");
      }


      void
      initialize(Context &context, const SolutionView<dim> &solution) override
      {
        AssertThrow(!points.empty(),
                    dealii::ExcMessage("'point probes' has no 'Points'; give "
                                       "some or take it off the list."));
        locate(solution.mesh, points, "The point probe");
        std::vector<std::string> columns{"time [s]"};
        for (std::size_t p = 0; p < points.size(); ++p)
          {
            const std::string number = " " + std::to_string(p);
            columns.push_back("pressure" + number + " [Pa]");
            for (unsigned int d = 0; d < dim; ++d)
              columns.push_back(std::string("velocity ") + "xyz"[d] + number +
                                " [m/s]");
            columns.push_back("level set" + number + " [m]");
          }
        file.open(context, "point_probes.csv", columns);
      }


      void
      execute(Context &context, const SolutionView<dim> &solution) override
      {
        if (!schedule.is_due(solution.time, solution.last_step))
          return;
        // Located anew each time, since the mesh may have changed.
        const auto located = locate(solution.mesh, points, "The point probe");
        std::vector<double> row(1 + points.size() * (dim + 2), 0.);
        for (std::size_t p = 0; p < points.size(); ++p)
          if (located[p].is_here)
            evaluate(solution, located[p], &row[1 + p * (dim + 2)]);
        dealii::Utilities::MPI::sum(row, context.communicator, row);
        row[0] = solution.time;
        file.write_row(context, row);
      }

    private:
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
      Schedule                        schedule;
      CsvFile                         file;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   PointProbes,
                   "point probes",
                   "pressure, velocity and level set at given points; writes "
                   "point_probes.csv.")
} // namespace Thalweg
