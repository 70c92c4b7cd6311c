#include <thalweg/core/input_lines.h>
#include <thalweg/core/spelling.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    /// @p text with each run of white space replaced by one space.
    std::string
    single_spaced(const std::string &text)
    {
      std::istringstream       stream(text);
      std::vector<std::string> words;
      for (std::string word; stream >> word;)
        words.push_back(word);
      return joined(words, " ");
    }


    /// What stands on a line before a comment.
    std::string
    without_comment(const std::string &line)
    {
      return trimmed(line.substr(0, line.find('#')));
    }


    /// Reads files and gathers what is in them.
    class Reader
    {
    public:
      InputLines lines;

      void
      read_file(const std::string &path, const std::string &included_from);

      void
      read_text(std::istream &stream, const std::string &name);

    private:
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
      }

      std::string
      path_of(const std::string &name) const
      {
        return (sections.empty() ? "" : joined(sections, "/") + "/") + name;
      }

      std::string              place;
      std::vector<std::string> sections;       ///< open ones, outermost first
      std::vector<std::string> section_places; ///< where they were opened
      std::size_t              first_section = 0; ///< of the current file
      std::vector<std::string> open_files;
    };


    void
    Reader::read_file(const std::string &path, const std::string &included_from)
    {
      const std::string prefix =
        included_from.empty() ? "" : included_from + ": ";
      std::error_code error;
      if (std::filesystem::is_directory(path, error))
        {
          lines.faults.push_back(prefix + "'" + path +
                                 "' is a directory, not an input file");
          return;
        }
      std::ifstream stream(path);
      if (!stream)
        {
          lines.faults.push_back(prefix + "cannot read the input file '" +
                                 path + "': " + std::strerror(errno));
          return;
        }
      if (std::find(open_files.begin(), open_files.end(), path) !=
          open_files.end())
        {
          lines.faults.push_back(prefix + "'" + path +
                                 "' includes itself, directly or through "
                                 "other files");
          return;
        }
      open_files.push_back(path);
      read_text(stream, path);
      open_files.pop_back();
    }


    void
    Reader::read_text(std::istream &stream, const std::string &name)
    {
      const std::size_t outer_first_section = first_section;
      first_section                         = sections.size();

      std::string  physical;
      unsigned int number = 0;
      while (std::getline(stream, physical))
        {
          ++number;
          if (number == 1 && physical.compare(0, 3, "\xEF\xBB\xBF") == 0)
            physical.erase(0, 3);
          place            = name + ":" + std::to_string(number);
          std::string line = without_comment(physical);
          while (!line.empty() && line.back() == '\\')
            {
              line.pop_back();
              if (!std::getline(stream, physical))
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
          lines.faults.push_back(section_places.back() +
                                 ": 'end' is missing for the subsection '" +
                                 joined(sections, "/") + "' that begins here");
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
          sections.push_back(single_spaced(rest));
          section_places.push_back(place);
          if (!rest.empty())
            lines.sections.push_back({joined(sections, "/"), place});
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
        fault("cannot understand '" + text +
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
      const std::string name   = single_spaced(text.substr(0, equals));
      if (equals == std::string::npos || name.empty())
        {
          fault("cannot understand 'set " + text +
                "'; write 'set NAME = VALUE'");
          return;
        }
      lines.entries.push_back(
        {path_of(name), trimmed(text.substr(equals + 1)), place, file});
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
      read_file((directory / text).string(), here);
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
    Reader             reader;
    std::istringstream stream(text);
    reader.read_text(stream, name);
    return reader.lines;
  }
} // namespace Thalweg
