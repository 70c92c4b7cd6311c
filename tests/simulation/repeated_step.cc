// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/methods/pfem2.h>

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
  class Stumbling : public Pfem2<2>
  {
  public:
    static constexpr unsigned int first_failure = 2;
    static constexpr unsigned int n_failures    = 2;

    explicit Stumbling(std::vector<Start> &starts)
      : starts(starts)
    {}

    void
    advance(const double time, const double dt) override
    {
      starts.push_back({time, dt, state()});
      Pfem2<2>::advance(time, dt);
      const unsigned int n = starts.size() - 1;
      if (n >= first_failure && n < first_failure + n_failures)
        throw StepFailure("It stumbled.");
    }

  private:
    /// All numbers of the flow and of the particles on this process.
    std::vector<double>
    state() const
    {
      const FlowView<2>   solution = view({});
      std::vector<double> numbers;
      for (const Vector *field :
           {&solution.velocity, &solution.pressure, &solution.level_set})
        numbers.insert(numbers.end(), field->begin(), field->end());
      for (const auto &particle : solution.population.particles())
        {
          numbers.push_back(particle.id());
          for (unsigned int d = 0; d < 2; ++d)
            numbers.push_back(particle.position()[d]);
          const auto properties = particle.properties();
          numbers.insert(numbers.end(), properties.begin(), properties.end());
        }
      return numbers;
    }

    std::vector<Start> &starts;
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
