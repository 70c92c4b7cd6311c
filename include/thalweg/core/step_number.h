// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_step_number_h
#define thalweg_core_step_number_h

#include <limits>
#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief A dimensionless number that grows with the time step and bounds
   * it: the Courant number, the Fourier number, the step over the shortest
   * time that something takes.
   */
  struct StepNumber
  {
    /// Those of which the user may say how large they become.
    static constexpr const char *courant = "Courant number";
    static constexpr const char *fourier = "Fourier number";

    /// As it is called in statistics and messages.
    std::string name;
    /// Its value for a step of one second, 1/s.
    double rate = 0.;
    /// Up to which the method is stable; infinity: always.
    double stable = std::numeric_limits<double>::infinity();
    /// What makes it unstable beyond, "with explicit viscosity".
    std::string where{};
    /// What is the cause if it asks for steps that are too short, a clause.
    std::string cause = "the solution is probably blowing up";
    /// Of which method, by its name; empty: of the only one.
    std::string method{};

    /// The name with that of the method, "water: Courant number".
    std::string
    title() const
    {
      return method.empty() ? name : method + ": " + name;
    }
  };

  using StepNumbers = std::vector<StepNumber>;
} // namespace Thalweg

#endif
