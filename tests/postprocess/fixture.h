// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_tests_postprocess_fixture_h
#define thalweg_tests_postprocess_fixture_h

#include <thalweg/core/context.h>
#include <thalweg/postprocess/postprocessor.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/files.h"
#include "support/scene.h"
#include "support/whole.h"

constexpr double pi = dealii::numbers::PI;

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

  Thalweg::FlowView<dim>
  view() const
  {
    return {this->mesh,
            *this->space,
            this->fluids,
            *this->population,
            velocity,
            pressure,
            level_set,
            0.,
            0.,
            0.,
            0,
            0.,
            false,
            flow};
  }

  /// A postprocessor with @p settings that is ready to look.
  std::unique_ptr<Thalweg::Postprocessor<dim>>
  prepare(const std::string              &model,
          const std::vector<std::string> &settings = {})
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
    tool->check(whole(Thalweg::FlowOutline<dim>{this->mesh, this->fluids}));
    tool->initialize(context, whole(view()));
    return tool;
  }

  /// Lets a postprocessor look once, at @p time, and returns it.
  std::unique_ptr<Thalweg::Postprocessor<dim>>
  run(const std::string              &model,
      const std::vector<std::string> &settings = {},
      const double                    time     = 0.)
  {
    auto tool          = prepare(model, settings);
    auto solution      = view();
    solution.time      = time;
    solution.last_step = true;
    tool->execute(context, whole(solution));
    return tool;
  }

  /// The values of all rows, behind the header.
  std::vector<std::vector<double>>
  read_all(const std::string &name) const
  {
    MPI_Barrier(MPI_COMM_WORLD);
    std::istringstream file(content(context.output_directory + "/" + name));
    // Nobody may write it anew before all have read it.
    MPI_Barrier(MPI_COMM_WORLD);
    std::vector<std::vector<double>> rows;
    std::string                      line;
    std::getline(file, line);
    while (std::getline(file, line))
      {
        rows.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');)
          rows.back().push_back(cell.empty() ? std::nan("") : std::stod(cell));
      }
    return rows;
  }

  /// The file's header, and the values of its last row.
  std::pair<std::string, std::vector<double>>
  read(const std::string &name) const
  {
    const auto         rows = read_all(name);
    std::istringstream file(content(context.output_directory + "/" + name));
    std::string        header;
    std::getline(file, header);
    MPI_Barrier(MPI_COMM_WORLD);
    return {header, rows.empty() ? std::vector<double>() : rows.back()};
  }

  Thalweg::Context context;
  Thalweg::Vector  velocity, pressure, level_set;
  /// In spaces of its own, if there is such.
  const Thalweg::FlowFields<dim> *flow = nullptr;
};

#endif
