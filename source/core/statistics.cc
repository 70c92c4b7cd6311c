#include <thalweg/core/statistics.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <fstream>
#include <iomanip>

namespace Thalweg
{
  void
  Statistics::open(const std::string &path)
  {
    this->path = path;
    std::ofstream file(path, std::ios::trunc);
    AssertThrow(file,
                dealii::ExcMessage("Cannot write the statistics to '" + path +
                                   "'. Does the directory exist, may you "
                                   "write there, and is the disk full?"));
  }



  void
  Statistics::declare(const std::vector<std::string> &leading_columns)
  {
    Assert(columns.empty(), dealii::ExcMessage("There are columns already."));
    columns = leading_columns;
  }



  void
  Statistics::set(const std::string &name, const double value)
  {
    if (std::find(columns.begin(), columns.end(), name) == columns.end())
      columns.push_back(name);
    row[name] = value;
  }



  void
  Statistics::add(const std::string &name, const double value)
  {
    const auto entry = row.find(name);
    set(name, value + (entry == row.end() ? 0. : entry->second));
  }



  double
  Statistics::get(const std::string &name) const
  {
    if (const auto entry = row.find(name); entry != row.end())
      return entry->second;
    const auto entry = last_row.find(name);
    AssertThrow(entry != last_row.end(),
                dealii::ExcMessage("The statistics have no column '" + name +
                                   "'."));
    return entry->second;
  }



  bool
  Statistics::has(const std::string &name) const
  {
    return row.count(name) + last_row.count(name) > 0;
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
        std::ofstream file(path, std::ios::app);
        if (first_row)
          {
            for (std::size_t c = 0; c < columns.size(); ++c)
              file << (c > 0 ? "," : "") << columns[c];
            file << '\n';
          }
        file << std::setprecision(12);
        for (std::size_t c = 0; c < n_columns_in_file; ++c)
          {
            file << (c > 0 ? "," : "");
            if (const auto entry = row.find(columns[c]); entry != row.end())
              file << entry->second;
          }
        file << '\n';
        AssertThrow(file.flush(),
                    dealii::ExcMessage("Cannot write to '" + path +
                                       "': is the disk full?"));
      }
    first_row = false;
    last_row  = row;
    row.clear();
  }
} // namespace Thalweg
