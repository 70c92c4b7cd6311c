// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_support_run_case_h
#define tests_support_run_case_h

#include <thalweg/simulation/simulation.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <string>

/**
 * @brief A run from the text of an input file, for tests.
 */
template <int dim>
struct RunCase
{
  /// @param output_directory empty: nothing is written
  /// @param is_resumed whether it goes on from a checkpoint there
  explicit RunCase(const std::string &text,
                   const MPI_Comm     communicator     = MPI_COMM_WORLD,
                   const std::string &output_directory = "",
                   const bool         is_resumed       = false);

  ~RunCase();

  /// A value of the last row of the statistics.
  double
  last(const std::string &column) const
  {
    return context.statistics.get(column);
  }

  dealii::ParameterHandler                  prm;
  Thalweg::SimulationParameters<dim>        parameters;
  Thalweg::Context                          context;
  std::unique_ptr<Thalweg::Simulation<dim>> simulation;
};

extern template struct RunCase<2>;
extern template struct RunCase<3>;

#endif
