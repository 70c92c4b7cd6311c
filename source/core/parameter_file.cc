#include <thalweg/core/declared.h>
#include <thalweg/core/errors.h>
#include <thalweg/core/parameter_file.h>
#include <thalweg/core/pattern_words.h>
#include <thalweg/core/spelling.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    /// What is wrong with the section names in @p lines. The contents of an
    /// unknown section are not looked at: one fault is enough.
    std::vector<std::string>
    section_faults(const InputLines &lines, const Declared &declared)
    {
      std::vector<std::string> faults;
      for (const InputSection &section : lines.sections)
        {
          const std::string parent = parent_of(section.path);
          if (declared.has_section(section.path) ||
              (!parent.empty() && !declared.has_section(parent)))
            continue;
          std::string fault =
            section.place + ": unknown section '" + section.path + "'";
          if (declared.parameter(section.path) != nullptr)
            fault += "; it is a parameter, write 'set " +
                     leaf_of(section.path) + " = ...'";
          else if (declared.has_section(leaf_of(section.path)))
            fault += "; is an 'end' missing before it? '" +
                     leaf_of(section.path) + "' exists outside of '" + parent +
                     "'";
          else
            fault += did_you_mean(declared.nearest_section(section.path));
          faults.push_back(fault);
        }
      return faults;
    }


    /// What is wrong with @p entry, given that no parameter is called so.
    std::string
    unknown_parameter(const InputEntry &entry, const Declared &declared)
    {
      const std::string fault =
        entry.place + ": unknown parameter '" + entry.path + "'";
      if (declared.has_section(entry.path))
        return fault + "; it is a section, write 'subsection " +
               leaf_of(entry.path) + "'";
      return fault + did_you_mean(declared.nearest_parameter(entry.path));
    }


    /// The settings in @p entries that repeat an earlier one at the same
    /// level.
    std::vector<std::string>
    repeated(const std::vector<InputEntry> &entries)
    {
      std::vector<std::string> faults;
      for (auto entry = entries.begin(); entry != entries.end(); ++entry)
        {
          const auto earlier = std::find_if(
            entries.begin(), entry, [&entry](const InputEntry &other) {
              return other.path == entry->path && other.file == entry->file;
            });
          if (earlier != entry)
            faults.push_back(entry->place + ": '" + entry->path +
                             "' is set twice, first to '" + earlier->value +
                             "' (" + earlier->place + ") and now to '" +
                             entry->value + "'; remove one of them");
        }
      return faults;
    }


    /// Sets the parameter of @p entry, which exists.
    void
    set(dealii::ParameterHandler &prm, const InputEntry &entry)
    {
      std::istringstream       path(parent_of(entry.path));
      std::vector<std::string> sections;
      for (std::string section; std::getline(path, section, '/');)
        {
          prm.enter_subsection(section);
          sections.push_back(section);
        }
      const auto leave = [&]() {
        for (std::size_t i = 0; i < sections.size(); ++i)
          prm.leave_subsection();
      };
      try
        {
          prm.set(leaf_of(entry.path), entry.value);
        }
      catch (...)
        {
          leave();
          throw;
        }
      leave();
    }



    /// Sets the parameter of @p entry, or says what is wrong with it.
    std::string
    set_or_fault(dealii::ParameterHandler &prm,
                 const InputEntry         &entry,
                 const Declared           &declared)
    {
      const DeclaredParameter *parameter = declared.parameter(entry.path);
      const std::string        section   = parent_of(entry.path);
      if (parameter == nullptr)
        // The fault of an unknown section in a file is told only once.
        return entry.file.empty() || section.empty() ||
                   declared.has_section(section)
                 ? unknown_parameter(entry, declared)
                 : "";
      const std::string what =
        entry.place + ": '" + entry.path + "' is '" + entry.value + "', but ";
      try
        {
          set(prm, entry);
        }
      catch (const dealii::ParameterHandler::ExcValueDoesNotMatchPattern &)
        {
          return what + "must be " + in_words(parameter->pattern) +
                 did_you_mean(nearest_in(parameter->pattern, entry.value));
        }
      catch (const std::exception &exception)
        {
          return what + "that cannot be used: " + message_of(exception);
        }
      return "";
    }
  } // namespace



  ParameterFile::ParameterFile(const std::string &path)
    : lines(read_input_lines(path))
  {}


  ParameterFile::ParameterFile(const std::string &text, const std::string &name)
    : lines(read_input_lines(text, name))
  {}


  void
  ParameterFile::override(const std::string &assignment)
  {
    const std::size_t equals = assignment.find('=');
    const std::string place  = "--set '" + assignment + "'";
    const std::string path   = trimmed(assignment.substr(0, equals));
    if (equals == std::string::npos || path.empty())
      lines.faults.push_back(place +
                             ": write --set 'Section/Subsection/Name=value'");
    else
      overrides.push_back(
        {path, trimmed(assignment.substr(equals + 1)), place, ""});
  }


  std::string
  ParameterFile::value(const std::string &path,
                       const std::string &otherwise) const
  {
    std::string result = otherwise;
    for (const auto *entries : {&lines.entries, &overrides})
      for (const InputEntry &entry : *entries)
        if (entry.path == path)
          result = entry.value;
    return result;
  }


  std::vector<std::string>
  ParameterFile::apply(dealii::ParameterHandler &prm) const
  {
    const Declared           declared(prm);
    std::vector<std::string> faults = lines.faults;
    const auto add = [&faults](const std::vector<std::string> &more) {
      faults.insert(faults.end(), more.begin(), more.end());
    };
    add(section_faults(lines, declared));
    for (const auto *entries : {&lines.entries, &overrides})
      {
        for (const InputEntry &entry : *entries)
          if (const std::string fault = set_or_fault(prm, entry, declared);
              !fault.empty())
            faults.push_back(fault);
        add(repeated(*entries));
      }
    return faults;
  }



  void
  throw_faults(const std::vector<std::string> &faults)
  {
    if (faults.empty())
      return;
    std::string message =
      faults.size() == 1
        ? "The input has a fault:"
        : "The input has " + std::to_string(faults.size()) + " faults:";
    for (const std::string &fault : faults)
      message += "\n  " + fault;
    AssertThrow(false, dealii::ExcMessage(message));
  }
} // namespace Thalweg
