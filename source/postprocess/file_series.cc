// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/files.h>
#include <thalweg/postprocess/file_series.h>

#include <deal.II/base/utilities.h>

#include <cctype>
#include <filesystem>

namespace Thalweg
{
  namespace fs = std::filesystem;

  namespace
  {
    /// The number in a name of the series @p series, such as "NAME_0012.vtu";
    /// -1: it is none.
    long
    number_in(const std::string &name, const std::string &series)
    {
      std::size_t place = series.size() + 1;
      if (name.compare(0, place, series + "_") != 0)
        return -1;
      long number = 0;
      for (; place < name.size() && std::isdigit(name[place]) &&
             number < 1000000000;
           ++place)
        number = 10 * number + (name[place] - '0');
      return place > series.size() + 4 && place < name.size() &&
                 name[place] == '.'
               ? number
               : -1;
    }
  } // namespace



  void
  FileSeries::open(Context                        &context,
                   const std::string              &name,
                   const std::vector<std::string> &endings)
  {
    this->context = &context;
    this->name    = name;
    this->endings = endings;
    is_known      = !context.resumed;
    if (context.output_directory.empty())
      return;
    on_root(context.communicator, [&]() {
      context.results.add(name);
      for (const std::string &ending : endings)
        context.results.add(name + ending);
      make_directory(path());
    });
  }



  std::string
  FileSeries::path() const
  {
    return context->output_directory + "/" + name;
  }



  std::string
  FileSeries::path_of(const unsigned int number) const
  {
    return path() + "/" + name + "_" +
           dealii::Utilities::int_to_string(number, 4);
  }



  void
  FileSeries::prepare(const bool is_first)
  {
    if (is_known || !is_first)
      return;
    is_known      = true;
    bool is_empty = fs::is_empty(path());
    for (const std::string &ending : endings)
      is_empty = is_empty && !fs::exists(path() + ending);
    if (is_empty)
      return;
    const std::string aside = move_aside(path());
    for (const std::string &ending : endings)
      if (fs::exists(path() + ending))
        move_aside(path() + ending);
    make_directory(path());
    context->log.warning(
      "The checkpoint does not know the files in '" + path() +
      "': they begin anew, and what they were is now in '" + aside + "'.");
  }



  void
  FileSeries::drop_from(const unsigned int number)
  {
    is_known = true;
    std::vector<fs::path> late;
    for (const auto &entry : fs::directory_iterator(path()))
      if (number_in(entry.path().filename().string(), name) >= long(number))
        late.push_back(entry.path());
    for (const fs::path &file : late)
      fs::remove(file);
  }
} // namespace Thalweg
