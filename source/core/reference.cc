// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/declared.h>
#include <thalweg/core/pattern_words.h>
#include <thalweg/core/reference.h>
#include <thalweg/core/spelling.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    /// A parameter's entry: its name, what it may be, and its text.
    void
    print_parameter(std::ostream &out, const DeclaredParameter &parameter)
    {
      out << "- **" << leaf_of(parameter.path)
          << "**: " << in_words(parameter.pattern) << "; default: "
          << (parameter.default_value.empty()
                ? "empty"
                : "`" + parameter.default_value + "`")
          << "\n";
      std::string text = trimmed(parameter.text);
      for (std::size_t end = text.find('\n'); end != std::string::npos;
           end             = text.find('\n', end + 1))
        text.replace(end, 1, "\n  - ");
      if (!text.empty())
        out << "\n  " << text << "\n";
    }


    void
    print_section(std::ostream      &out,
                  const Declared    &declared,
                  const std::string &path)
    {
      const auto belongs = [&path](const DeclaredParameter &parameter) {
        return parent_of(parameter.path) == path;
      };
      if (!path.empty())
        out << "\n## " << path << "\n";
      if (std::any_of(declared.parameters.begin(),
                      declared.parameters.end(),
                      belongs))
        out << "\n";
      for (const DeclaredParameter &parameter : declared.parameters)
        if (belongs(parameter))
          print_parameter(out, parameter);
    }


    void
    print_markdown(std::ostream &out, const Declared &declared)
    {
      out << "# Parameters\n\n"
          << "This page is made by `contrib/update_parameters` out of the "
             "program itself.\nThe headings are the paths of the sections: "
             "`Geometry/box` is the subsection\n`box` in the section "
             "`Geometry`. Defaults are those of two dimensions.\n"
             "`Methods/NAME` is the section of a method of that name "
             "(`Methods/Names`).\n";
      print_section(out, declared, "");
      for (const std::string &section : declared.sections)
        if (std::any_of(declared.parameters.begin(),
                        declared.parameters.end(),
                        [&section](const DeclaredParameter &parameter) {
                          return parent_of(parameter.path) == section;
                        }))
          print_section(out, declared, section);
    }
  } // namespace


  void
  print_reference(std::ostream                   &out,
                  const dealii::ParameterHandler &prm,
                  const std::string              &format)
  {
    using Prm = dealii::ParameterHandler;
    if (format == "markdown")
      print_markdown(out, Declared(prm));
    else
      prm.print_parameters(out,
                           static_cast<Prm::OutputStyle>(
                             (format == "json" ? Prm::JSON : Prm::PRM) |
                             Prm::KeepDeclarationOrder));
  }
} // namespace Thalweg
