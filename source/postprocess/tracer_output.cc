// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/tracer_view.h>
#include <thalweg/particles/cell_maps.h>
#include <thalweg/postprocess/csv_file.h>
#include <thalweg/postprocess/point_patches.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/postprocess/pvd_record.h>
#include <thalweg/postprocess/schedule.h>

#include <algorithm>
#include <map>

namespace Thalweg
{
  namespace
  {
    /// Refuses a run without tracers.
    template <int dim>
    void
    check_tracers(const RunOutline<dim> &outline, const std::string &model)
    {
      AssertThrow(outline.offered.has("", "tracers"),
                  dealii::ExcMessage(
                    "No method of this run has tracers. Take '" + model +
                    "' out of 'Postprocess/Models', or add a method to "
                    "'Methods/Names': 'dye: tracers'."));
    }



    /// The tracers of all methods that have some, by the methods' names.
    template <int dim>
    std::map<std::string, const TracerView<dim> *>
    all_tracers(const SolutionView<dim> &solution)
    {
      return solution.ports->template all<const TracerView<dim>>("tracers");
    }



    /// The name of a method as that of a file.
    std::string
    as_file_name(std::string name)
    {
      std::replace(name.begin(), name.end(), ' ', '_');
      return name;
    }



    /// Tracers as points with numbers.
    template <int dim>
    PointPatches<dim>
    tracer_patches(const TracerCloud<dim> &cloud, const double time)
    {
      std::vector<std::string> names{"id", "age"};
      for (unsigned int d = 0; d < dim; ++d)
        names.push_back(std::string("origin_") + "xyz"[d]);
      const CellMaps<dim> maps(cloud.mesh().graph());
      PointPatches<dim>   points(names, cloud.members().size());
      for (std::size_t i = 0; i < cloud.members().size(); ++i)
        {
          const auto &[walker, tracer] = cloud.members()[i];
          const auto place = maps.to_space(walker.cell, walker.reference);
          dealii::Point<dim> position;
          for (unsigned int d = 0; d < dim; ++d)
            position[d] = place[d];
          auto &numbers = points.set(i, position);
          numbers(0, 0) = tracer.id;
          numbers(1, 0) = time - tracer.released;
          for (unsigned int d = 0; d < dim; ++d)
            numbers(2 + d, 0) = tracer.origin[d];
        }
      return points;
    }



    /// Tracers for ParaView.
    template <int dim>
    class TracerOutput : public Postprocessor<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        schedule.declare_parameters(section, "files");
      }

      void
      check(const RunOutline<dim> &outline) const override
      {
        check_tracers(outline, "tracers");
      }

      void
      initialize(Context &context, const SolutionView<dim> &solution) override
      {
        for (const auto &[name, tracers] : all_tracers(solution))
          records[name].open(context, as_file_name(name));
      }

      void
      execute(Context &context, const SolutionView<dim> &solution) override
      {
        const Moment &now = solution.moment;
        if (!schedule.is_due(now.time, now.last_step))
          return;
        for (const auto &[name, tracers] : all_tracers(solution))
          {
            auto patches = tracer_patches(tracers->cloud, now.time);
            records.at(name).write(context, patches, now.time, now.step);
          }
      }

      void
      keep(const State<dim> &state) override
      {
        schedule.keep(state.values());
        for (auto &[name, record] : records)
          record.keep(state.values().enter(name),
                      schedule.was_due_for_the_end());
      }

    private:
      Schedule                         schedule{.05};
      std::map<std::string, PvdRecord> records;
    };



    /// A row for each tracer that leaves.
    template <int dim>
    class TracerExits : public Postprocessor<dim>
    {
    public:
      void
      declare_parameters(const Section &) override
      {}

      void
      check(const RunOutline<dim> &outline) const override
      {
        check_tracers(outline, "tracer exits");
      }

      void
      initialize(Context &context, const SolutionView<dim> &solution) override
      {
        std::vector<std::string> columns{"time [s]",
                                         "tracer",
                                         "residence time [s]",
                                         "boundary"};
        for (const char *what : {"", "origin "})
          for (unsigned int d = 0; d < dim; ++d)
            columns.push_back(std::string(what) + "xyz"[d] + " [m]");
        for (const auto &[name, tracers] : all_tracers(solution))
          files[name].open(context, as_file_name(name) + "_exits.csv", columns);
      }

      void
      execute(Context &context, const SolutionView<dim> &solution) override
      {
        for (const auto &[name, tracers] : all_tracers(solution))
          files.at(name).write_rows(context,
                                    rows(context.communicator, *tracers));
      }

      void
      keep(const State<dim> &state) override
      {
        for (auto &[name, file] : files)
          file.keep(state.values().enter(name));
      }

    private:
      /// Of all ranks, in the order of time and number.
      static std::vector<std::vector<double>>
      rows(const MPI_Comm communicator, const TracerView<dim> &tracers)
      {
        std::vector<std::vector<double>> own, all;
        for (const TracerExit<dim> &exit : tracers.exits)
          {
            std::vector<double> row{exit.time,
                                    static_cast<double>(exit.tracer.id),
                                    exit.time - exit.tracer.released,
                                    static_cast<double>(exit.boundary)};
            row.insert(row.end(), exit.place.begin(), exit.place.end());
            row.insert(row.end(),
                       exit.tracer.origin.begin(),
                       exit.tracer.origin.end());
            own.push_back(row);
          }
        for (const auto &of_rank :
             dealii::Utilities::MPI::gather(communicator, own))
          all.insert(all.end(), of_rank.begin(), of_rank.end());
        std::sort(all.begin(), all.end());
        return all;
      }

      std::map<std::string, CsvFile> files;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   TracerOutput,
                   "tracers",
                   "tracers with their number, age and origin, for ParaView; "
                   "writes METHOD.pvd.")
  THALWEG_REGISTER(Postprocessor,
                   TracerExits,
                   "tracer exits",
                   "a row for each tracer that leaves the domain: when, after "
                   "what time, through which boundary, from where; writes "
                   "METHOD_exits.csv.")
} // namespace Thalweg
