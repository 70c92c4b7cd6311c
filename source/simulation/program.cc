// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/mpi_session.h>
#include <thalweg/core/parameter_file.h>
#include <thalweg/core/reference.h>
#include <thalweg/core/section.h>
#include <thalweg/core/text_file.h>
#include <thalweg/simulation/program.h>
#include <thalweg/simulation/run_directory.h>
#include <thalweg/simulation/settings.h>
#include <thalweg/simulation/simulation.h>

#include <deal.II/base/exceptions.h>

#include <filesystem>
#include <iostream>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    /// The settings that are needed before a simulation exists.
    struct ProgramParameters
    {
      unsigned int dimension = 2;
      std::string  output_directory;

      void
      declare(const Section &root)
      {
        root.add("Dimension",
                 dimension,
                 "",
                 "In how many dimensions the flow is computed.",
                 dealii::Patterns::Integer(2, 3));
        root.add("Output directory",
                 output_directory,
                 "",
                 "Where all results go. If it is empty, they go to "
                 "output/NAME for an input file called NAME.prm. The option "
                 "--output overrides it.");
      }
    };


    ParameterFile
    read_input(const Options &options)
    {
      ParameterFile input =
        options.file.empty() ? ParameterFile() : ParameterFile(options.file);
      for (const std::string &assignment : options.overrides)
        input.override(assignment);
      return input;
    }


    /// Appends what is wrong with @p parameters to @p faults.
    template <int dim>
    void
    check(const SimulationParameters<dim> &parameters,
          const MPI_Comm                   communicator,
          std::vector<std::string>        &faults)
    {
      try
        {
          parameters.check(faults, communicator);
        }
      catch (const std::exception &exception)
        {
          faults.push_back(message_of(exception));
        }
    }


    /// That what was asked for has been written.
    int
    flush_output(const MPI_Comm communicator)
    {
      on_root(communicator, []() {
        AssertThrow(std::cout.flush(),
                    dealii::ExcMessage("Cannot write to the standard output. "
                                       "Is it a file on a full disk?"));
      });
      return 0;
    }


    std::string
    processes(const MPI_Comm communicator)
    {
      const unsigned int n =
        dealii::Utilities::MPI::n_mpi_processes(communicator);
      return n == 1 ? "1 process" : std::to_string(n) + " processes";
    }



    template <int dim>
    int
    run(const MPI_Comm       communicator,
        const Options       &options,
        const ParameterFile &input)
    {
      dealii::ParameterHandler  prm;
      ProgramParameters         program;
      SimulationParameters<dim> parameters;
      {
        const Section root(prm);
        program.declare(root);
        parameters.declare(root, input);
      }
      std::vector<std::string> faults = input.apply(prm);
      Context                  context(communicator);
      if (!options.parameters.empty())
        {
          throw_faults(faults);
          if (context.is_root)
            print_reference(std::cout, prm, options.parameters);
          return flush_output(communicator);
        }
      check(parameters, communicator, faults);
      throw_faults(faults);
      if (context.is_root && options.validate)
        for (const std::string &warning : parameters.warnings(true))
          context.log.warning(warning);
      if (options.validate)
        {
          context.log.line("'" + options.file + "' is valid.");
          return 0;
        }

      std::string directory = program.output_directory;
      if (!options.output.empty())
        directory = options.output;
      else if (directory.empty())
        directory =
          "output/" + std::filesystem::path(options.file).stem().string();
      directory       = with_home(directory);
      context.resumed = options.resume;
      if (context.resumed)
        CheckpointStore::expect_any(directory);
      StopSignals signals(communicator);
      prepare_run_directory(context, directory, with_home(options.file), prm);

      context.log.line("Thalweg " THALWEG_VERSION ", " +
                       processes(communicator) + "; results go to " +
                       directory + "/");
      if (context.is_root && !context.resumed)
        for (const std::string &warning : parameters.warnings(false))
          context.log.warning(warning);
      Simulation<dim> simulation(communicator,
                                 parameters,
                                 context,
                                 settings_of(prm));
      const int       signal = simulation.run(signals);
      context.log.line("The results are in " + directory + "/");
      return signal == 0 ? 0 : 128 + signal;
    }
  } // namespace


  int
  run_program(const MPI_Comm communicator, const Options &options)
  {
    if (options.help || options.version)
      {
        if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
          std::cout << (options.help ? help_text() : version_text());
        return flush_output(communicator);
      }
    // A dimension that does not exist is reported with the other faults, as
    // those of two dimensions.
    const ParameterFile input     = read_input(options);
    int                 dimension = 2;
    std::istringstream(input.value("Dimension", "2")) >> dimension;
    if (dimension == 3)
      return run<3>(communicator, options, input);
    return run<2>(communicator, options, input);
  }



  int
  run_program(int argc, char **argv)
  {
    const MpiSession mpi;
    return run_guarded(MPI_COMM_WORLD, [argc, argv]() {
      return run_program(MPI_COMM_WORLD, read_options(argc, argv));
    });
  }
} // namespace Thalweg
