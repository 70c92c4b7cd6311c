// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_coupling_coupling_h
#define thalweg_coupling_coupling_h

#include <thalweg/core/registry.h>
#include <thalweg/coupling/host.h>
#include <thalweg/fields/state.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Something that carries what methods have to do with each other
   * from one to the other, and owns only what it carries; registered under
   * "Coupling".
   *
   * It sees methods through what they offer (Ports), and asks for that each
   * time, since methods make it anew for each mesh. Its life is that of a
   * method: parameters are declared, read and checked; with create() there is
   * a mesh, with attach() the methods stand on it, and initialize(), or a
   * state and update(), follow.
   */
  template <int dim>
  class Coupling
  {
  public:
    virtual ~Coupling() = default;

    /// Declares its parameters, in a section of its name.
    virtual void
    declare_parameters(const Section &section) = 0;

    /**
     * @brief What it needs of the methods between which it stands: a list of
     * things for each of them, in the order of `Between`. There are as many
     * methods as lists.
     */
    virtual std::vector<std::vector<std::string>>
    needs() const = 0;

    /// Appends what is wrong with the parameters to a list, as far as that
    /// is seen without a mesh.
    virtual void
    check(std::vector<std::string> &) const
    {}

    /// Once a run, when the mesh exists. What @p host refers to lives until
    /// release().
    /// @param methods the names of those between which it stands
    virtual void
    create(const Host<dim> &host, const std::vector<std::string> &methods) = 0;

    /// Lets go of all that stands on the mesh, which is about to vanish.
    virtual void
    release()
    {}

    /// Sets up for the present mesh, on which the methods stand already, with
    /// nothing carried; once for each mesh. Collective.
    virtual void
    attach() = 0;

    /// After attach() at the start: what the first step is to find.
    /// Collective.
    virtual void
    initialize()
    {}

    /// Names what the next step starts from.
    virtual void
    keep(const State<dim> &)
    {}

    /// Finds what follows from the state of itself and of the methods, when
    /// that was carried to another mesh or restored. Collective.
    virtual void
    update()
    {}

    /**
     * @brief Carries, in its place among the methods, what they have become
     * in the step from @p time to @p time + @p dt, in s. Collective.
     *
     * If steps are iterated it is called again for the same step, in which
     * the methods have started anew with what was carried before.
     * @throws StepFailure
     */
    virtual void
    transfer(const double time, const double dt) = 0;

    /// By how much the last transfer() has changed what was carried before in
    /// the same step, relatively: the largest difference over the largest
    /// value. Collective.
    virtual double
    change() const
    {
      return 0.;
    }

    /// The columns of the statistics with which the coupling's begin.
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
  };
} // namespace Thalweg

#endif
