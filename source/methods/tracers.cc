// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/fields/expression.h>
#include <thalweg/methods/method.h>
#include <thalweg/methods/tracer_view.h>
#include <thalweg/particles/lattice.h>
#include <thalweg/particles/streamlines.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Thalweg
{
  namespace
  {
    /**
     * @brief Points that are released in a flow, follow it and change
     * nothing: where fluid comes from, where it goes, and how long that takes.
     */
    template <int dim>
    class Tracers : public Method<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override;

      void
      declare_sections(const Section &) override
      {}

      void
      check(std::vector<std::string> &faults) const override;

      void
      publish(const std::string &name, RunOutline<dim> &outline) const override
      {
        outline.offered.add(name, "tracers");
      }

      std::vector<Need>
      needs() const override
      {
        return {{flow, "streamlines"}};
      }

      void
      create(const Host<dim> &host_) override
      {
        host    = std::make_unique<Host<dim>>(host_);
        tracers = std::make_unique<TracerView<dim>>(
          TracerView<dim>{TracerCloud<dim>(host->mesh), {}});
      }

      void
      release() override
      {
        tracers.reset();
      }

      void
      attach() override
      {
        // At the start only those before this one have offered something.
        velocity();
      }

      void
      offer(Ports &ports) const override
      {
        ports.offer<const TracerView<dim>>(host->name, "tracers", *tracers);
      }

      void
      initialize() override;

      using Method<dim>::publish;

      void
      clear() override
      {
        tracers->cloud.clear();
      }

      void
      keep(const State<dim> &state) override;

      void
      advance(const double time, const double dt) override;

      std::vector<std::string>
      columns() const override;

      void
      record(const double time) override;

      std::string
      size() const override
      {
        return std::to_string(tracers->cloud.n_global()) + " tracers";
      }

      std::string
      headline() const override
      {
        return "tracers = " + std::to_string(tracers->cloud.n_global());
      }

    private:
      /// What the tracers follow. @throws dealii::ExcMessage without it
      const Streamlines<dim> &
      velocity() const
      {
        return host->ports.template get<const Streamlines<dim>>(
          flow, "streamlines", who() + ", in 'Methods/Names' behind a flow,");
      }

      /// When the release number @p n is, s; infinity: never.
      double
      time_of_release(const unsigned int n) const;

      /// Releases all that is due until @p end, s; each tracer is to go on
      /// until then.
      void
      release_until(const double end);

      /// "'Methods/dye'"
      std::string
      who() const
      {
        return host->name.empty() ? "'Method/Model = tracers'"
                                  : "'Methods/" + host->name + "'";
      }

      std::string flow;
      std::string region        = "1";
      double      spacing       = 0.;
      double      first_release = 0.;
      double      last_release  = 0.;
      double      interval      = 0.;

      std::unique_ptr<Host<dim>>       host;
      std::unique_ptr<TracerView<dim>> tracers;
      double                           chosen_spacing = 0.; ///< m
      unsigned int                     n_releases     = 0;
      /// Since the start, on all ranks.
      std::uint64_t n_released = 0, n_left = 0, n_lost = 0;
      double        time_of_left = 0.; ///< the sum of their times, s
    };



    template <int dim>
    void
    Tracers<dim>::declare_parameters(const Section &section)
    {
      using dealii::Patterns::Double;
      section.add("Flow",
                  flow,
                  "",
                  "The name of the method whose velocity the tracers follow, "
                  "which stands before this one in `Methods/Names`; empty: the "
                  "first that has one.",
                  dealii::Patterns::Anything());
      section.add("Region",
                  region,
                  "",
                  "Tracers are released where this function of x, y, z and t "
                  "is positive.",
                  dealii::Patterns::Anything());
      section.add("Spacing",
                  spacing,
                  "m",
                  "How far they are released from each other, on a lattice; 0: "
                  "as far as the shortest edge of a cell at the start.",
                  Double(0));
      section.add(
        "First release", first_release, "s", "When they are.", Double(0));
      section.add("Interval",
                  interval,
                  "s",
                  "After what time more are released, exactly then, also in "
                  "the midst of a step; 0: never.",
                  Double(0));
      section.add("Last release",
                  last_release,
                  "s",
                  "Where there is an interval: no more are released after this "
                  "time; 0: they are to the end.",
                  Double(0));
    }



    template <int dim>
    void
    Tracers<dim>::check(std::vector<std::string> &faults) const
    {
      collect_fault(faults,
                    [this]() { parse_expression<dim>(region, 1, "Region"); });
      collect_fault(faults, [this]() {
        AssertThrow(last_release == 0. ||
                      (interval > 0. && last_release >= first_release),
                    dealii::ExcMessage(
                      "'Last release' is for releases at intervals, and not "
                      "before the first one: give an 'Interval', or leave it "
                      "out."));
      });
    }



    template <int dim>
    double
    Tracers<dim>::time_of_release(const unsigned int n) const
    {
      const double never = std::numeric_limits<double>::infinity();
      const double time  = first_release + n * interval;
      const double last  = last_release > 0. ? last_release : never;
      return n > 0 && (interval == 0. || time > last) ? never : time;
    }



    template <int dim>
    void
    Tracers<dim>::release_until(const double end)
    {
      const double almost = end + 1e-12 * std::abs(end);
      if (time_of_release(n_releases) > almost)
        return;
      const Lattice<dim> lattice(host->mesh, chosen_spacing);
      const auto         function = parse_expression<dim>(region, 1, "Region");
      std::uint64_t      n_new    = 0;
      for (; time_of_release(n_releases) <= almost; ++n_releases)
        {
          const double time = time_of_release(n_releases);
          function->set_time(time);
          lattice.for_each_point([&](const unsigned int        cell,
                                     const dealii::Point<dim> &reference,
                                     const dealii::Point<dim> &place,
                                     const std::uint64_t       number) {
            if (!(function->value(place) > 0.))
              return;
            Tracer<dim> tracer{n_releases * lattice.n_points() + number,
                               time,
                               {}};
            for (unsigned int d = 0; d < dim; ++d)
              tracer.origin[d] = place[d];
            tracers->cloud.add(cell,
                               reference,
                               std::max(0., end - time),
                               tracer);
            ++n_new;
          });
        }
      n_released +=
        dealii::Utilities::MPI::sum(n_new, host->context.communicator);
    }



    template <int dim>
    void
    Tracers<dim>::initialize()
    {
      attach();
      chosen_spacing =
        spacing > 0.
          ? spacing
          : dealii::Utilities::MPI::min(host->mesh.graph().minimal_extent(),
                                        host->context.communicator);
      clear();
      n_releases = 0;
      n_released = n_left = n_lost = 0;
      time_of_left                 = 0.;
      release_until(0.);
      tracers->cloud.settle();
    }



    template <int dim>
    void
    Tracers<dim>::keep(const State<dim> &state)
    {
      const Archive &values = state.values();
      values.value("spacing", chosen_spacing);
      values.value("releases", n_releases);
      values.value("released", n_released);
      values.value("left", n_left);
      values.value("lost", n_lost);
      values.value("time of left", time_of_left);
      state.carry("tracers", tracers->cloud);
    }



    template <int dim>
    void
    Tracers<dim>::advance(const double time, const double dt)
    {
      dealii::TimerOutput::Scope scope(host->context.timers, "tracers");
      const MPI_Comm             communicator = host->context.communicator;
      release_until(time + dt);
      auto report =
        tracers->cloud.move(velocity().streamlines(), dt, time + dt);
      double time_inside = 0.;
      for (const auto &exit : report.exits)
        time_inside += exit.time - exit.tracer.released;
      n_left += dealii::Utilities::MPI::sum(std::uint64_t(report.exits.size()),
                                            communicator);
      n_lost += dealii::Utilities::MPI::sum(report.n_lost, communicator);
      time_of_left += dealii::Utilities::MPI::sum(time_inside, communicator);
      tracers->exits = std::move(report.exits);
    }



    template <int dim>
    std::vector<std::string>
    Tracers<dim>::columns() const
    {
      return {"tracers",
              "tracers released",
              "tracers left",
              "tracers lost",
              "mean age [s]",
              "mean residence time [s]"};
    }



    template <int dim>
    void
    Tracers<dim>::record(const double time)
    {
      auto  &statistics = host->context.statistics;
      double age        = 0.;
      for (const auto &[walker, tracer] : tracers->cloud.members())
        age += time - tracer.released;
      age = dealii::Utilities::MPI::sum(age, host->context.communicator);
      const double n = tracers->cloud.n_global();
      statistics.set("tracers", n);
      statistics.set("tracers released", n_released);
      statistics.set("tracers left", n_left);
      statistics.set("tracers lost", n_lost);
      statistics.set("mean age [s]", n > 0. ? age / n : 0.);
      statistics.set("mean residence time [s]",
                     n_left > 0 ? time_of_left / n_left : 0.);
    }
  } // namespace

  THALWEG_REGISTER(Method,
                   Tracers,
                   "tracers",
                   "points that follow the velocity of another method and "
                   "change nothing; one of several in `Methods/Names`")
} // namespace Thalweg
