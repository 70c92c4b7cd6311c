// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/input_lines.h>
#include <thalweg/core/plain_text.h>
#include <thalweg/core/spelling.h>
#include <thalweg/core/text_file.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <utility>

namespace Thalweg
{
  namespace
  {
    /// The name in @p text: each run of white space is one space, and what no
    /// name can have is made visible.
    std::string
    name_in(const std::string &text)
    {
      std::istringstream       stream(text);
      std::vector<std::string> words;
      for (std::string word; stream >> word;)
        words.push_back(word);
      return excerpt(joined(words, " "));
    }


    /// What stands on a line before a comment.
    std::string
    without_comment(const std::string &line)
    {
      return trimmed(line.substr(0, line.find('#')));
    }


    // What nobody writes by hand, in all files of an input together. Beyond
    // that an input is the wrong file, or made to use up memory.
    constexpr std::size_t  most_bytes  = 4000000;
    constexpr unsigned int most_lines  = 100000;
    constexpr unsigned int most_files  = 500;
    constexpr unsigned int most_faults = 500;
    constexpr unsigned int deepest     = 20; ///< sections in sections


    /// Reads files and gathers what is in them.
    class Reader
    {
    public:
      InputLines lines;

      void
      read_file(const std::string &path, const std::string &included_from);

      void
      read_text(std::string text, const std::string &name);

    private:
      /// Whether reading goes on with @p physical, the next line.
      bool
      next_line(std::istream &stream, std::string &physical);

      void
      read_line(const std::string &text, const std::string &file);

      void
      read_setting(const std::string &text, const std::string &file);

      void
      read_include(const std::string &text, const std::string &file);

      void
      fault(const std::string &text)
      {
        lines.faults.push_back(place + ": " + text);
        if (lines.faults.size() == most_faults)
          stop("these are " + std::to_string(most_faults) + " faults");
      }

      /// Reads nothing more.
      void
      stop(const std::string &reason)
      {
        if (!is_stopped)
          lines.faults.push_back(place + ": " + reason +
                                 "; nothing is read from here on");
        is_stopped = true;
      }

      std::string
      path_of(const std::string &name) const
      {
        return (sections.empty() ? "" : joined(sections, "/") + "/") + name;
      }

      using Identity = decltype(TextFile::identity);

      std::string              place;
      std::vector<std::string> sections;       ///< open ones, outermost first
      std::vector<std::string> section_places; ///< where they were opened
      std::size_t              first_section = 0; ///< of the current file
      std::vector<Identity>    open_files;
      bool                     is_stopped = false;
      std::size_t              n_bytes    = 0;
      unsigned int             n_lines    = 0;
      unsigned int             n_files    = 0;
    };


    void
    Reader::read_file(const std::string &path, const std::string &included_from)
    {
      const std::string prefix =
        included_from.empty() ? "" : included_from + ": ";
      const std::string what = "the input file '" + excerpt(path) + "'";
      TextFile          file;
      try
        {
          file = read_text_file(with_home(path), what, most_bytes);
        }
      catch (const std::exception &exception)
        {
          lines.faults.push_back(prefix + message_of(exception));
          return;
        }
      if (std::count(open_files.begin(), open_files.end(), file.identity) > 0)
        {
          lines.faults.push_back(prefix + "'" + excerpt(path) +
                                 "' includes itself, directly or through "
                                 "other files");
          return;
        }
      n_bytes += file.content.size();
      if (++n_files > most_files || n_bytes > most_bytes)
        {
          stop("these are " + std::to_string(n_files) + " files with " +
               std::to_string(n_bytes) +
               " bytes, more than an input can have; does one include others "
               "again and again?");
          return;
        }
      open_files.push_back(file.identity);
      read_text(std::move(file.content), path);
      open_files.pop_back();
    }


    bool
    Reader::next_line(std::istream &stream, std::string &physical)
    {
      if (is_stopped || !std::getline(stream, physical))
        return false;
      if (++n_lines > most_lines)
        stop("these are " + std::to_string(n_lines) +
             " lines, more than an input can have");
      return !is_stopped;
    }


    void
    Reader::read_text(std::string text, const std::string &name)
    {
      const std::size_t outer_first_section = first_section;
      first_section                         = sections.size();

      try
        {
          text = plain_lines(text, "'" + excerpt(name) + "'");
        }
      catch (const std::exception &exception)
        {
          lines.faults.push_back(message_of(exception));
          text.clear();
        }
      std::istringstream stream(text);
      std::string        physical;
      unsigned int       number = 0;
      while (next_line(stream, physical))
        {
          ++number;
          place            = excerpt(name) + ":" + std::to_string(number);
          std::string line = without_comment(physical);
          while (!line.empty() && line.back() == '\\')
            {
              line.pop_back();
              if (!next_line(stream, physical))
                {
                  fault("the last line ends with '\\', but no line follows "
                        "that could continue it");
                  break;
                }
              ++number;
              line += without_comment(physical);
            }
          line = trimmed(line);
          if (!line.empty())
            read_line(line, name);
        }

      while (sections.size() > first_section)
        {
          if (!is_stopped)
            lines.faults.push_back(section_places.back() +
                                   ": 'end' is missing for the subsection '" +
                                   excerpt(joined(sections, "/")) +
                                   "' that begins here");
          sections.pop_back();
          section_places.pop_back();
        }
      first_section = outer_first_section;
    }


    void
    Reader::read_line(const std::string &text, const std::string &file)
    {
      const std::size_t space   = text.find_first_of(" \t=");
      const std::string keyword = text.substr(0, space);
      const std::string rest =
        space == std::string::npos ? "" : trimmed(text.substr(space));

      if (keyword == "set" || keyword == "SET")
        read_setting(rest, file);
      else if (keyword == "subsection" || keyword == "SUBSECTION")
        {
          if (rest.empty())
            fault("'subsection' needs a name after it");
          const std::string parent = joined(sections, "/");
          sections.push_back(name_in(rest));
          section_places.push_back(place);
          if (sections.size() > deepest)
            stop("these are " + std::to_string(sections.size()) +
                 " subsections in each other; is each one closed by 'end'?");
          else if (!rest.empty())
            lines.sections.push_back({joined(sections, "/"), parent, place});
        }
      else if ((keyword == "end" || keyword == "END") && rest.empty())
        {
          if (sections.size() == first_section)
            fault("'end' without a 'subsection' that it could close");
          else
            {
              sections.pop_back();
              section_places.pop_back();
            }
        }
      else if (keyword == "include" || keyword == "INCLUDE")
        read_include(rest, file);
      else
        fault("cannot understand '" + excerpt(text) +
              "'; a line is 'subsection NAME', "
              "'set NAME = VALUE', 'end', 'include FILE' or a comment that "
              "begins with '#'" +
              did_you_mean(
                nearest(keyword, {"set", "subsection", "end", "include"})));
    }


    void
    Reader::read_setting(const std::string &text, const std::string &file)
    {
      const std::size_t equals = text.find('=');
      const std::string name   = name_in(text.substr(0, equals));
      if (equals == std::string::npos || name.empty())
        {
          fault("cannot understand 'set " + excerpt(text) +
                "'; write 'set NAME = VALUE'");
          return;
        }
      lines.entries.push_back({path_of(name),
                               trimmed(text.substr(equals + 1)),
                               place,
                               file,
                               joined(sections, "/")});
    }


    void
    Reader::read_include(const std::string &text, const std::string &file)
    {
      if (text.empty())
        {
          fault("'include' needs the name of a file after it");
          return;
        }
      const std::string           here = place;
      const std::filesystem::path directory =
        std::filesystem::path(file).parent_path();
      read_file((directory / with_home(text)).string(), here);
      place = here;
    }
  } // namespace


  InputLines
  read_input_lines(const std::string &path)
  {
    Reader reader;
    reader.read_file(path, "");
    return reader.lines;
  }


  InputLines
  read_input_lines(const std::string &text, const std::string &name)
  {
    Reader reader;
    reader.read_text(text, name);
    return reader.lines;
  }
} // namespace Thalweg
