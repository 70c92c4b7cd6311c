#include <thalweg/postprocess/csv_file.h>

#include <deal.II/base/exceptions.h>

#include <cmath>
#include <limits>

namespace Thalweg
{
  void
  run_on_root(const Context &context, const std::function<void()> &action)
  {
    std::string complaint;
    if (context.is_root)
      try
      {
        action();
      }
      catch (const dealii::ExceptionBase &exception)
      {
        std::ostringstream text;
        exception.print_info(text);
        complaint = text.str();
      }
      catch (const std::exception &exception)
      {
        complaint = exception.what();
      }
    complaint
      = dealii::Utilities::MPI::broadcast(context.communicator, complaint, 0);
    AssertThrow(complaint.empty(), dealii::ExcMessage(complaint));
  }


  void
  CsvFile::open(const Context &context,
                const std::string &name,
                const std::vector<std::string> &columns)
  {
    n_columns = columns.size();
    if (context.output_directory.empty())
      return;
    path = context.output_directory + "/" + name;
    run_on_root(context, [&]() {
      file.open(path, std::ios::trunc);
      for (std::size_t c = 0; c < columns.size(); ++c)
        file << (c > 0 ? "," : "") << columns[c];
      file << '\n';
      AssertThrow(file.flush(),
                  dealii::ExcMessage("Cannot write to '" + path
                                     + "'. Does the directory exist, may you "
                                       "write there, and is the disk full?"));
    });
  }


  void
  CsvFile::write_row(const Context &context, const std::vector<double> &values)
  {
    AssertDimension(values.size(), n_columns);
    if (path.empty())
      return;
    run_on_root(context, [&]() {
      file.precision(12);
      for (std::size_t c = 0; c < values.size(); ++c)
      {
        file << (c > 0 ? "," : "");
        if (std::isfinite(values[c]))
          file << values[c];
      }
      file << '\n';
      AssertThrow(file.flush(),
                  dealii::ExcMessage("Cannot write to '" + path
                                     + "': is the disk full?"));
    });
  }
} // namespace Thalweg
