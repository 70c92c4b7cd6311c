// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/simulation/mesh_adaptation.h>
#include <thalweg/transfer/mesh_transfer.h>

namespace Thalweg
{
  namespace
  {
    /// A surface that reaches coarser cells than this can do without, comes
    /// with steps that are far too long.
    constexpr unsigned int most_levels_at_once = 8;
  } // namespace



  template <int dim>
  MeshAdaptation<dim>::MeshAdaptation(
    SimulationParameters<dim>                &parameters,
    Context                                  &context,
    Mesh<dim>                                &mesh,
    const std::vector<Postprocessor<dim> *>  &postprocessors,
    const std::function<SolutionView<dim>()> &view)
    : parameters(parameters)
    , context(context)
    , mesh(mesh)
    , methods(parameters.methods)
    , couplings(parameters.couplings)
    , postprocessors(postprocessors)
    , view(view)
    , memory(parameters.memory(context.communicator))
    , weights(Compat::connect_weight<dim>(
        mesh.triangulation(),
        [&balance = parameters.balance](const auto &cell, const auto fate) {
          return balance.weight(cell, fate);
        }))
  {}



  template <int dim>
  MeshAdaptation<dim>::~MeshAdaptation() = default;



  template <int dim>
  bool
  MeshAdaptation<dim>::mark(const double dt)
  {
    if (!parameters.adaptive.mark(mesh, view(), dt))
      return false;
    double n_new = 0.;
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        n_new += cell->refine_flag_set()    ? 1 << dim
                 : cell->coarsen_flag_set() ? 1. / (1 << dim)
                                            : 1.;
    memory.check(dealii::Utilities::MPI::sum(n_new, context.communicator));
    return true;
  }



  template <int dim>
  void
  MeshAdaptation<dim>::adapt_to_initial_state()
  {
    const unsigned int n = parameters.adaptive.initial_adaptations();
    for (unsigned int i = 0; i < n && mark(); ++i)
      {
        parameters.balance.count(view());
        methods.clear();
        mesh.triangulation().execute_coarsening_and_refinement();
        mesh.update();
        methods.initialize();
      }
  }



  template <int dim>
  void
  MeshAdaptation<dim>::keep(const State<dim> &state)
  {
    methods.keep(state);
    couplings.keep(state);
    const State<dim> means = state.with(Archive::nowhere());
    for (Postprocessor<dim> *postprocessor : postprocessors)
      postprocessor->keep(means);
  }



  template <int dim>
  void
  MeshAdaptation<dim>::carry(const std::function<void()> &change)
  {
    parameters.balance.count(view());
    const Archive     values;
    MeshTransfer<dim> transfer(mesh);
    {
      const State<dim> state(values);
      keep(state);
      transfer.pack(state);
    }
    change();
    mesh.update();
    methods.attach();
    couplings.attach();
    for (Postprocessor<dim> *postprocessor : postprocessors)
      postprocessor->mesh_changed(view());
    const State<dim> state(values.reader());
    keep(state);
    transfer.unpack(state);
    methods.update();
    couplings.update();
  }



  template <int dim>
  bool
  MeshAdaptation<dim>::before_step(const unsigned int step, const double dt)
  {
    dealii::TimerOutput::Scope scope(context.timers, "adaptation");
    const auto                &refinement = parameters.adaptive;
    const bool                 is_ready   = step == ready_for;
    bool is_wanted = (refinement.is_due(step) && !is_ready) ||
                     refinement.must_adapt(view(), dt);
    bool has_changed = false;
    ready_for        = step;
    // A cell changes by one level at a time.
    for (unsigned int i = 0; i < most_levels_at_once && is_wanted && mark(dt);
         ++i)
      {
        carry(
          [&]() { mesh.triangulation().execute_coarsening_and_refinement(); });
        methods.repopulate();
        ++n_adaptations;
        has_changed = true;
        is_wanted   = refinement.must_adapt(view(), dt);
      }
    if (has_changed || is_ready)
      return has_changed;
    if (parameters.mesh.partition->can_change() &&
        parameters.balance.is_due(view(), step))
      {
        repartition();
        ++n_repartitionings;
      }
    return false;
  }



  template <int dim>
  void
  MeshAdaptation<dim>::repartition()
  {
    carry([&]() { mesh.repartition(); });
  }



  template <int dim>
  void
  MeshAdaptation<dim>::record()
  {
    auto &statistics = context.statistics;
    statistics.set("adaptations", n_adaptations);
    statistics.set("repartitionings", n_repartitionings);
    for (const auto &[name, value] :
         parameters.balance.imbalance(view()).columns())
      statistics.set(name, value);
  }



  template <int dim>
  void
  MeshAdaptation<dim>::keep(const Archive &archive)
  {
    archive.value("adaptations", n_adaptations);
    archive.value("repartitionings", n_repartitionings);
    archive.value("ready for", ready_for);
  }



  THALWEG_INSTANTIATE(MeshAdaptation)
} // namespace Thalweg
