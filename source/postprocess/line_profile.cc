// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/flow_access.h>
#include <thalweg/postprocess/scheduled_output.h>
#include <thalweg/postprocess/snapshot_table.h>

namespace Thalweg
{
  namespace
  {
    /// The flow at points along straight lines.
    template <int dim>
    class LineProfile : public ScheduledOutput<dim>
    {
    public:
      LineProfile()
        : ScheduledOutput<dim>("tables", 1e30)
      {}


      void
      check_for_flow(const FlowOutline<dim> &outline) const override
      {
        AssertThrow(
          !ends.empty() && ends.size() % 2 == 0,
          dealii::ExcMessage(
            "'line profile' needs two 'Ends' for each line, but has " +
            std::to_string(ends.size()) +
            "; write, for example, '0.5, 0; 0.5, 1'."));
        if (outline.fills_domain)
          check_points(outline.mesh, points(), "The point of a line profile");
      }


      void
      initialize_for_flow(Context &context, const FlowView<dim> &) override
      {
        std::vector<std::string> columns{"time [s]", "line", "distance [m]"};
        for (unsigned int d = 0; d < dim; ++d)
          columns.push_back(std::string(1, "xyz"[d]) + " [m]");
        for (unsigned int d = 0; d < dim; ++d)
          columns.push_back(std::string("velocity ") + "xyz"[d] + " [m/s]");
        columns.emplace_back("pressure [Pa]");
        table.open(context, "line_profile", columns);
      }

    private:
      void
      declare_own_parameters(const Section &section) override
      {
        section.add("Ends",
                    ends,
                    "m",
                    "The two ends of each line, all points separated by "
                    "semicolons, their coordinates by commas.");
        section.add("Number of points",
                    n_points,
                    "",
                    "How many equidistant points each line has, the ends "
                    "included.",
                    dealii::Patterns::Integer(2, 1000000));
        section.add("Fractions",
                    fractions,
                    "",
                    "The places of the points as fractions of the lines' "
                    "lengths, between 0 and 1, instead of equidistant ones.",
                    dealii::Patterns::List(dealii::Patterns::Double(0., 1.)));
      }


      std::vector<double>
      places() const
      {
        if (!fractions.empty())
          return fractions;
        std::vector<double> equidistant;
        for (unsigned int i = 0; i < n_points; ++i)
          equidistant.push_back(double(i) / (n_points - 1));
        return equidistant;
      }


      std::vector<dealii::Point<dim>>
      points() const
      {
        std::vector<dealii::Point<dim>> list;
        for (std::size_t line = 0; line + 1 < ends.size(); line += 2)
          for (const double place : places())
            list.push_back(ends[line] + place * (ends[line + 1] - ends[line]));
        return list;
      }


      void
      write(Context &context, const FlowView<dim> &solution) override
      {
        const auto list = points();
        const auto values =
          evaluate_at(solution, list, "The point of a line profile");
        const std::size_t                per_line = places().size();
        std::vector<std::vector<double>> rows;
        for (std::size_t p = 0; p < list.size(); ++p)
          {
            const std::size_t   line = p / per_line;
            std::vector<double> row{solution.time,
                                    double(line),
                                    list[p].distance(ends[2 * line])};
            for (unsigned int d = 0; d < dim; ++d)
              row.push_back(list[p][d]);
            for (unsigned int d = 0; d < dim; ++d)
              row.push_back(values[p].velocity[d]);
            row.push_back(values[p].pressure);
            rows.push_back(row);
          }
        table.write(context, rows);
      }


      void
      keep_files(const Archive &archive, const bool without_last) override
      {
        table.keep(archive, without_last);
      }


      std::vector<dealii::Point<dim>> ends;
      unsigned int                    n_points = 101;
      std::vector<double>             fractions;
      SnapshotTable                   table;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   LineProfile,
                   "line profile",
                   "velocity and pressure at points along straight lines, at "
                   "the start, the end and at intervals; writes "
                   "line_profile.csv and a file a time in line_profile.")
} // namespace Thalweg
