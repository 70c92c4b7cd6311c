// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/files.h>
#include <thalweg/postprocess/snapshot_table.h>

#include <deal.II/base/exceptions.h>

#include <cmath>
#include <filesystem>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    std::string
    text_of(const std::vector<std::string>         &columns,
            const std::vector<std::vector<double>> &rows)
    {
      std::ostringstream text;
      text.precision(12);
      for (std::size_t c = 0; c < columns.size(); ++c)
        text << (c > 0 ? "," : "") << columns[c];
      text << '\n';
      for (const auto &row : rows)
        {
          AssertDimension(row.size(), columns.size());
          for (std::size_t c = 0; c < row.size(); ++c)
            {
              text << (c > 0 ? "," : "");
              if (std::isfinite(row[c]))
                text << row[c];
            }
          text << '\n';
        }
      return text.str();
    }
  } // namespace


  void
  SnapshotTable::open(Context                        &context,
                      const std::string              &name,
                      const std::vector<std::string> &columns)
  {
    this->context = &context;
    this->columns = columns;
    series.open(context, name, {".csv"});
  }


  void
  SnapshotTable::write(const Context                          &context,
                       const std::vector<std::vector<double>> &rows)
  {
    if (context.output_directory.empty())
      return;
    on_root(context.communicator, [&]() {
      series.prepare(n_written == 0);
      const std::string text = text_of(columns, rows);
      write_file(path_of(n_written), text);
      write_file(latest(), text);
    });
    ++n_written;
  }


  std::string
  SnapshotTable::latest() const
  {
    return series.path() + ".csv";
  }


  std::string
  SnapshotTable::path_of(const unsigned int number) const
  {
    return series.path_of(number) + ".csv";
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
      series.drop_from(n_written);
      if (n_written == 0)
        std::filesystem::remove(latest());
      else if (std::filesystem::exists(path_of(n_written - 1)))
        write_file(latest(), read_file(path_of(n_written - 1)));
    });
  }
} // namespace Thalweg
