// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/grain_access.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/postprocess/pvd_record.h>
#include <thalweg/postprocess/schedule.h>

#include <deal.II/base/data_out_base.h>

namespace Thalweg
{
  namespace
  {
    /// Grains as points with numbers.
    template <int dim>
    class GrainPatches : public dealii::DataOutInterface<0, dim>
    {
    public:
      using Patch = dealii::DataOutBase::Patch<0, dim>;

      static constexpr unsigned int n_spins  = dim == 3 ? 3 : 1;
      static constexpr unsigned int n_values = 3 + dim + n_spins;

      explicit GrainPatches(const GrainSystem &system)
      {
        const GrainArrays &grains = system.grains();
        for (const std::uint32_t i : system.own())
          {
            const GrainMomentum &p = grains.momentum[i];
            const double         x[]{grains.place[i].x.x,
                                     grains.place[i].x.y,
                                     grains.place[i].x.z};
            const double         v[]{p.v.x, p.v.y, p.v.z};
            const double         w[]{p.w.x, p.w.y, p.w.z};
            Patch                patch;
            patch.patch_index = patches.size();
            patch.data.reinit(n_values, 1);
            patch.data(0, 0) = grains.place[i].r;
            patch.data(1, 0) = grains.id[i];
            patch.data(2, 0) = grains.material[i];
            for (unsigned int d = 0; d < dim; ++d)
              {
                patch.vertices[0][d] = x[d];
                patch.data(3 + d, 0) = v[d];
              }
            for (unsigned int d = 0; d < n_spins; ++d)
              patch.data(3 + dim + d, 0) = w[3 - n_spins + d];
            patches.push_back(patch);
          }
      }

    private:
      const std::vector<Patch> &
      get_patches() const override
      {
        return patches;
      }

      std::vector<std::string>
      get_dataset_names() const override
      {
        std::vector<std::string> names{"radius", "id", "material"};
        for (unsigned int d = 0; d < dim; ++d)
          names.push_back("velocity");
        for (unsigned int d = 0; d < n_spins; ++d)
          names.push_back("spin");
        return names;
      }

      std::vector<std::tuple<
        unsigned int,
        unsigned int,
        std::string,
        dealii::DataComponentInterpretation::DataComponentInterpretation>>
      get_nonscalar_data_ranges() const override
      {
        const auto vector =
          dealii::DataComponentInterpretation::component_is_part_of_vector;
        std::vector<std::tuple<
          unsigned int,
          unsigned int,
          std::string,
          dealii::DataComponentInterpretation::DataComponentInterpretation>>
          ranges{{3, 2 + dim, "velocity", vector}};
        if (dim == 3)
          ranges.emplace_back(3 + dim, 2 + 2 * dim, "spin", vector);
        return ranges;
      }

      std::vector<Patch> patches;
    };



    /// Grains for ParaView.
    template <int dim>
    class GrainOutput : public Postprocessor<dim>
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
        check_grains(outline, "grains");
      }

      void
      initialize(Context &context, const SolutionView<dim> &solution) override
      {
        for (const auto &[name, grains] : all_grains(solution))
          records[name].open(context, grain_file_name(name));
      }

      void
      execute(Context &context, const SolutionView<dim> &solution) override
      {
        const Moment &now = solution.moment;
        if (!schedule.is_due(now.time, now.last_step))
          return;
        for (const auto &[name, grains] : all_grains(solution))
          {
            GrainPatches<dim> patches(grains->system);
            records.at(name).write(context, patches, now.time, now.step);
          }
      }

      void
      keep(const State<dim> &state) override
      {
        schedule.keep(state.values());
        for (auto &[name, record] : records)
          record.keep(state.values().enter(name + ":"),
                      schedule.was_due_for_the_end());
      }

    private:
      Schedule                         schedule{.05};
      std::map<std::string, PvdRecord> records;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   GrainOutput,
                   "grains",
                   "grains with radius, velocity, spin, number and material, "
                   "for ParaView; writes METHOD.pvd.")
} // namespace Thalweg
