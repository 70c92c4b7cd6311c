// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_method_h
#define thalweg_methods_method_h

#include <thalweg/core/context.h>
#include <thalweg/core/registry.h>
#include <thalweg/core/step_number.h>
#include <thalweg/fields/state.h>
#include <thalweg/fluid/body_forces.h>
#include <thalweg/methods/solution_view.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /// What all methods of a run stand on.
  template <int dim>
  struct Host
  {
    Context         &context;
    Mesh<dim>       &mesh;
    BodyForces<dim> &forces;
  };

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

    /// Appends what is wrong with the parameters to @p faults, as far as that
    /// is seen without a mesh.
    virtual void
    check(std::vector<std::string> &faults) const = 0;

    /// The same for what is seen on the coarse mesh.
    virtual void
    check_on_mesh(const Mesh<dim>          &coarse,
                  std::vector<std::string> &faults) const = 0;

    /// What is suspicious in parameters without faults, on the coarse mesh.
    /// @param n_cells of the mesh before it adapts, about
    virtual std::vector<std::string>
    warnings(const Mesh<dim> &coarse, const double n_cells) const = 0;

    /// About how many particles a cell has.
    virtual double
    particles_per_cell() const = 0;

    /// What others may know before the run.
    /// @param fills_domain see RunOutline
    virtual RunOutline<dim>
    outline(const Mesh<dim> &mesh, const bool fills_domain) const = 0;

    /// Once a run, when the mesh exists. @param host must outlive the method
    virtual void
    create(const Host<dim> &host) = 0;

    /// Sets up for the present mesh, with zero fields; once for each mesh. What
    /// sits in cells stays. Collective.
    virtual void
    attach() = 0;

    /// Attaches, and makes the state at the start. Collective.
    virtual void
    initialize() = 0;

    /// Removes all that sits in cells.
    virtual void
    clear() = 0;

    /// Names what attach() must know of the first mesh.
    virtual void
    keep_constants(const Archive &archive) = 0;

    /// Names what the next step starts from.
    virtual void
    keep(const State<dim> &state) = 0;

    /// Finds what follows from the state, when that was carried to another
    /// mesh or restored. Collective.
    virtual void
    update() = 0;

    /// Adds and removes particles where the mesh has changed. Collective.
    virtual void
    repopulate() = 0;

    /// Whether the conditions of the problem can be met at @p time, in s.
    /// Collective. @throws dealii::ExcMessage if not
    virtual void
    check_conditions(const double time) const = 0;

    /// The same at the end of a step, if it may differ from that before.
    virtual void
    check_conditions_of_step(const double end) const = 0;

    /// What bounds the size of the next step. Collective.
    virtual StepNumbers
    step_numbers() const = 0;

    /// From @p time to @p time + @p dt, in s. @throws StepFailure
    virtual void
    advance(const double time, const double dt) = 0;

    /// The solution as those see it who only look.
    virtual SolutionView<dim>
    view(const Moment &moment) const = 0;

    /// The columns of the statistics with which the method's begin.
    virtual std::vector<std::string>
    columns() const = 0;

    /// Writes what there is to say of a step that ended at @p time into the
    /// statistics. Collective.
    virtual void
    record(const double time) = 0;

    /// What the method consists of, for the log. Collective.
    virtual std::string
    size() const = 0;

    /// Says what is suspicious at the start. Collective.
    virtual void
    warn_at_start() const = 0;

    /// What the line of a step says of the method. Collective.
    virtual std::string
    headline() const = 0;
  };
} // namespace Thalweg

#endif
