// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_method_h
#define thalweg_methods_method_h

#include <thalweg/core/offers.h>
#include <thalweg/core/registry.h>
#include <thalweg/core/step_number.h>
#include <thalweg/coupling/host.h>
#include <thalweg/fields/state.h>
#include <thalweg/methods/solution_view.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Something that advances its part of the solution by one time step,
   * and owns all that this part consists of; registered under "Method".
   *
   * Of its life: the sections of the input are declared, read and checked;
   * with create() there is a mesh, with attach() all that stands on it,
   * which is made anew for each mesh and filled by initialize() or from a
   * state.
   */
  template <int dim>
  class Method
  {
  public:
    virtual ~Method() = default;

    /// Declares what no other method has, in a section of its own.
    virtual void
    declare_parameters(const Section &section) = 0;

    /// Declares the sections that describe what the method moves. Called for
    /// methods that are used, after declare_parameters().
    /// @param sections where they stand
    virtual void
    declare_sections(const Section &sections) = 0;

    /// Appends what is wrong with the parameters to a list, as far as that
    /// is seen without a mesh.
    virtual void
    check(std::vector<std::string> &) const
    {}

    /// The same for what is seen on the coarse mesh.
    virtual void
    check_on_mesh(const Mesh<dim> &, std::vector<std::string> &) const
    {}

    /// The same for what is seen when all methods have been outlined.
    virtual void
    check_on_outline(const RunOutline<dim> &, std::vector<std::string> &) const
    {}

    /// What it needs of other methods.
    virtual std::vector<Need>
    needs() const
    {
      return {};
    }

    /// What is suspicious in parameters without faults, on the coarse mesh and
    /// with about so many cells.
    virtual std::vector<std::string>
    warnings(const Mesh<dim> &, const double) const
    {
      return {};
    }

    /// About how many particles a cell has.
    virtual double
    particles_per_cell() const
    {
      return 0.;
    }

    /// Adds what others may know before the run, under the method's name.
    virtual void
    publish(const std::string &, RunOutline<dim> &) const
    {}

    /// Once a run, when the mesh exists. What @p host refers to lives until
    /// release().
    virtual void
    create(const Host<dim> &host) = 0;

    /// Lets go of all that stands on the mesh, which is about to vanish.
    virtual void
    release()
    {}

    /// Sets up for the present mesh, with zero fields; once for each mesh. What
    /// sits in cells stays. Collective.
    virtual void
    attach() = 0;

    /// Offers other methods what is made anew for each mesh, under the name
    /// that it has in Host; behind each attach().
    virtual void
    offer(Ports &) const
    {}

    /// Attaches, and makes the state at the start. Collective.
    virtual void
    initialize() = 0;

    /// Removes all that sits in cells.
    virtual void
    clear()
    {}

    /// Names what attach() must know of the first mesh.
    virtual void
    keep_constants(const Archive &)
    {}

    /// Names what the next step starts from.
    virtual void
    keep(const State<dim> &state) = 0;

    /// Finds what follows from the state, when that was carried to another
    /// mesh or restored. Collective.
    virtual void
    update()
    {}

    /// Adds and removes particles where the mesh has changed. Collective.
    virtual void
    repopulate()
    {}

    /// Whether the conditions of the problem can be met at a time, in s.
    /// Collective. @throws dealii::ExcMessage if not
    virtual void
    check_conditions(const double) const
    {}

    /// The same at the end of a step, if it may differ from that before.
    virtual void
    check_conditions_of_step(const double) const
    {}

    /// What bounds the size of the next step. Collective.
    virtual StepNumbers
    step_numbers() const
    {
      return {};
    }

    /// In how many equal parts the method makes a step of so many seconds.
    virtual unsigned int
    n_sub_steps(const double) const
    {
      return 1;
    }

    /// Called once a step for all methods, before the first of them advances:
    /// what has to be done before what carries the method's things moves.
    /// Collective. @throws StepFailure
    virtual void
    begin_step(const double, const double)
    {}

    /// From @p time to @p time + @p dt, in s. @throws StepFailure
    virtual void
    advance(const double time, const double dt) = 0;

    /// Adds what the method has to the solution as those see it who only
    /// look, under the method's name.
    virtual void
    publish(const std::string &, SolutionView<dim> &) const
    {}

    /// The columns of the statistics with which the method's begin.
    virtual std::vector<std::string>
    columns() const
    {
      return {};
    }

    /// Writes what there is to say of a step that ended at this time, in s,
    /// into the statistics. Collective.
    virtual void
    record(const double)
    {}

    /// What the method consists of, for the log. Collective.
    virtual std::string
    size() const = 0;

    /// Says what is suspicious at the start. Collective.
    virtual void
    warn_at_start() const
    {}

    /// What the line of a step says of the method. Collective.
    virtual std::string
    headline() const = 0;
  };
} // namespace Thalweg

#endif
