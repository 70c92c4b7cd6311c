// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_simulation_swings_h
#define tests_simulation_swings_h

#include <thalweg/core/errors.h>
#include <thalweg/coupling/coupling.h>
#include <thalweg/fields/node_space.h>
#include <thalweg/fields/owned_values.h>
#include <thalweg/methods/method.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

/// A physics that only tests know: x' = y and y' = -x, each the field of a
/// method, with a coupling between them.
namespace Swings
{
  using namespace Thalweg;

  /// What acts on a swing: a field that is linear in time.
  struct Push
  {
    const Vector *before = nullptr, *now = nullptr;
    double        time_before = 0., time_now = 0.;

    void
    add(const double time, const double factor, Vector &value) const
    {
      const double part = time_now > time_before
                            ? (time - time_before) / (time_now - time_before)
                            : 1.;
      value.add(factor * part, *now, factor * (1. - part), *before);
    }
  };

  /// Who did something, in its order, with the length of the step.
  inline std::vector<std::pair<std::string, double>> calls;

  /// The call in which a method fails; 0: none.
  inline unsigned int failing_call = 0;



  /// A field that grows with what acts on it.
  class Swing : public Method<2>
  {
  public:
    void
    declare_parameters(const Section &section) override
    {
      section.add("Start", start, "", "Its value at the start.");
    }

    void
    declare_sections(const Section &) override
    {}

    void
    publish(const std::string &name, RunOutline<2> &outline) const override
    {
      outline.offered.add(name, "value");
      outline.offered.add(name, "push");
    }

    using Method<2>::publish;

    void
    create(const Host<2> &host_) override
    {
      host = std::make_unique<Host<2>>(host_);
    }

    void
    release() override
    {
      space.reset();
    }

    void
    attach() override
    {
      space = std::make_unique<NodeSpace<2>>(host->mesh);
      space->initialize_scalar(value);
      push = {};
    }

    void
    offer(Ports &ports) const override
    {
      ports.offer<const Vector>(host->name, "value", value);
      ports.offer<const NodeSpace<2>>(host->name, "space", *space);
      ports.offer<Push>(host->name, "push", push);
    }

    void
    initialize() override
    {
      attach();
      value.zero_out_ghost_values();
      value = start;
      space->interpolate(value, 1);
    }

    void
    keep(const State<2> &state) override
    {
      state.field("value", *space, value, 1);
    }

    StepNumbers
    step_numbers() const override
    {
      StepNumber number;
      number.name = "swing number";
      number.rate = 1.;
      return {number};
    }

    void
    advance(const double time, const double dt) override
    {
      calls.emplace_back(host->name, dt);
      value.zero_out_ghost_values();
      push.add(time + .5 * dt, dt, value);
      space->interpolate(value, 1);
      host->context.statistics.add("advances", 1);
      if (calls.size() == failing_call)
        throw StepFailure("It got stuck.");
    }

    void
    record(const double) override
    {
      // The same at all nodes.
      host->context.statistics.set("value", value.mean_value());
      EXPECT_LT(value.linfty_norm() - std::abs(value.mean_value()), 1e-14);
    }

    std::string
    size() const override
    {
      return "a swing";
    }

    std::string
    headline() const override
    {
      return "";
    }

  private:
    double                        start = 0.;
    std::unique_ptr<Host<2>>      host;
    std::unique_ptr<NodeSpace<2>> space;
    Vector                        value;
    mutable Push                  push;
  };



  /// Lets the second of two swings push the first, and the first the second,
  /// backwards.
  class Rope : public Coupling<2>
  {
  public:
    void
    declare_parameters(const Section &section) override
    {
      section.add("Strength", strength, "", "1: x' = y.");
    }

    std::vector<std::vector<std::string>>
    needs() const override
    {
      return {{"value", "push"}, {"value", "push"}};
    }

    void
    check(std::vector<std::string> &faults) const override
    {
      if (strength < 0.)
        faults.emplace_back("ropes pull");
    }

    void
    create(const Host<2>                  &host_,
           const std::vector<std::string> &methods_) override
    {
      host    = std::make_unique<Host<2>>(host_);
      methods = methods_;
    }

    void
    release() override
    {
      now = before = {};
    }

    void
    attach() override
    {
      for (unsigned int i = 0; i < 2; ++i)
        {
          space(i).initialize_scalar(now[i]);
          space(i).initialize_scalar(before[i]);
        }
    }

    void
    initialize() override
    {
      time_before = time_now = 0.;
      take();
      update();
    }

    void
    keep(const State<2> &state) override
    {
      state.values().value("time before", time_before);
      state.values().value("time now", time_now);
      for (unsigned int i = 0; i < 2; ++i)
        {
          state.field("now " + methods[i], space(i), now[i], 1);
          state.field("before " + methods[i], space(i), before[i], 1);
        }
    }

    void
    update() override
    {
      for (unsigned int i = 0; i < 2; ++i)
        host->ports.get<Push>(methods[i], "push", "A rope") = {&before[i],
                                                               &now[i],
                                                               time_before,
                                                               time_now};
    }

    void
    transfer(const double time, const double dt) override
    {
      calls.emplace_back(host->name, dt);
      if (time_now <= time)
        for (unsigned int i = 0; i < 2; ++i)
          {
            copy_owned(before[i], now[i]);
            time_before = time_now;
          }
      time_now             = time + dt;
      const auto predicted = now;
      take();
      difference = 0.;
      for (unsigned int i = 0; i < 2; ++i)
        {
          Vector change = predicted[i];
          change.zero_out_ghost_values();
          change.add(-1., now[i]);
          difference = std::max(difference, change.linfty_norm());
        }
      update();
    }

    double
    change() const override
    {
      return difference;
    }

    std::vector<std::string>
    columns() const override
    {
      return {"difference"};
    }

    void
    record(const double) override
    {
      host->context.statistics.set("difference", difference);
    }

  private:
    const NodeSpace<2> &
    space(const unsigned int i) const
    {
      return host->ports.get<const NodeSpace<2>>(methods[i], "space", "A rope");
    }

    void
    take()
    {
      for (unsigned int i = 0; i < 2; ++i)
        {
          copy_owned(now[i],
                     host->ports.get<const Vector>(methods[1 - i],
                                                   "value",
                                                   "A rope"));
          now[i] *= i == 0 ? strength : -strength;
          space(i).interpolate(now[i], 1);
        }
    }

    double                   strength = 1.;
    std::unique_ptr<Host<2>> host;
    std::vector<std::string> methods;
    std::array<Vector, 2>    now, before;
    double                   time_now = 0., time_before = 0.;
    double                   difference = 0.;
  };
} // namespace Swings

#endif
