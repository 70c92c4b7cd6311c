// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/statistics.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    /// Keeps the entries of @p row.
    void
    keep_row(const Archive &archive, std::map<std::string, double> &row)
    {
      std::vector<std::string> names;
      std::vector<double>      values;
      for (const auto &[name, value] : row)
        {
          names.push_back(name);
          values.push_back(value);
        }
      archive.value("names", names);
      archive.value("values", values);
      row.clear();
      AssertThrow(names.size() == values.size(),
                  dealii::ExcMessage(
                    "the rows of its statistics are damaged."));
      for (std::size_t i = 0; i < names.size(); ++i)
        row[names[i]] = values[i];
    }
  } // namespace



  void
  Statistics::open(const std::string &path, const bool resumed)
  {
    this->path = path;
    if (!resumed)
      file.create(path, "");
  }



  void
  Statistics::declare(const std::vector<std::string> &leading_columns)
  {
    Assert(columns.empty(), dealii::ExcMessage("There are columns already."));
    columns = leading_columns;
  }



  Statistics::Group::Group(Statistics &statistics, const std::string &name)
    : statistics(statistics)
    , outer_prefix(statistics.prefix)
  {
    if (!name.empty())
      statistics.prefix += name + ": ";
  }



  Statistics::Group::~Group()
  {
    statistics.prefix = outer_prefix;
  }



  void
  Statistics::set(const std::string &name, const double value)
  {
    const std::string column = prefix + name;
    if (std::find(columns.begin(), columns.end(), column) == columns.end())
      columns.push_back(column);
    row[column] = value;
  }



  void
  Statistics::add(const std::string &name, const double value)
  {
    const auto entry = row.find(prefix + name);
    set(name, value + (entry == row.end() ? 0. : entry->second));
  }



  const double *
  Statistics::find(const std::string &name) const
  {
    for (const auto *values : {&row, &last_row})
      if (const auto entry = values->find(name); entry != values->end())
        return &entry->second;
    return nullptr;
  }



  double
  Statistics::get(const std::string &name) const
  {
    for (const std::string &column : {prefix + name, name})
      if (const double *value = find(column))
        return *value;
    throw dealii::ExcMessage("The statistics have no column '" + name + "'.");
  }



  bool
  Statistics::has(const std::string &name) const
  {
    return find(prefix + name) != nullptr || find(name) != nullptr;
  }



  std::string
  Statistics::column_without_number() const
  {
    const auto found = std::find_if(row.begin(), row.end(), [](const auto &e) {
      return !std::isfinite(e.second);
    });
    return found == row.end() ? "" : found->first;
  }



  void
  Statistics::end_row()
  {
    if (first_row)
      {
        const auto is_unused = [this](const std::string &name) {
          return row.count(name) == 0;
        };
        columns.erase(std::remove_if(columns.begin(), columns.end(), is_unused),
                      columns.end());
        n_columns_in_file = columns.size();
      }
    if (!path.empty())
      {
        if (!file.is_open())
          file.create(path, "");
        std::ostringstream text;
        if (file.length() == 0)
          text << header();
        text << std::setprecision(12);
        for (std::size_t c = 0; c < n_columns_in_file; ++c)
          {
            text << (c > 0 ? "," : "");
            if (const auto entry = row.find(columns[c]); entry != row.end())
              text << entry->second;
          }
        text << '\n';
        file.append(text.str());
      }
    first_row = false;
    last_row  = row;
    row.clear();
  }



  std::string
  Statistics::header() const
  {
    std::string text;
    for (std::size_t c = 0; c < n_columns_in_file; ++c)
      text += (c > 0 ? "," : "") + columns[c];
    return text + '\n';
  }



  void
  Statistics::keep(const Archive &archive, Log &log)
  {
    std::uint64_t length = file.length();
    std::uint64_t n_written_columns(n_columns_in_file);
    archive.value("length", length);
    archive.value("columns", columns);
    archive.value("columns in the file", n_written_columns);
    archive.value("first row", first_row);
    keep_row(archive.enter("row"), row);
    keep_row(archive.enter("last row"), last_row);
    AssertThrow(n_written_columns <= columns.size(),
                dealii::ExcMessage("the columns of its statistics are "
                                   "damaged."));
    n_columns_in_file = n_written_columns;
    if (!archive.is_restoring() || path.empty())
      return;
    const std::string message =
      file.reopen(path, first_row ? "" : header(), length);
    if (!message.empty())
      log.warning(message);
  }
} // namespace Thalweg
