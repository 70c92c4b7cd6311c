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
   * @brief What all methods offer under a name, for ParaView: a series of
   * files for each.
   * @tparam Offer as what it is offered
   */
  template <int dim, typename Offer>
  class OfferedSeries : public Postprocessor<dim>
  {
  public:
    /// See check_offered().
    /// @param model is also the end of the files' names; nothing: that of the
    ///   thing, and their names are those of the methods
    OfferedSeries(const std::string &thing,
                  const std::string &example,
                  const std::string &model = "")
      : thing(thing)
      , example(example)
      , model(model)
    {}

    void
    declare_parameters(const Section &section) override
    {
      schedule.declare_parameters(section, "files");
    }

    void
    check(const RunOutline<dim> &outline) const override
    {
      check_offered(outline.offered,
                    thing,
                    model.empty() ? thing : model,
                    example);
    }

    void
    initialize(Context &context, const SolutionView<dim> &solution) override
    {
      for (const auto &[name, offer] : offers(solution))
        records[name].open(context, files_of(name));
    }

    void
    execute(Context &context, const SolutionView<dim> &solution) override
    {
      const Moment &now = solution.moment;
      if (schedule.is_due(now.time, now.last_step))
        for (const auto &[name, offer] : offers(solution))
          write(context, files_of(name), *offer, now, records.at(name));
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
    /// Writes what one method offers. Collective. @param name of its files
    virtual void
    write(Context           &context,
          const std::string &name,
          const Offer       &offer,
          const Moment      &now,
          PvdRecord         &record) const = 0;

  private:
    std::map<std::string, Offer *>
    offers(const SolutionView<dim> &solution) const
    {
      return solution.ports->template all<Offer>(thing);
    }

    std::string
    files_of(const std::string &method) const
    {
      return file_name_of(method, thing) + (model.empty() ? "" : "_" + model);
    }

    const std::string                thing, example, model;
    Schedule                         schedule{.05};
    std::map<std::string, PvdRecord> records;
  };



  /// The same of points.
  template <int dim, typename Offer>
  class PointOutput : public OfferedSeries<dim, Offer>
  {
  public:
    using OfferedSeries<dim, Offer>::OfferedSeries;

  protected:
    /// Those of this rank. @param time in s
    virtual PointPatches<dim>
    points(const Offer &offer, const double time) const = 0;

  private:
    void
    write(Context &context,
          const std::string &,
          const Offer  &offer,
          const Moment &now,
          PvdRecord    &record) const override
    {
      PointPatches<dim> patches = points(offer, now.time);
      record.write(context, patches, now.time, now.step);
    }
  };
} // namespace Thalweg

#endif
