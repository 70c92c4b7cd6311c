#include <thalweg/core/errors.h>
#include <thalweg/simulation/run_directory.h>

#include <deal.II/base/exceptions.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
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
  write_file(const std::string &path, const std::string &content)
  {
    const std::string temporary = path + ".part";
    std::ofstream     file(temporary, std::ios::binary | std::ios::trunc);
    file << content;
    file.close();
    AssertThrow(file,
                dealii::ExcMessage("Cannot write the file '" + path +
                                   "': " + std::strerror(errno) +
                                   ". Choose another place with --output "
                                   "DIR."));
    std::error_code error;
    std::filesystem::rename(temporary, path, error);
    AssertThrow(!error,
                dealii::ExcMessage("Cannot write the file '" + path +
                                   "': " + error.message() + '.'));
  }


  std::string
  read_file(const std::string &path)
  {
    const std::ifstream file(path, std::ios::binary);
    std::ostringstream  content;
    content << file.rdbuf();
    AssertThrow(file, dealii::ExcMessage("Cannot read '" + path + "'."));
    return content.str();
  }


  void
  prepare_run_directory(Context                        &context,
                        const std::string              &directory,
                        const std::string              &input_file,
                        const dealii::ParameterHandler &prm)
  {
    on_root(context.communicator, [&]() {
      create_directory(directory);
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
      if (!context.resumed)
        write_file(directory + "/log.txt", "");
    });
    context.log.open(directory + "/log.txt", context.resumed);
    context.output_directory = directory;
  }
} // namespace Thalweg
