#ifndef tests_adaptation_adaptation_h
#define tests_adaptation_adaptation_h

#include <thalweg/adaptation/adaptive_refinement.h>

#include <cstdint>

#include "postprocess/fixture.h"
#include "support/input.h"

namespace AdaptationTest
{
  /// A criterion on its own, or all of them, set up by text.
  template <int dim>
  struct Setup
  {
    /// @param settings of "Refinement/Adaptive"
    /// @param subsections of that section
    explicit Setup(const std::vector<std::string> &settings,
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
    criterion->check({state.mesh, state.fluids}, levels);
    Thalweg::CellWishes wishes(state.mesh.graph().n_owned_cells());
    criterion->evaluate(state.view(), levels, time_ahead, wishes);
    return wishes;
  }



  /// A number that tells meshes apart, whoever owns their cells.
  template <int dim>
  std::uint64_t
  fingerprint(const Thalweg::Mesh<dim> &mesh)
  {
    std::uint64_t sum = 0;
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        sum += std::hash<std::string>()(cell->id().to_string());
    return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  }



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
