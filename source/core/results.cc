// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/files.h>
#include <thalweg/core/results.h>

#include <filesystem>
#include <sstream>

namespace Thalweg
{
  namespace fs = std::filesystem;

  namespace
  {
    const std::string list_name = "/files.txt";

    /// What every run writes, of earlier versions too.
    const std::set<std::string> always{"original.prm",
                                       "parameters.prm",
                                       "log.txt",
                                       "statistics.csv",
                                       "timers.csv",
                                       "checkpoints",
                                       "files.txt"};



    /// Whether @p name is that of something in the directory itself.
    bool
    is_plain(const std::string &name)
    {
      return !name.empty() && name != "." && name != ".." &&
             name.find('/') == std::string::npos;
    }



    std::set<std::string>
    read_list(const std::string &path)
    {
      std::set<std::string> names;
      std::error_code       error;
      if (!fs::exists(path, error))
        return names;
      std::istringstream lines(read_file(path));
      for (std::string name; std::getline(lines, name);)
        if (is_plain(name))
          names.insert(name);
      return names;
    }



    /// Whether the run that was in @p directory has come to something.
    bool
    did_a_step(const std::string &directory)
    {
      std::error_code error;
      const auto size = fs::file_size(directory + "/statistics.csv", error);
      return (!error && size > 0) || fs::exists(directory + "/checkpoints");
    }



    bool
    is_there(const std::string &path)
    {
      std::error_code error;
      return fs::exists(fs::symlink_status(path, error));
    }
  } // namespace



  void
  Results::open(const std::string &directory)
  {
    path  = directory + list_name;
    names = read_list(path);
  }



  void
  Results::add(const std::string &name)
  {
    if (path.empty() || !names.insert(name).second)
      return;
    std::string text;
    for (const std::string &entry : names)
      text += entry + '\n';
    write_file(path, text);
  }



  std::string
  Results::set_aside(const std::string &directory)
  {
    std::set<std::string> names = read_list(directory + list_name);
    names.insert(always.begin(), always.end());
    const bool  is_worth_it = did_a_step(directory);
    std::string place;
    for (const std::string &name : names)
      {
        if (!is_there(directory + "/" + name))
          continue;
        if (!is_worth_it)
          {
            fs::remove_all(directory + "/" + name);
            continue;
          }
        if (place.empty())
          {
            place = directory + "/old";
            for (unsigned int i = 2; is_there(place); ++i)
              place = directory + "/old." + std::to_string(i);
            make_directory(place);
          }
        rename_file(directory + "/" + name, place + "/" + name);
      }
    return place;
  }
} // namespace Thalweg
