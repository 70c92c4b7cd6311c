// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_core_declared_h
#define thalweg_core_declared_h

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace Thalweg
{
  /// A parameter that some ParameterHandler declares.
  struct DeclaredParameter
  {
    std::string path;          ///< "Section/Subsection/Name"
    std::string default_value; ///< as text
    std::string value;         ///< the present one, as text
    std::string text;          ///< its documentation
    std::string pattern;       ///< its description, for in_words()
  };

  /// All parameters and sections of a ParameterHandler, in the order of their
  /// declaration.
  struct Declared
  {
    explicit Declared(const dealii::ParameterHandler &prm);

    std::vector<DeclaredParameter> parameters;
    std::vector<std::string>       sections; ///< "Section/Subsection"

    /// The parameter called @p path, or nullptr.
    const DeclaredParameter *
    parameter(const std::string &path) const;

    /// Whether there is a section called @p path.
    bool
    has_section(const std::string &path) const;

    /// The parameter that somebody may have meant by @p path; empty: none.
    std::string
    nearest_parameter(const std::string &path) const;

    /// The section that somebody may have meant by @p path; empty: none.
    std::string
    nearest_section(const std::string &path) const;

  private:
    std::map<std::string, std::size_t> index; ///< in parameters, by path
    std::set<std::string>              known_sections;
  };

  /// What follows the last slash of @p path.
  std::string
  leaf_of(const std::string &path);

  /// What precedes the last slash of @p path; empty at the top.
  std::string
  parent_of(const std::string &path);
} // namespace Thalweg

#endif
