// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables of single grains, of what leaves, and of the forces on walls.
#include <thalweg/postprocess/grain_table.h>

namespace Thalweg
{
  namespace
  {
    /// One grain in each step.
    template <int dim>
    class OneGrain : public GrainTable<dim>
    {
    public:
      OneGrain()
        : GrainTable<dim>("one grain")
      {}

      void
      declare_parameters(const Section &section) override
      {
        section.add("Grain", id, "", "The number of the grain.");
      }

      void
      initialize(Context &context, const SolutionView<dim> &solution) override
      {
        std::vector<std::string> columns{"time [s]"};
        for (const std::string unit : {"m", "m/s"})
          for (unsigned int d = 0; d < dim; ++d)
            columns.push_back((unit == "m" ? "" : "velocity ") +
                              std::string(1, "xyz"[d]) + " [" + unit + "]");
        for (unsigned int d = dim == 3 ? 0 : 2; d < 3; ++d)
          columns.push_back("spin " + std::string(1, "xyz"[d]) + " [rad/s]");
        for (const auto &[name, grains] : all_grains(solution))
          this->open(context, name, columns);
      }

      void
      execute(Context &context, const SolutionView<dim> &solution) override
      {
        for (const auto &[name, view] : all_grains(solution))
          {
            const GrainArrays &grains = view->system.grains();
            // Nothing but zeros where the grain is not.
            std::vector<double> row(1 + 2 * dim + (dim == 3 ? 3 : 1), 0.);
            double              is_there = 0.;
            for (const std::uint32_t i : view->system.own())
              if (grains.id[i] == id)
                {
                  const GrainMomentum &p = grains.momentum[i];
                  const double         values[]{grains.place[i].x.x,
                                                grains.place[i].x.y,
                                                grains.place[i].x.z,
                                                p.v.x,
                                                p.v.y,
                                                p.v.z,
                                                p.w.x,
                                                p.w.y,
                                                p.w.z};
                  std::size_t          column = 1;
                  for (unsigned int k = 0; k < 9; ++k)
                    if (dim == 3 || (k % 3 < 2 ? k < 6 : k == 8))
                      row[column++] = values[k];
                  is_there = 1.;
                }
            dealii::Utilities::MPI::sum(row, context.communicator, row);
            if (dealii::Utilities::MPI::max(is_there, context.communicator) ==
                0.)
              continue;
            row[0] = solution.moment.time;
            this->tables[name].write_row(context, row);
          }
      }

      void
      keep(const State<dim> &state) override
      {
        this->tables.keep(state.values());
      }

    private:
      unsigned int id = 0;
    };



    /// How many grains leave in a second.
    template <int dim>
    class GrainDischarge : public GrainTable<dim>
    {
    public:
      GrainDischarge()
        : GrainTable<dim>("discharge")
      {}

      void
      declare_parameters(const Section &section) override
      {
        schedule.declare_parameters(section, "rows");
      }

      void
      initialize(Context &context, const SolutionView<dim> &solution) override
      {
        for (const auto &[name, grains] : all_grains(solution))
          {
            sums[name];
            this->open(context,
                       name,
                       {"time [s]",
                        "grains left",
                        "mass left [kg]",
                        "mass a second [kg/s]"});
          }
      }

      void
      execute(Context &context, const SolutionView<dim> &solution) override
      {
        const Moment &now = solution.moment;
        for (const auto &[name, view] : all_grains(solution))
          {
            std::vector<double> left(2, 0.);
            for (const GoneGrain &gone : view->gone)
              if (!gone.is_lost)
                {
                  left[0] += 1.;
                  left[1] +=
                    view->system.mass(gone.grain.material, gone.grain.r);
                }
            dealii::Utilities::MPI::sum(left, context.communicator, left);
            if (now.step > 0)
              {
                sums[name].n += left[0];
                sums[name].mass += left[1];
              }
          }
        if (!schedule.is_due(now.time, now.last_step))
          return;
        for (auto &[name, sum] : sums)
          {
            const double interval = now.time - sum.last_time;
            this->tables[name].write_row(
              context,
              {now.time,
               sum.n,
               sum.mass,
               interval > 0. ? (sum.mass - sum.last_mass) / interval : 0.});
            sum.last_time = now.time;
            sum.last_mass = sum.mass;
          }
      }

      void
      keep(const State<dim> &state) override
      {
        schedule.keep(state.values());
        this->tables.keep(state.values(), schedule.was_due_for_the_end());
        for (auto &[name, sum] : sums)
          {
            const Archive archive = state.values().enter(name + ": sums");
            archive.value("n", sum.n);
            archive.value("mass", sum.mass);
            archive.value("last time", sum.last_time);
            archive.value("last mass", sum.last_mass);
          }
      }

    private:
      struct Sum
      {
        double n = 0., mass = 0., last_time = 0., last_mass = 0.;
      };

      Schedule                   schedule{.05};
      std::map<std::string, Sum> sums;
    };



    /// Forces and torques on walls.
    template <int dim>
    class WallForces : public GrainRows<dim>
    {
    public:
      WallForces()
        : GrainRows<dim>("wall forces")
      {}

    private:
      std::vector<std::string>
      columns(const GrainView &view) const override
      {
        std::vector<std::string> names{"time [s]"};
        for (const std::string &wall : view.wall_names)
          {
            for (unsigned int d = 0; d < dim; ++d)
              names.push_back(wall + ": force " + std::string(1, "xyz"[d]) +
                              " [N]");
            for (unsigned int d = first_axis; d < 3; ++d)
              names.push_back(wall + ": torque " + std::string(1, "xyz"[d]) +
                              " [N m]");
          }
        return names;
      }

      std::vector<double>
      row(const MPI_Comm communicator,
          const Mesh<dim> &,
          const GrainView &view) const override
      {
        std::vector<double> numbers;
        for (const WallForce &force : view.walls.forces)
          {
            const double f[]{force.force.x, force.force.y, force.force.z};
            const double t[]{force.torque.x, force.torque.y, force.torque.z};
            numbers.insert(numbers.end(), f, f + dim);
            numbers.insert(numbers.end(), t + first_axis, t + 3);
          }
        dealii::Utilities::MPI::sum(numbers, communicator, numbers);
        return numbers;
      }

      /// In two dimensions torques are about the third one.
      static constexpr unsigned int first_axis = dim == 3 ? 0 : 2;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   OneGrain,
                   "one grain",
                   "place, velocity and spin of one grain after each step; "
                   "writes METHOD_one_grain.csv.")
  THALWEG_REGISTER(Postprocessor,
                   GrainDischarge,
                   "discharge",
                   "how many grains have left, and how much a second; writes "
                   "METHOD_discharge.csv.")
  THALWEG_REGISTER(Postprocessor,
                   WallForces,
                   "wall forces",
                   "what grains do to each wall, forces and torques about its "
                   "center, for runs with an energy budget; writes "
                   "METHOD_wall_forces.csv.")
} // namespace Thalweg
