// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_step_scheme_h
#define thalweg_simulation_step_scheme_h

#include <thalweg/simulation/coupling_list.h>
#include <thalweg/simulation/method_list.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief The section "Scheme": in which order methods and couplings make a
   * step, in how many parts, and how often.
   */
  template <int dim>
  class StepScheme
  {
  public:
    /// Both must outlive the object.
    StepScheme(const MethodList<dim>   &methods,
               const CouplingList<dim> &couplings);

    /// Declares the section below @p root.
    void
    declare_parameters(const Section &root);

    /// Appends what is wrong to a list.
    void
    check(std::vector<std::string> &faults) const;

    /// What bounds the size of the next step, the methods being called as
    /// often as the user says. Collective.
    StepNumbers
    step_numbers() const;

    /**
     * @brief Makes the step from @p time to @p time + @p dt, in s: methods
     * and couplings one after the other, and all of them again until what the
     * couplings carry no longer changes.
     * @param statistics where each has columns of its own
     * @param go_back makes of the methods what they were before the step
     * @throws StepFailure
     */
    void
    advance(const double                 time,
            const double                 dt,
            Statistics                  &statistics,
            const std::function<void()> &go_back);

    /// Writes what iterations did into the statistics. Collective.
    void
    record(Statistics &statistics) const;

  private:
    /// What is done at one place of the sequence.
    struct Stage
    {
      std::string    name;
      Method<dim>   *method   = nullptr;
      Coupling<dim> *coupling = nullptr;
    };

    /// All that there is, in the order that is usual.
    std::vector<Stage>
    usual_stages() const;

    /// In the order that the user wants.
    std::vector<Stage>
    stages() const;

    /// All methods and couplings of the sequence once.
    void
    make_pass(const double time, const double dt, Statistics &statistics) const;

    /// In how many equal parts a method makes a step.
    unsigned int
    n_sub_steps(const Stage &stage, const double dt) const;

    /// What the user wants at the least, by the names of methods.
    /// @throws dealii::ExcMessage for what cannot be read
    std::map<std::string, unsigned int>
    sub_steps_of_methods() const;

    void
    check_order() const;

    void
    check_sub_steps() const;

    const MethodList<dim>   &methods;
    const CouplingList<dim> &couplings;
    std::vector<std::string> order;
    std::string              sub_steps;
    unsigned int             iterations = 1;
    double                   tolerance  = 1e-6;
    /// Of the last step.
    unsigned int n_passes = 0;
  };
} // namespace Thalweg

#endif
