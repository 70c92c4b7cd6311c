// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_scheduled_output_h
#define thalweg_postprocess_scheduled_output_h

#include <thalweg/postprocess/csv_file.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/postprocess/pvd_record.h>
#include <thalweg/postprocess/schedule.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /// A postprocessor that writes at times which the parameter "Interval"
  /// sets.
  template <int dim>
  class ScheduledOutput : public FlowPostprocessor<dim>
  {
  public:
    /// @param what is written: "rows"
    /// @param interval the default in s; 0: after every step
    ScheduledOutput(const std::string &what, const double interval)
      : what(what)
      , schedule(interval)
    {}

    void
    declare_for_flow(const Section &section) final;

    /// Writes if it is time to.
    void
    execute_for_flow(Context &context, const FlowView<dim> &solution) final;

    void
    keep(const State<dim> &state) final;

  protected:
    /// Declares all but "Interval".
    virtual void
    declare_own_parameters(const Section &)
    {}

    /// Writes the present state. Collective.
    virtual void
    write(Context &context, const FlowView<dim> &solution) = 0;

    /// Keeps the files that write() writes.
    /// @param without_last whether what it wrote last is to be dropped when
    ///   the run goes on
    virtual void
    keep_files(const Archive &archive, const bool without_last) = 0;

  private:
    std::string what;
    Schedule    schedule;
  };



  /// A postprocessor that writes a CSV table with the time in its first
  /// column.
  template <int dim>
  class TableOutput : public ScheduledOutput<dim>
  {
  public:
    /// @param file_name in the output directory
    /// @param interval the default in s; 0: after every step
    explicit TableOutput(const std::string &file_name,
                         const double       interval = 0.)
      : ScheduledOutput<dim>("rows", interval)
      , file_name(file_name)
    {}

    void
    initialize_for_flow(Context &context, const FlowView<dim> &solution) final;

  protected:
    /// The names of the columns behind the time, with their units.
    virtual std::vector<std::string>
    columns(const FlowView<dim> &solution) = 0;

    /// As many values, the same on all processes. Collective.
    virtual std::vector<double>
    row(const FlowView<dim> &solution) = 0;

  private:
    void
    write(Context &context, const FlowView<dim> &solution) final;

    void
    keep_files(const Archive &archive, const bool without_last) final;

    std::string file_name;
    CsvFile     file;
  };



  /// A postprocessor that writes a series of files for ParaView.
  template <int dim>
  class SeriesOutput : public ScheduledOutput<dim>
  {
  public:
    /// @param name of the files, without ending
    explicit SeriesOutput(const std::string &name)
      : ScheduledOutput<dim>("files", .05)
      , name(name)
    {}

    void
    initialize_for_flow(Context &context, const FlowView<dim> &solution) final;

  protected:
    void
    keep_files(const Archive &archive, const bool without_last) final;

    std::string name;
    PvdRecord   record;
  };
} // namespace Thalweg

#endif
