#ifndef thalweg_postprocess_postprocessor_h
#define thalweg_postprocess_postprocessor_h

#include <thalweg/core/context.h>
#include <thalweg/core/registry.h>
#include <thalweg/postprocess/solution_view.h>

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

    /// Called once before the first step; checks its parameters against the
    /// mesh. @throws dealii::ExcMessage
    virtual void
    initialize(Context &context, const SolutionView<dim> &solution) = 0;

    /// Called at the start and after every step. Collective.
    virtual void
    execute(Context &context, const SolutionView<dim> &solution) = 0;
  };
} // namespace Thalweg

#endif
