// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_grain_table_h
#define thalweg_postprocess_grain_table_h

#include <thalweg/methods/grain_view.h>
#include <thalweg/postprocess/offered_output.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace Thalweg
{
  /// The grains of all methods that have some, by the methods' names.
  template <int dim>
  std::map<std::string, const GrainView *>
  all_grains(const SolutionView<dim> &solution)
  {
    return solution.ports->template all<const GrainView>("grains");
  }



  /// A table of grains for each method that has some.
  template <int dim>
  class GrainTable : public Postprocessor<dim>
  {
  public:
    /// @param model its name
    explicit GrainTable(const std::string &model)
      : model(model)
    {}

    void
    check(const RunOutline<dim> &outline) const override
    {
      check_offered(outline.offered, "grains", model, "sand: grains");
    }

  protected:
    /// Begins the table of a method.
    void
    open(Context                        &context,
         const std::string              &method,
         const std::vector<std::string> &columns)
    {
      std::string name = file_name_of(method, "grains") + "_" + model;
      std::replace(name.begin(), name.end(), ' ', '_');
      tables[method].open(context, name + ".csv", columns);
    }

    TablesOfMethods tables;

  private:
    const std::string model;
  };



  /// A row for each method at intervals, of what there is at that moment.
  template <int dim>
  class GrainRows : public GrainTable<dim>
  {
  public:
    using GrainTable<dim>::GrainTable;

    void
    declare_parameters(const Section &section) override
    {
      schedule.declare_parameters(section, "rows");
    }

    void
    initialize(Context &context, const SolutionView<dim> &solution) override
    {
      for (const auto &[name, view] : all_grains(solution))
        this->open(context, name, columns(*view));
    }

    void
    execute(Context &context, const SolutionView<dim> &solution) override
    {
      const Moment &now = solution.moment;
      if (!schedule.is_due(now.time, now.last_step))
        return;
      for (const auto &[name, view] : all_grains(solution))
        {
          std::vector<double> numbers =
            row(context.communicator, solution.mesh, *view);
          numbers.insert(numbers.begin(), now.time);
          this->tables[name].write_row(context, numbers);
        }
    }

    void
    keep(const State<dim> &state) override
    {
      schedule.keep(state.values());
      this->tables.keep(state.values(), schedule.was_due_for_the_end());
    }

  private:
    /// That of the time first.
    virtual std::vector<std::string>
    columns(const GrainView &view) const = 0;

    /// What stands behind the time. Collective.
    virtual std::vector<double>
    row(const MPI_Comm   communicator,
        const Mesh<dim> &mesh,
        const GrainView &view) const = 0;

    Schedule schedule{.05};
  };
} // namespace Thalweg

#endif
