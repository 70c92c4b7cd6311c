// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_offered_output_h
#define thalweg_postprocess_offered_output_h

#include <thalweg/core/offers.h>
#include <thalweg/postprocess/csv_file.h>
#include <thalweg/postprocess/point_patches.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/postprocess/pvd_record.h>
#include <thalweg/postprocess/schedule.h>

#include <map>
#include <string>

namespace Thalweg
{
  /// Refuses a run in which no method offers a thing.
  /// @param thing see Ports: "grains"
  /// @param model the postprocessor that looks at it
  /// @param example of a method that offers it: "sand: grains"
  /// @throws dealii::ExcMessage
  void
  check_offered(const Offers      &offers,
                const std::string &thing,
                const std::string &model,
                const std::string &example);

  /// The beginning of the names of a method's files; @p thing for one without
  /// a name.
  std::string
  file_name_of(const std::string &method, const std::string &thing);



  /// A table for each method.
  class TablesOfMethods
  {
  public:
    CsvFile &
    operator[](const std::string &method)
    {
      return files[method];
    }

    /// See CsvFile::keep().
    void
    keep(const Archive &archive, const bool without_last = false)
    {
      for (auto &[name, file] : files)
        file.keep(archive.enter(name + ":"), without_last);
    }

  private:
    std::map<std::string, CsvFile> files;
  };



  /**
   * @brief Points of all methods that offer a thing, for ParaView: a series of
   * files for each.
   * @tparam Offer as what it is offered
   */
  template <int dim, typename Offer>
  class PointOutput : public Postprocessor<dim>
  {
  public:
    /// See check_offered(); the model has the name of the thing.
    PointOutput(const std::string &thing, const std::string &example)
      : thing(thing)
      , example(example)
    {}

    void
    declare_parameters(const Section &section) override
    {
      schedule.declare_parameters(section, "files");
    }

    void
    check(const RunOutline<dim> &outline) const override
    {
      check_offered(outline.offered, thing, thing, example);
    }

    void
    initialize(Context &context, const SolutionView<dim> &solution) override
    {
      for (const auto &[name, offer] : offers(solution))
        records[name].open(context, file_name_of(name, thing));
    }

    void
    execute(Context &context, const SolutionView<dim> &solution) override
    {
      const Moment &now = solution.moment;
      if (!schedule.is_due(now.time, now.last_step))
        return;
      for (const auto &[name, offer] : offers(solution))
        {
          PointPatches<dim> patches = points(*offer, now.time);
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

  protected:
    /// Those of this rank. @param time in s
    virtual PointPatches<dim>
    points(const Offer &offer, const double time) const = 0;

  private:
    std::map<std::string, Offer *>
    offers(const SolutionView<dim> &solution) const
    {
      return solution.ports->template all<Offer>(thing);
    }

    const std::string                thing, example;
    Schedule                         schedule{.05};
    std::map<std::string, PvdRecord> records;
  };
} // namespace Thalweg

#endif
