// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>

#include <gtest/gtest.h>
#include <vector>

#include "support/input.h"
#include "support/run_case.h"

using namespace Thalweg;

namespace
{
  /// What a step starts from.
  struct Start
  {
    double              time;
    double              dt;
    std::vector<double> state;
  };


  /// PFEM-2 whose third step fails twice, when it is all but over.
  class Stumbling : public Method<2>
  {
  public:
    static constexpr unsigned int first_failure = 2;
    static constexpr unsigned int n_failures    = 2;

    explicit Stumbling(std::vector<Start> &starts)
      : inner(Registry<Method<2>>::entries().at("pfem2").make())
      , starts(starts)
    {}

    void
    declare_parameters(const Section &section) override
    {
      inner->declare_parameters(section);
    }

    void
    attach(const Parts<2> &parts_) override
    {
      parts = std::make_unique<Parts<2>>(parts_);
      inner->attach(parts_);
    }

    void
    initialize(const dealii::Function<2> &velocity,
               const Vector              &initial_velocity,
               const Vector              &initial_level_set) override
    {
      inner->initialize(velocity, initial_velocity, initial_level_set);
    }

    void
    keep(const State<2> &state) override
    {
      inner->keep(state);
    }

    void
    update() override
    {
      inner->update();
    }

    void
    repopulate() override
    {
      inner->repopulate();
    }

    void
    advance(const double time, const double dt) override
    {
      starts.push_back({time, dt, state()});
      inner->advance(time, dt);
      const unsigned int n = starts.size() - 1;
      if (n >= first_failure && n < first_failure + n_failures)
        throw StepFailure("It stumbled.");
    }

    StepNumbers
    step_numbers() const override
    {
      return inner->step_numbers();
    }

    std::string
    headline() const override
    {
      return inner->headline();
    }

  private:
    /// All numbers of the flow and of the particles on this process.
    std::vector<double>
    state() const
    {
      std::vector<double> numbers;
      for (const Vector *field :
           {&parts->flow.velocity(), &parts->flow.pressure()})
        numbers.insert(numbers.end(), field->begin(), field->end());
      const Vector &level_set = parts->phase.level_set();
      numbers.insert(numbers.end(), level_set.begin(), level_set.end());
      for (const auto &particle : parts->population.handler())
        {
          numbers.push_back(particle.get_id());
          for (unsigned int d = 0; d < 2; ++d)
            numbers.push_back(particle.get_location()[d]);
          const auto properties = particle.get_properties();
          numbers.insert(numbers.end(), properties.begin(), properties.end());
        }
      return numbers;
    }

    std::unique_ptr<Method<2>> inner;
    std::unique_ptr<Parts<2>>  parts;
    std::vector<Start>        &starts;
  };
} // namespace



TEST(RepeatedStepMpi, StartsFromTheSameStateWithHalfTheSize)
{
  std::vector<Start> starts;
  auto              &models = Registry<Method<2>>::entries();
  models["stumbling"]       = {"",
                               [&]() { return std::make_unique<Stumbling>(starts); }};
  const RunCase<2> run(
    box_of("8, 8", "if(y < 0.3, 1, 0)") +
    section("Method", {"Model = stumbling"}) +
    section("Time", {"Time step = 0.01", "End time = 0.05"}) +
    section("Body forces", {"Gravity = 0, -9.81"}) +
    section("Initial conditions", {"Level set = max(x - 0.31, y - 0.62)"}) +
    section("Boundary conditions", {"Open = top: 0"}));
  models.erase("stumbling");

  const unsigned int i = Stumbling::first_failure;
  ASSERT_GT(starts.size(), i + Stumbling::n_failures + 1);
  for (unsigned int k = 1; k <= Stumbling::n_failures; ++k)
    {
      EXPECT_EQ(starts[i + k].time, starts[i].time);
      EXPECT_EQ(starts[i + k].dt, .5 * starts[i + k - 1].dt);
      EXPECT_EQ(starts[i + k].state, starts[i].state);
    }
  // The run goes on from what the third attempt found, to the end.
  const Start &next = starts[i + Stumbling::n_failures + 1];
  EXPECT_DOUBLE_EQ(next.time,
                   starts[i].time + starts[i + Stumbling::n_failures].dt);
  EXPECT_NE(next.state, starts[i].state);
  EXPECT_DOUBLE_EQ(run.last("time [s]"), .05);
  EXPECT_EQ(run.last("particles lost"), 0.);
}
