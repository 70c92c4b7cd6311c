// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/postprocess/csv_file.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <array>
#include <cmath>
#include <sstream>

namespace Thalweg
{
  void
  CsvFile::open(Context                        &context,
                const std::string              &name,
                const std::vector<std::string> &columns)
  {
    this->context = &context;
    n_columns     = columns.size();
    header =
      context.table_comment.empty() ? "" : "# " + context.table_comment + '\n';
    for (std::size_t c = 0; c < columns.size(); ++c)
      header += (c > 0 ? "," : "") + columns[c];
    header += '\n';
    if (context.output_directory.empty())
      return;
    path = context.output_directory + "/" + name;
    on_root(context.communicator, [&]() {
      context.results.add(name);
      if (!context.resumed)
        file.create(path, header);
    });
    if (context.resumed)
      return;
    length = last_length = header.size();
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
      if (!file.is_open())
        {
          const std::string message = file.begin_anew(path, header);
          if (!message.empty())
            this->context->log.warning(message);
        }
      std::ostringstream text;
      text.precision(12);
      for (const std::vector<double> &values : rows)
        {
          AssertDimension(values.size(), n_columns);
          for (std::size_t c = 0; c < values.size(); ++c)
            {
              text << (c > 0 ? "," : "");
              if (std::isfinite(values[c]))
                text << values[c];
            }
          text << '\n';
        }
      last_length = file.length();
      file.append(text.str());
      length = file.length();
    });
    share_lengths();
  }


  void
  CsvFile::share_lengths()
  {
    const auto lengths =
      dealii::Utilities::MPI::broadcast(context->communicator,
                                        std::array<std::uint64_t, 2>{
                                          {last_length, length}});
    last_length = lengths[0];
    length      = lengths[1];
  }


  void
  CsvFile::keep(const Archive &archive, const bool without_last)
  {
    std::uint64_t kept = without_last ? last_length : length;
    archive.value("length", kept);
    if (!archive.is_restoring() || path.empty())
      return;
    on_root(context->communicator, [&]() {
      const std::string message = file.reopen(path, header, kept);
      if (!message.empty())
        context->log.warning(message);
      last_length = length = file.length();
    });
    share_lengths();
  }
} // namespace Thalweg
