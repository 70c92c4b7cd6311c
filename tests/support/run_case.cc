// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/run_case.h"

template <int dim>
RunCase<dim>::RunCase(const std::string &text,
                      const MPI_Comm     communicator,
                      const std::string &output_directory,
                      const bool         is_resumed)
  : context(communicator)
{
  context.log              = Thalweg::Log(false);
  context.output_directory = output_directory;
  context.resumed          = is_resumed;
  {
    const Thalweg::Section root(prm);
    parameters.declare(root, Thalweg::ParameterFile(text, "the test's input"));
  }
  prm.parse_input_from_string(text);
  simulation = std::make_unique<Thalweg::Simulation<dim>>(communicator,
                                                          parameters,
                                                          context);
  simulation->run();
}



template <int dim>
RunCase<dim>::~RunCase() = default;

template struct RunCase<2>;
template struct RunCase<3>;
