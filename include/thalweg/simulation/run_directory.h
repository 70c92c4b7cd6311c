// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_run_directory_h
#define thalweg_simulation_run_directory_h

#include <thalweg/core/context.h>
#include <thalweg/core/files.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace Thalweg
{
  /**
   * @brief Creates the directory of a run and writes into it what was asked
   * for: `original.prm`, the input file as it was given, and
   * `parameters.prm`, all parameters with the values that are used.
   *
   * The directory is this run's as long as @p context lives. Results of an
   * earlier run, if this one does not go on from it, are moved aside.
   *
   * From then on the log goes to `log.txt` there, and
   * Context::output_directory names the place. When the run is resumed,
   * `log.txt` is continued, and `original.prm` stays what the run was begun
   * with.
   *
   * @param context of the run
   * @param directory where results go; created with its parents
   * @param input_file a copy of it is made; empty: none
   * @param prm after reading
   * @throws dealii::ExcMessage on every process if something cannot be
   *   written, or if another run has the directory
   */
  void
  prepare_run_directory(Context                        &context,
                        const std::string              &directory,
                        const std::string              &input_file,
                        const dealii::ParameterHandler &prm);
} // namespace Thalweg

#endif
