#ifndef thalweg_tests_postprocess_fixture_h
#define thalweg_tests_postprocess_fixture_h

#include <thalweg/core/context.h>
#include <thalweg/postprocess/postprocessor.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/files.h"
#include "support/scene.h"

/// A scene with fields given by functions, for those who look at them.
template <int dim>
class State : public Scene<dim>
{
public:
  using Scalar = typename Scene<dim>::Scalar;

  /// @param settings the text of an input file
  explicit State(const std::string &settings)
    : Scene<dim>(settings)
    , context(MPI_COMM_WORLD)
  {
    this->space->initialize_scalar(pressure);
    this->space->initialize_scalar(level_set);
    this->space->initialize_velocity(velocity);
    set(level_set, [](const auto &) { return -1.; });
    static unsigned int n    = 0;
    context.output_directory = own_path("state_" + std::to_string(n++));
    std::filesystem::create_directories(context.output_directory);
  }

  ~State()
  {
    MPI_Barrier(MPI_COMM_WORLD);
    if (context.is_root)
      std::filesystem::remove_all(context.output_directory);
  }

  /// Sets component @p component of @p n_components at all nodes.
  void
  set(Thalweg::Vector   &vector,
      const Scalar      &function,
      const unsigned int n_components = 1,
      const unsigned int component    = 0)
  {
    const auto &graph = this->mesh.graph();
    for (unsigned int c = 0; c < graph.n_cells(); ++c)
      for (unsigned int v = 0; v < graph.n_vertices; ++v)
        vector.local_element(n_components * this->space->nodes(c)[v] +
                             component) = function(graph.cell(c).vertices[v]);
  }

  Thalweg::SolutionView<dim>
  view() const
  {
    return {this->mesh,
            *this->space,
            this->fluids,
            *this->population,
            velocity,
            pressure,
            level_set};
  }

  /// Lets a postprocessor look once, at @p time, and returns it.
  std::unique_ptr<Thalweg::Postprocessor<dim>>
  run(const std::string              &model,
      const std::vector<std::string> &settings = {},
      const double                    time     = 0.)
  {
    auto tool = Thalweg::Registry<Thalweg::Postprocessor<dim>>::entries()
                  .at(model)
                  .make();
    dealii::ParameterHandler own;
    const Thalweg::Section   root(own);
    tool->declare_parameters(root);
    std::string input;
    for (const std::string &line : settings)
      input += "set " + line + "\n";
    own.parse_input_from_string(input);
    auto solution      = view();
    solution.time      = time;
    solution.last_step = true;
    tool->check({this->mesh, this->fluids});
    tool->initialize(context, solution);
    tool->execute(context, solution);
    return tool;
  }

  /// The file's header, and the values of its last row.
  std::pair<std::string, std::vector<double>>
  read(const std::string &name) const
  {
    MPI_Barrier(MPI_COMM_WORLD);
    std::ifstream       file(context.output_directory + "/" + name);
    std::string         header, line, row;
    std::vector<double> values;
    std::getline(file, header);
    while (std::getline(file, line))
      row = line;
    // Nobody may write it anew before all have read it.
    MPI_Barrier(MPI_COMM_WORLD);
    std::istringstream cells(row);
    for (std::string cell; std::getline(cells, cell, ',');)
      values.push_back(cell.empty() ? std::nan("") : std::stod(cell));
    return {header, values};
  }

  Thalweg::Context context;
  Thalweg::Vector  velocity, pressure, level_set;
};

#endif
