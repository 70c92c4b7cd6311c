// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_adaptation_adaptation_h
#define tests_adaptation_adaptation_h

#include <thalweg/adaptation/adaptive_refinement.h>
#include <thalweg/fields/gather.h>

#include <cstdint>

#include "postprocess/fixture.h"
#include "support/input.h"
#include "support/meshes.h"

namespace AdaptationTest
{
  /// A criterion on its own, or all of them, set up by text.
  template <int dim>
  struct Adaptation
  {
    /// @param settings of "Refinement/Adaptive"
    /// @param subsections of that section
    explicit Adaptation(const std::vector<std::string> &settings,
                        const std::string              &subsections = "")
    {
      const Thalweg::Section root(prm);
      adaptive.declare_parameters(root);
      prm.parse_input_from_string(
        section("Refinement", {}, section("Adaptive", settings, subsections)));
    }

    dealii::ParameterHandler         prm;
    Thalweg::AdaptiveRefinement<dim> adaptive;
  };



  /// What one criterion wants.
  template <int dim>
  Thalweg::CellWishes
  wishes(const State<dim>               &state,
         const std::string              &name,
         const std::vector<std::string> &settings,
         const Thalweg::LevelRange      &levels     = {0, 5},
         const double                    time_ahead = 0.)
  {
    const auto criterion =
      Thalweg::Registry<Thalweg::RefinementCriterion<dim>>::entries()
        .at(name)
        .make();
    dealii::ParameterHandler prm;
    criterion->declare_parameters(Thalweg::Section(prm));
    std::string input;
    for (const std::string &line : settings)
      input += "set " + line + "\n";
    prm.parse_input_from_string(input);
    criterion->check(whole(Thalweg::FlowOutline<dim>{state.mesh, state.fluids}),
                     levels);
    Thalweg::CellWishes wishes(state.mesh.graph().n_owned_cells());
    criterion->evaluate(whole(state.view()), levels, time_ahead, wishes);
    return wishes;
  }



  /// Fields given by functions on a mesh that changes, on any communicator.
  template <int dim>
  struct World
  {
    using Scalar = typename Scene<dim>::Scalar;

    World(const MPI_Comm communicator, const std::string &settings)
      : mesh(communicator)
    {
      {
        const Thalweg::Section root(prm);
        mesh_parameters.declare(root);
        fluids.declare_parameters(root);
      }
      prm.parse_input_from_string(settings);
      mesh.create(mesh_parameters);
      space      = std::make_unique<Thalweg::NodeSpace<dim>>(mesh);
      population = std::make_unique<Thalweg::Population<dim>>(mesh);
    }

    /// The fields on the present mesh.
    void
    set(const Scalar &level_set_function, const Scalar &velocity_x)
    {
      space->initialize_scalar(pressure);
      space->initialize_scalar(level_set);
      space->initialize_velocity(velocity);
      for (unsigned int n = 0; n < level_set.locally_owned_size(); ++n)
        {
          level_set.local_element(n) = level_set_function(space->position(n));
          velocity.local_element(dim * n) = velocity_x(space->position(n));
        }
      space->interpolate(level_set, 1);
      space->interpolate(velocity, dim);
    }

    Thalweg::SolutionView<dim>
    view() const
    {
      return whole(Thalweg::FlowView<dim>{
        mesh, *space, fluids, *population, velocity, pressure, level_set});
    }

    /// To be called when the mesh has changed.
    void
    make_space()
    {
      space = std::make_unique<Thalweg::NodeSpace<dim>>(mesh);
    }

    /// Does what the flags say. The fields are to be set anew.
    void
    change_mesh()
    {
      mesh.triangulation().execute_coarsening_and_refinement();
      mesh.update();
      make_space();
    }

    /// A number that tells meshes apart, whoever owns their cells.
    std::uint64_t
    fingerprint() const
    {
      std::uint64_t sum = 0;
      for (const auto &cell : mesh.triangulation().active_cell_iterators())
        if (cell->is_locally_owned())
          sum += std::hash<std::string>()(cell->id().to_string());
      return dealii::Utilities::MPI::sum(
        sum, mesh.triangulation().get_communicator());
    }

    dealii::ParameterHandler                  prm;
    Thalweg::MeshParameters<dim>              mesh_parameters;
    Thalweg::Fluids                           fluids;
    Thalweg::Mesh<dim>                        mesh;
    std::unique_ptr<Thalweg::NodeSpace<dim>>  space;
    std::unique_ptr<Thalweg::Population<dim>> population;
    Thalweg::Vector                           velocity, pressure, level_set;
  };



  template <int dim>
  dealii::Point<dim>
  center_of_box()
  {
    dealii::Point<dim> center;
    for (unsigned int d = 0; d < dim; ++d)
      center[d] = .5;
    return center;
  }
} // namespace AdaptationTest

#endif
