// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/simulation/run_directory.h>

#include <deal.II/base/exceptions.h>

#include <filesystem>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    void
    create_directory(const std::string &directory)
    {
      std::error_code error;
      std::filesystem::create_directories(directory, error);
      AssertThrow(!error && std::filesystem::is_directory(directory),
                  dealii::ExcMessage(
                    "Cannot create the output directory '" + directory +
                    "': " + (error ? error.message() : "it is a file") +
                    ". Choose another one with --output DIR."));
    }
  } // namespace


  void
  prepare_run_directory(Context                        &context,
                        const std::string              &directory,
                        const std::string              &input_file,
                        const dealii::ParameterHandler &prm)
  {
    std::string aside;
    on_root(context.communicator, [&]() {
      create_directory(directory);
      context.lock = std::make_unique<RunLock>(directory);
      if (!context.resumed)
        aside = Results::set_aside(directory);
      context.results.open(directory);
      const bool has_original =
        context.resumed && std::filesystem::exists(directory + "/original.prm");
      if (!input_file.empty() && !has_original)
        write_file(directory + "/original.prm", read_file(input_file));
      std::ostringstream parameters;
      prm.print_parameters(parameters,
                           static_cast<dealii::ParameterHandler::OutputStyle>(
                             dealii::ParameterHandler::PRM |
                             dealii::ParameterHandler::KeepDeclarationOrder));
      write_file(directory + "/parameters.prm", parameters.str());
      context.log.open(directory + "/log.txt", context.resumed);
    });
    context.output_directory = directory;
    if (!aside.empty())
      context.log.line("The results of an earlier run are in " + aside +
                       "/ now");
  }
} // namespace Thalweg
