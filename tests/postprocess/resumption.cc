// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/schedule.h>

#include <map>

#include "own_flow.h"

namespace fs = std::filesystem;

namespace
{
  using Thalweg::Archive;
  using Tool   = std::unique_ptr<Thalweg::Postprocessor<2>>;
  using Fields = std::map<std::string, std::vector<double>>;

  const std::string resumed_box = hanging_box<2>(4);


  /// The local values of all fields that are named, ghosts included.
  Fields
  values_of(const Thalweg::State<2> &state)
  {
    Fields fields;
    for (const auto &field : state.fields())
      {
        const auto &v = *field.vector;
        for (unsigned int i = 0; i < v.get_partitioner()->locally_owned_size() +
                                       v.get_partitioner()->n_ghost_indices();
             ++i)
          fields[field.name].push_back(v.local_element(i));
      }
    return fields;
  }


  Fields
  values_of(Thalweg::Postprocessor<2> &tool)
  {
    const Thalweg::State<2> state(Archive::nowhere());
    tool.keep(state);
    return values_of(state);
  }


  /// A run of a tenth of a second a step, whose flow changes with time.
  class Stage
  {
  public:
    explicit Stage(const bool own_flow)
      : state(own_flow ? resumed_box + one_fluid(2., .5) : resumed_box)
      , flow(
          state.mesh,
          1,
          [](const auto &) { return Tensor(); },
          [](const auto &p) { return p[0] - p[1] * p[1]; })
    {
      if (own_flow)
        state.flow = &flow.fields;
    }

    /// Does the steps from @p first to @p last.
    /// @param ends whether no other is to follow
    void
    advance(Thalweg::Postprocessor<2> &tool,
            const unsigned int         first,
            const unsigned int         last,
            const bool                 ends)
    {
      for (unsigned int step = first; step <= last; ++step)
        {
          const double t = .1 * step;
          flow.set_velocity([&](const auto &p) {
            return Tensor({std::sin(5. * t) * p[1], std::cos(9. * t) * p[0]});
          });
          state.set(
            state.velocity, [&](const auto &p) { return t * p[1]; }, 2, 0);
          state.set(state.level_set,
                    [&](const auto &p) { return p[0] - .2 - .3 * t; });
          auto solution      = state.view();
          solution.time      = t;
          solution.time_step = step == 0 ? 0. : .1;
          solution.step      = step;
          solution.last_step = ends && step == last;
          tool.execute(state.context, whole(solution));
        }
    }

    /// The tables and records that were written, without the date that
    /// deal.II writes.
    std::map<std::string, std::string>
    files() const
    {
      MPI_Barrier(MPI_COMM_WORLD);
      std::map<std::string, std::string> list;
      const fs::path                     top = state.context.output_directory;
      for (const auto &entry : fs::recursive_directory_iterator(top))
        if (entry.path().extension() == ".csv" ||
            entry.path().extension() == ".pvd")
          {
            std::string &text = list[entry.path().lexically_relative(top)];
            text              = content(entry.path());
            if (const auto date = text.find("#This file was");
                date != std::string::npos)
              text.erase(date, text.find('\n', date) - date);
          }
      MPI_Barrier(MPI_COMM_WORLD);
      return list;
    }

    using Tensor = dealii::Tensor<1, 2>;
    State<2>   state;
    OwnFlow<2> flow;
  };


  /// Runs a postprocessor for twelve steps, straight and with a stop after
  /// the seventh, and compares all files and fields.
  /// @param ends_at_stop whether the first run ended there; else it was
  ///   killed some steps later
  void
  compare(const std::string              &model,
          const std::vector<std::string> &settings,
          const bool                      own_flow,
          const bool                      ends_at_stop)
  {
    SCOPED_TRACE(model + (ends_at_stop ? ", ended" : ", killed"));
    Stage      straight(own_flow);
    const Tool whole = straight.state.prepare(model, settings);
    straight.advance(*whole, 0, 12, true);

    Stage         stage(own_flow);
    const Archive archive;
    Fields        kept;
    {
      const Tool first = stage.state.prepare(model, settings);
      stage.advance(*first, 0, 7, ends_at_stop);
      const Thalweg::State<2> state(archive);
      first->keep(state);
      kept = values_of(state);
      if (!ends_at_stop)
        stage.advance(*first, 8, 10, false);
    }
    stage.state.context.resumed    = true;
    const Tool              second = stage.state.prepare(model, settings);
    const Thalweg::State<2> state(Archive::restore(archive.bytes()));
    second->keep(state);
    for (const auto &field : state.fields())
      {
        for (unsigned int i = 0; i < kept.at(field.name).size(); ++i)
          field.vector->local_element(i) = kept.at(field.name)[i];
        field.space->interpolate(*field.vector, field.n_components);
      }
    stage.advance(*second, 8, 12, true);

    EXPECT_FALSE(straight.files().empty());
    EXPECT_EQ(straight.files(), stage.files());
    EXPECT_EQ(values_of(*whole), values_of(*second));
  }


  void
  compare(const std::string              &model,
          const std::vector<std::string> &settings,
          const bool                      own_flow)
  {
    for (const bool ends_at_stop : {false, true})
      compare(model, settings, own_flow, ends_at_stop);
  }
} // namespace


TEST(ResumptionMpi, TablesHaveNoGapAndNoDoubleRow)
{
  compare("front position", {"Interval = 0.25"}, false);
  compare("phase volume", {}, false);
  compare("interface error", {"Level set = x - 0.2 - 0.3 * t"}, false);
  compare("line profile", {"Ends = 0.5, 0; 0.5, 1", "Interval = 0.25"}, false);
}


TEST(ResumptionMpi, SeriesForParaViewContinue)
{
  compare("fields", {"Interval = 0.25"}, false);
  compare("particles", {"Interval = 1"}, false);
}


TEST(ResumptionMpi, RecordsOfForcesAreWhole)
{
  compare("body forces",
          {"Boundaries = left, bottom",
           "Average from = 0.35",
           "Interval = 0.25"},
          true);
}


TEST(ResumptionMpi, MeansOverTimeAreTheSameBitByBit)
{
  compare("time averages", {"Average from = 0.25", "Interval = 0.45"}, true);
  compare("time averages", {"Average from = 0.85"}, true);
  compare("time averages", {}, false);
  compare("surface coefficients",
          {"Boundaries = left, bottom", "Average from = 0.25"},
          true);
}


TEST(ResumptionMpi, MissingFilesAreToldAndBegunAnew)
{
  State<2>          state(resumed_box);
  const std::string said = own_path("said.txt");
  state.context.log.open(said);
  const Archive archive;
  {
    const auto series = state.run("fields");
    series->keep(Thalweg::State<2>(archive.enter("fields")));
    const auto table = state.run("front position");
    table->keep(Thalweg::State<2>(archive.enter("front")));
  }
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(content(said), "");
  MPI_Barrier(MPI_COMM_WORLD);
  if (state.context.is_root)
    {
      fs::remove(state.context.output_directory + "/front_position.csv");
      fs::remove_all(state.context.output_directory + "/fields");
    }
  MPI_Barrier(MPI_COMM_WORLD);

  state.context.resumed  = true;
  const Archive restored = Archive::restore(archive.bytes());
  for (const auto &[model, name] :
       std::map<std::string, std::string>{{"fields", "fields"},
                                          {"front position", "front"}})
    {
      const auto tool = state.prepare(model);
      tool->keep(Thalweg::State<2>(restored.enter(name)));
      auto solution      = state.view();
      solution.time      = 4.;
      solution.last_step = true;
      tool->execute(state.context, whole(solution));
    }
  EXPECT_EQ(state.read_all("front_position.csv").size(), 1u);
  const std::string record =
    content(state.context.output_directory + "/fields.pvd");
  EXPECT_EQ(record.find("fields_0000"), std::string::npos) << record;
  // Numbers continue.
  EXPECT_NE(record.find("fields_0001"), std::string::npos) << record;
  if (state.context.is_root)
    {
      EXPECT_NE(content(said).find("front_position.csv' that the run had "
                                   "written is missing"),
                std::string::npos)
        << content(said);
      EXPECT_NE(content(said).find("1 are gone"), std::string::npos);
      fs::remove(said);
    }
}


TEST(Resumption, WhatWasDueForTheEndIsDropped)
{
  Thalweg::Schedule schedule(.5);
  EXPECT_TRUE(schedule.is_due(0., false));
  EXPECT_FALSE(schedule.was_due_for_the_end());
  EXPECT_FALSE(schedule.is_due(.3, false));
  EXPECT_TRUE(schedule.is_due(.4, true));
  EXPECT_TRUE(schedule.was_due_for_the_end());
  const Archive archive;
  schedule.keep(archive);
  Thalweg::Schedule other(.5);
  other.keep(Archive::restore(archive.bytes()));
  EXPECT_FALSE(other.is_due(.4, false));
  EXPECT_TRUE(other.is_due(.5, true));
  EXPECT_FALSE(other.was_due_for_the_end());
}
