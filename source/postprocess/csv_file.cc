#include <thalweg/core/errors.h>
#include <thalweg/postprocess/csv_file.h>

#include <deal.II/base/exceptions.h>

#include <cmath>
#include <limits>

namespace Thalweg
{
  void
  CsvFile::open(const Context                  &context,
                const std::string              &name,
                const std::vector<std::string> &columns)
  {
    n_columns = columns.size();
    if (context.output_directory.empty())
      return;
    path = context.output_directory + "/" + name;
    on_root(context.communicator, [&]() {
      file.open(path, std::ios::trunc);
      for (std::size_t c = 0; c < columns.size(); ++c)
        file << (c > 0 ? "," : "") << columns[c];
      file << '\n';
      AssertThrow(file.flush(),
                  dealii::ExcMessage("Cannot write to '" + path +
                                     "'. Does the directory exist, may you "
                                     "write there, and is the disk full?"));
    });
  }


  void
  CsvFile::write_row(const Context &context, const std::vector<double> &values)
  {
    write_rows(context, {values});
  }


  void
  CsvFile::write_rows(const Context                          &context,
                      const std::vector<std::vector<double>> &rows)
  {
    if (path.empty())
      return;
    on_root(context.communicator, [&]() {
      file.precision(12);
      for (const std::vector<double> &values : rows)
        {
          AssertDimension(values.size(), n_columns);
          for (std::size_t c = 0; c < values.size(); ++c)
            {
              file << (c > 0 ? "," : "");
              if (std::isfinite(values[c]))
                file << values[c];
            }
          file << '\n';
        }
      AssertThrow(file.flush(),
                  dealii::ExcMessage("Cannot write to '" + path +
                                     "': is the disk full?"));
    });
  }
} // namespace Thalweg
