// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/tracer_view.h>
#include <thalweg/particles/cell_maps.h>
#include <thalweg/postprocess/offered_output.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    /// Tracers for ParaView.
    template <int dim>
    class TracerOutput : public PointOutput<dim, const TracerView<dim>>
    {
    public:
      TracerOutput()
        : PointOutput<dim, const TracerView<dim>>("tracers", "dye: tracers")
      {}

    private:
      PointPatches<dim>
      points(const TracerView<dim> &tracers, const double time) const override
      {
        const auto              &cloud = tracers.cloud;
        std::vector<std::string> names{"id", "age"};
        for (unsigned int d = 0; d < dim; ++d)
          names.push_back(std::string("origin_") + "xyz"[d]);
        const CellMaps<dim> maps(cloud.mesh().graph());
        PointPatches<dim>   patches(names, cloud.members().size());
        for (std::size_t i = 0; i < cloud.members().size(); ++i)
          {
            const auto &[walker, tracer] = cloud.members()[i];
            const auto place = maps.to_space(walker.cell, walker.reference);
            dealii::Point<dim> position;
            for (unsigned int d = 0; d < dim; ++d)
              position[d] = place[d];
            auto &numbers = patches.set(i, position);
            numbers(0, 0) = tracer.id;
            numbers(1, 0) = time - tracer.released;
            for (unsigned int d = 0; d < dim; ++d)
              numbers(2 + d, 0) = tracer.origin[d];
          }
        return patches;
      }
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
        check_offered(outline.offered,
                      "tracers",
                      "tracer exits",
                      "dye: tracers");
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
          tables[name].open(context,
                            file_name_of(name, "tracers") + "_exits.csv",
                            columns);
      }

      void
      execute(Context &context, const SolutionView<dim> &solution) override
      {
        for (const auto &[name, tracers] : all_tracers(solution))
          tables[name].write_rows(context,
                                  rows(context.communicator, *tracers));
      }

      void
      keep(const State<dim> &state) override
      {
        tables.keep(state.values());
      }

    private:
      static std::map<std::string, const TracerView<dim> *>
      all_tracers(const SolutionView<dim> &solution)
      {
        return solution.ports->template all<const TracerView<dim>>("tracers");
      }

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

      TablesOfMethods tables;
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
