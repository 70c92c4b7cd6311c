// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/declared.h>
#include <thalweg/core/errors.h>
#include <thalweg/core/parameter_file.h>
#include <thalweg/core/pattern_words.h>
#include <thalweg/core/plain_text.h>
#include <thalweg/core/spelling.h>

#include <deal.II/base/exceptions.h>

#include <map>
#include <sstream>
#include <utility>

namespace Thalweg
{
  namespace
  {
    /// To find what was meant takes a while; after so many faults nobody reads
    /// on.
    constexpr std::size_t most_suggestions = 30;


    /// Where a section stands for a name that is missing in a list: what to
    /// write; else nothing.
    std::string
    unlisted(const std::string &section, const Declared &declared)
    {
      const std::string outer = parent_of(section);
      if (declared.has_section(section))
        return "";
      if (!outer.empty() && !declared.has_section(outer))
        return unlisted(outer, declared);
      const std::string list = outer + "/Names";
      if (declared.parameter(list) == nullptr)
        return "";
      return "; '" + excerpt(leaf_of(section)) + "' is not in '" + list +
             "': add it there, or leave out its section";
    }


    /// What is wrong with the section names in @p lines. The contents of an
    /// unknown section are not looked at: one fault is enough.
    std::vector<std::string>
    section_faults(const InputLines &lines, const Declared &declared)
    {
      std::vector<std::string> faults;
      for (const InputSection &section : lines.sections)
        {
          const std::string &parent = section.parent;
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
          else if (const std::string text = unlisted(section.path, declared);
                   !text.empty())
            fault += text;
          else if (faults.size() < most_suggestions)
            fault += did_you_mean(declared.nearest_section(section.path));
          faults.push_back(fault);
        }
      return faults;
    }


    /// What is wrong with @p entry, given that no parameter is called so.
    std::string
    unknown_parameter(const InputEntry &entry,
                      const Declared   &declared,
                      const bool        suggests)
    {
      const std::string fault =
        entry.place + ": unknown parameter '" + excerpt(entry.path) + "'";
      if (!suggests)
        return fault;
      if (declared.has_section(entry.path))
        return fault + "; it is a section, write 'subsection " +
               leaf_of(entry.path) + "'";
      if (const std::string text = unlisted(parent_of(entry.path), declared);
          !text.empty())
        return fault + text;
      return fault + did_you_mean(declared.nearest_parameter(entry.path));
    }


    /// The settings in @p entries that repeat an earlier one at the same
    /// level.
    std::vector<std::string>
    repeated(const std::vector<InputEntry> &entries)
    {
      std::vector<std::string>                                          faults;
      std::map<std::pair<std::string, std::string>, const InputEntry *> earlier;
      for (const InputEntry &entry : entries)
        {
          const auto [first, is_new] =
            earlier.insert({{entry.path, entry.file}, &entry});
          if (!is_new)
            faults.push_back(entry.place + ": '" + excerpt(entry.path) +
                             "' is set twice, first to '" +
                             excerpt(first->second->value) + "' (" +
                             first->second->place + ") and now to '" +
                             excerpt(entry.value) + "'; remove one of them");
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
                 const Declared           &declared,
                 const bool                suggests)
    {
      const DeclaredParameter *parameter = declared.parameter(entry.path);
      if (parameter == nullptr)
        // The fault of an unknown section in a file is told only once.
        return entry.section.empty() || declared.has_section(entry.section)
                 ? unknown_parameter(entry, declared, suggests)
                 : "";
      const std::string what = entry.place + ": '" + entry.path + "' is '" +
                               excerpt(entry.value) + "', but ";
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
      const std::string twice = repeated_in(parameter->pattern, entry.value);
      return twice.empty()
               ? ""
               : what + "that has '" + twice + "' twice; remove one of them";
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
    const std::string place  = "--set '" + excerpt(assignment) + "'";
    const std::string path   = trimmed(assignment.substr(0, equals));
    if (equals == std::string::npos || path.empty())
      lines.faults.push_back(place +
                             ": write --set 'Section/Subsection/Name=value'");
    else
      overrides.push_back(
        {path, trimmed(assignment.substr(equals + 1)), place, "", ""});
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
          if (const std::string fault = set_or_fault(
                prm, entry, declared, faults.size() < most_suggestions);
              !fault.empty())
            faults.push_back(fault);
        add(repeated(*entries));
      }
    return faults;
  }



  namespace
  {
    /// Of a message that lists faults, so that all of it is shown.
    constexpr std::size_t longest_fault = 1000;
    constexpr std::size_t longest_list  = longest_message - longest_fault - 50;
  } // namespace



  void
  throw_faults(const std::vector<std::string> &faults)
  {
    if (faults.empty())
      return;
    std::string message =
      faults.size() == 1
        ? "The input has a fault:"
        : "The input has " + std::to_string(faults.size()) + " faults:";
    std::size_t n = 0;
    for (; n < faults.size() && message.size() < longest_list; ++n)
      message += "\n  " + bounded_message(faults[n], longest_fault);
    if (n < faults.size())
      message += "\n  and " + std::to_string(faults.size() - n) + " more";
    AssertThrow(false, dealii::ExcMessage(message));
  }
} // namespace Thalweg
