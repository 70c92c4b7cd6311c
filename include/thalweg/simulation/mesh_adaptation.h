// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_mesh_adaptation_h
#define thalweg_simulation_mesh_adaptation_h

#include <thalweg/simulation/simulation_parameters.h>

#include <boost/signals2/connection.hpp>
#include <functional>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Changes the mesh between two steps, and everything that stands on
   * it with it.
   */
  template <int dim>
  class MeshAdaptation
  {
  public:
    /// All arguments must outlive the object.
    /// @param view the present solution
    MeshAdaptation(SimulationParameters<dim>                &parameters,
                   Context                                  &context,
                   Mesh<dim>                                &mesh,
                   const std::vector<Postprocessor<dim> *>  &postprocessors,
                   const std::function<SolutionView<dim>()> &view);

    ~MeshAdaptation();

    /// Adapts the mesh to the initial state, as often as needed. Collective.
    void
    adapt_to_initial_state();

    /**
     * @brief Adapts or repartitions the mesh if that is due or cannot wait.
     * Collective.
     * @param step how many steps were made
     * @param dt of the next one, s
     * @return whether the cells have changed
     */
    bool
    before_step(const unsigned int step, const double dt);

    /// Distributes the cells over the ranks anew. Collective.
    void
    repartition();

    /// Writes what there is to say of the mesh into the statistics.
    /// Collective.
    void
    record();

    /// Names how often the mesh has changed.
    void
    keep(const Archive &archive);

  private:
    /// AdaptiveRefinement::mark(). Collective.
    /// @throws dealii::ExcMessage if there is no memory for the new cells
    bool
    mark(const double dt = 0.);

    /// Changes the mesh and carries everything along. @param change does it
    void
    carry(const std::function<void()> &change);

    /// Names all fields, with the values of methods and couplings.
    void
    keep(const State<dim> &state);

    SimulationParameters<dim>               &parameters;
    Context                                 &context;
    Mesh<dim>                               &mesh;
    MethodList<dim>                         &methods;
    CouplingList<dim>                       &couplings;
    const std::vector<Postprocessor<dim> *> &postprocessors;
    const std::function<SolutionView<dim>()> view;
    const MemoryEstimate                     memory;
    boost::signals2::scoped_connection       weights;
    unsigned int                             n_adaptations     = 0;
    unsigned int                             n_repartitionings = 0;
    /// The mesh is ready for the step behind so many: a run that goes on from
    /// where this step failed does not adapt twice.
    unsigned int ready_for = dealii::numbers::invalid_unsigned_int;
  };
} // namespace Thalweg

#endif
