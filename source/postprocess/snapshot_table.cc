#include <thalweg/core/errors.h>
#include <thalweg/postprocess/snapshot_table.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace Thalweg
{
  namespace
  {
    void
    write_file(const std::string                      &path,
               const std::vector<std::string>         &columns,
               const std::vector<std::vector<double>> &rows)
    {
      const std::string temporary = path + ".new";
      std::ofstream     file(temporary, std::ios::trunc);
      file.precision(12);
      for (std::size_t c = 0; c < columns.size(); ++c)
        file << (c > 0 ? "," : "") << columns[c];
      file << '\n';
      for (const auto &row : rows)
        {
          AssertDimension(row.size(), columns.size());
          for (std::size_t c = 0; c < row.size(); ++c)
            {
              file << (c > 0 ? "," : "");
              if (std::isfinite(row[c]))
                file << row[c];
            }
          file << '\n';
        }
      file.close();
      AssertThrow(file,
                  dealii::ExcMessage("Cannot write to '" + temporary +
                                     "'. May you write there, and is the disk "
                                     "full?"));
      std::filesystem::rename(temporary, path);
    }
  } // namespace


  void
  SnapshotTable::open(const Context                  &context,
                      const std::string              &name,
                      const std::vector<std::string> &columns)
  {
    this->context = &context;
    this->name    = name;
    this->columns = columns;
    if (context.output_directory.empty())
      return;
    const std::string directory = context.output_directory + "/" + name;
    on_root(context.communicator, [&]() {
      std::error_code error;
      std::filesystem::create_directories(directory, error);
      AssertThrow(!error,
                  dealii::ExcMessage("Cannot create the directory '" +
                                     directory + "': " + error.message() +
                                     "."));
    });
  }


  void
  SnapshotTable::write(const Context                          &context,
                       const std::vector<std::vector<double>> &rows)
  {
    if (context.output_directory.empty())
      return;
    on_root(context.communicator, [&]() {
      write_file(path_of(n_written), columns, rows);
      write_file(context.output_directory + "/" + name + ".csv", columns, rows);
    });
    ++n_written;
  }


  std::string
  SnapshotTable::path_of(const unsigned int number) const
  {
    return context->output_directory + "/" + name + "/" + name + "_" +
           dealii::Utilities::int_to_string(number, 4) + ".csv";
  }


  void
  SnapshotTable::keep(const Archive &archive, const bool without_last)
  {
    unsigned int n_kept = n_written - (without_last && n_written > 0);
    archive.value("number", n_kept);
    if (!archive.is_restoring() || context->output_directory.empty())
      return;
    n_written = n_kept;
    on_root(context->communicator, [&]() {
      namespace fs = std::filesystem;
      const std::string latest =
        context->output_directory + "/" + name + ".csv";
      if (n_written == 0)
        fs::remove(latest);
      else if (fs::exists(path_of(n_written - 1)))
        {
          fs::copy_file(path_of(n_written - 1),
                        latest + ".new",
                        fs::copy_options::overwrite_existing);
          fs::rename(latest + ".new", latest);
        }
    });
  }
} // namespace Thalweg
