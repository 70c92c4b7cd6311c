// SPDX-License-Identifier: LGPL-2.1-or-later
// What is wrong with parameters before a run.
#include <thalweg/core/errors.h>
#include <thalweg/fields/expression.h>
#include <thalweg/mesh/cell_count.h>
#include <thalweg/mesh/touching_boundaries.h>
#include <thalweg/simulation/simulation_parameters.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Whether refinement leaves the domain as it is.
    template <int dim>
    bool
    has_flat_cells(const Mesh<dim> &mesh)
    {
      const auto manifolds = mesh.triangulation().get_manifold_ids();
      return std::all_of(manifolds.begin(), manifolds.end(), [](const auto id) {
        return id == dealii::numbers::flat_manifold_id;
      });
    }
  } // namespace



  template <int dim>
  void
  SimulationParameters<dim>::check(std::vector<std::string> &faults,
                                   const MPI_Comm            communicator) const
  {
    const auto collect = [&faults](const std::function<void()> &test) {
      collect_fault(faults, test);
    };
    collect([this]() { time.check(); });
    bool has_forces = false;
    collect([&]() {
      forces.check(time.end_time());
      has_forces = true;
    });
    methods.check(faults);
    couplings.check(methods.names_of_used(), faults);
    scheme.check(faults);
    collect([this]() { balance.check(); });
    collect([this]() { mesh.partition->check(); });
    collect([this]() { check_change(); });
    collect([this]() {
      parse_expression<dim>(mesh.local_refinement,
                            1,
                            "Refinement/Local levels");
    });
    const MemoryEstimate estimate = memory(communicator);
    Mesh<dim>            coarse(MPI_COMM_SELF);
    bool                 has_mesh = false;
    collect([&]() {
      estimate.check(
        mesh.geometry->n_cells() *
        std::pow(2., dim * static_cast<double>(mesh.global_refinement)));
      make_coarse(coarse);
      has_mesh = true;
    });
    if (!has_mesh)
      return;
    if (has_forces)
      collect([&]() { check_turning(coarse); });
    collect([&]() { check_size(coarse, estimate); });
    check_on_mesh(coarse, faults);
  }



  template <int dim>
  void
  SimulationParameters<dim>::make_coarse(Mesh<dim> &coarse) const
  {
    try
      {
        coarse.create_coarse(mesh);
        coarse.update();
      }
    catch (const dealii::ExcMessage &)
      {
        throw;
      }
    catch (const std::exception &exception)
      {
        throw dealii::ExcMessage(
          "The mesh of 'Geometry/Model = " + mesh.geometry.model_name() +
          "' cannot be made: " + message_of(exception));
      }
  }



  template <int dim>
  MemoryEstimate
  SimulationParameters<dim>::memory(const MPI_Comm communicator) const
  {
    return {communicator, dim, methods.particles_per_cell(), mesh.memory_limit};
  }



  template <int dim>
  void
  SimulationParameters<dim>::check_size(const Mesh<dim>      &coarse,
                                        const MemoryEstimate &memory) const
  {
    if (is_expression<dim>(mesh.local_refinement, 1))
      memory.check(
        count_cells(coarse.triangulation(),
                    mesh.global_refinement,
                    *parse_expression<dim>(mesh.local_refinement,
                                           1,
                                           "Refinement/Local levels"),
                    mesh.local_refinement.find_first_of("xyz") ==
                      std::string::npos,
                    1.1 * memory.most_cells()));
  }



  template <int dim>
  void
  SimulationParameters<dim>::check_on_mesh(
    const Mesh<dim>          &coarse,
    std::vector<std::string> &faults) const
  {
    methods.check_on_mesh(coarse, faults);
    const RunOutline<dim> outline =
      methods.outline(coarse, has_flat_cells(coarse));
    methods.check_on_outline(outline, faults);
    couplings.check_needs(methods.names_of_used(), outline.offered, faults);
    collect_fault(faults, [&]() { adaptive.check(outline); });
    for (std::size_t i = 0; i < postprocessors.chosen().size(); ++i)
      {
        std::vector<std::string> own;
        collect_fault(own,
                      [&]() { postprocessors.chosen()[i]->check(outline); });
        for (const std::string &fault : own)
          faults.push_back(fault.find("'Postprocess/") == std::string::npos
                             ? "In 'Postprocess/" +
                                 postprocessors.chosen_names()[i] +
                                 "': " + fault
                             : fault);
      }
  }



  template <int dim>
  std::vector<std::string>
  SimulationParameters<dim>::warnings(const bool before_run) const
  {
    Mesh<dim> coarse(MPI_COMM_SELF);
    coarse.create_coarse(mesh);
    coarse.update();
    std::vector<std::string> texts{
      touching_boundaries(coarse.triangulation(), coarse.boundary_names())};
    if (before_run)
      for (const std::string &warning : methods.warnings(
             coarse,
             std::pow(2., dim * static_cast<double>(mesh.global_refinement)) *
               coarse.graph().n_owned_cells()))
        texts.push_back(warning);
    texts.erase(std::remove(texts.begin(), texts.end(), ""), texts.end());
    return texts;
  }



  template <int dim>
  void
  SimulationParameters<dim>::check_change() const
  {
    AssertThrow(mesh.partition->can_change() || !adaptive.is_active(),
                dealii::ExcMessage(
                  "'Refinement/Adaptive/Criteria' is not empty, but meshes "
                  "with 'Partition/Model = " +
                  mesh.partition.model_name() +
                  "' do not change during the run. Use 'Partition/Model = "
                  "p4est', or refine beforehand by 'Refinement/Global levels' "
                  "and 'Local levels'."));
  }



  template <int dim>
  void
  SimulationParameters<dim>::check_turning(const Mesh<dim> &coarse) const
  {
    MovingFrame<dim> frame = forces.frame();
    frame.initialize(time.end_time());
    for (const PeriodicPair &pair : coarse.periodic_pairs())
      AssertThrow(frame.keeps_direction(pair.direction),
                  dealii::ExcMessage(
                    "With 'Moving frame' the tank turns, and what accelerates "
                    "fluids there differs between boundaries of 'Geometry/"
                    "Periodic boundaries': only those along the axis can be "
                    "periodic."));
  }



  template struct SimulationParameters<2>;
  template struct SimulationParameters<3>;
} // namespace Thalweg
