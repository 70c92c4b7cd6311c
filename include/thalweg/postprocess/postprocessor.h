// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_postprocessor_h
#define thalweg_postprocess_postprocessor_h

#include <thalweg/core/context.h>
#include <thalweg/core/registry.h>
#include <thalweg/fields/state.h>
#include <thalweg/methods/solution_view.h>

namespace Thalweg
{
  /**
   * @brief Something that looks at the solution after a step and writes what
   * it sees; it changes nothing.
   */
  template <int dim>
  class Postprocessor
  {
  public:
    virtual ~Postprocessor() = default;

    virtual void
    declare_parameters(const Section &section) = 0;

    /// Checks the parameters; collective over the processes of the mesh.
    /// @throws dealii::ExcMessage
    virtual void
    check(const RunOutline<dim> &) const
    {}

    /// Called once before the first step, when check() has passed.
    /// @throws dealii::ExcMessage if nothing can be written
    virtual void
    initialize(Context &context, const SolutionView<dim> &solution) = 0;

    /// Called at the start and after every step. Collective.
    virtual void
    execute(Context &context, const SolutionView<dim> &solution) = 0;

    /**
     * @brief Names what must be known after execute() to go on in another
     * process, or on another mesh: when the next row is due, the length of
     * files, means over time.
     *
     * Called between two steps, and right after initialize() when a run is
     * resumed; collective. When the mesh changes it is called on the old one,
     * where the old vectors are named, and again after mesh_changed(), for
     * the vectors that are to be filled.
     */
    virtual void
    keep(const State<dim> &)
    {}

    /**
     * @brief Makes anew what belongs to a mesh, with zero vectors where
     * keep() names some; what was known of the old mesh is no longer valid.
     * Collective. The solution is on the new mesh, and its fields may be
     * zero still.
     */
    virtual void
    mesh_changed(const SolutionView<dim> &)
    {}
  };

  /**
   * @brief A postprocessor that looks at a flow: at that of the method which
   * its parameter "Method" names, or at the only one.
   */
  template <int dim>
  class FlowPostprocessor : public Postprocessor<dim>
  {
  public:
    void
    declare_parameters(const Section &section) final;

    void
    check(const RunOutline<dim> &outline) const final;

    void
    initialize(Context &context, const SolutionView<dim> &solution) final;

    void
    execute(Context &context, const SolutionView<dim> &solution) final;

    void
    mesh_changed(const SolutionView<dim> &solution) final;

  protected:
    /// Declares all parameters but "Method".
    virtual void
    declare_for_flow(const Section &section) = 0;

    /// check() for the flow.
    virtual void
    check_for_flow(const FlowOutline<dim> &) const
    {}

    /// initialize() for the flow.
    virtual void
    initialize_for_flow(Context &context, const FlowView<dim> &flow) = 0;

    /// execute() for the flow.
    virtual void
    execute_for_flow(Context &context, const FlowView<dim> &flow) = 0;

    /// mesh_changed() for the flow.
    virtual void
    mesh_changed_for_flow(const FlowView<dim> &)
    {}

  private:
    std::string method;
  };
} // namespace Thalweg

#endif
