#ifndef thalweg_tests_postprocess_fixture_h
#define thalweg_tests_postprocess_fixture_h

#include <thalweg/core/context.h>
#include <thalweg/fields/node_space.h>
#include <thalweg/materials/fluids.h>
#include <thalweg/particles/population.h>
#include <thalweg/postprocess/postprocessor.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

/// A state with fields given by functions, on a mesh given by settings.
template <int dim>
class State
{
public:
  using Function = std::function<double(const dealii::Point<dim> &)>;

  explicit State(const std::vector<std::string> &settings)
    : context(MPI_COMM_WORLD)
    , mesh(MPI_COMM_WORLD)
  {
    {
      const Thalweg::Section root(prm);
      parameters.declare(root);
      fluids.declare_parameters(root);
    }
    std::string input;
    for (const std::string &line : settings)
      input += line + "\n";
    prm.parse_input_from_string(input);
    mesh.create(parameters);
    space      = std::make_unique<Thalweg::NodeSpace<dim>>(mesh);
    population = std::make_unique<Thalweg::Population<dim>>(mesh);
    space->initialize_scalar(pressure);
    space->initialize_scalar(level_set);
    space->initialize_velocity(velocity);
    set(level_set, [](const auto &) { return -1.; });
    directory();
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
      const Function    &function,
      const unsigned int n_components = 1,
      const unsigned int component    = 0)
  {
    for (unsigned int c = 0; c < mesh.graph().n_cells(); ++c)
      for (unsigned int v = 0; v < (1u << dim); ++v)
        vector.local_element(n_components * space->nodes(c)[v] + component) =
          function(mesh.graph().cell(c).vertices[v]);
  }

  Thalweg::SolutionView<dim>
  view() const
  {
    return {mesh, *space, fluids, *population, velocity, pressure, level_set};
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

  dealii::ParameterHandler                  prm;
  Thalweg::Context                          context;
  Thalweg::MeshParameters<dim>              parameters;
  Thalweg::Fluids                           fluids;
  Thalweg::Mesh<dim>                        mesh;
  std::unique_ptr<Thalweg::NodeSpace<dim>>  space;
  std::unique_ptr<Thalweg::Population<dim>> population;
  Thalweg::Vector                           velocity, pressure, level_set;

private:
  /// One directory for all processes.
  void
  directory()
  {
    static unsigned int n = 0;
    const int           root_process =
      dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, int(getpid()), 0);
    context.output_directory = ::testing::TempDir() + "thalweg_" +
                               std::to_string(root_process) + "_" +
                               std::to_string(n++);
    std::filesystem::create_directories(context.output_directory);
  }
};

#endif
