// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/declared.h>
#include <thalweg/core/spelling.h>

#include <algorithm>
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    /// Adds what is in @p tree, the content of the section @p path.
    void
    collect(const boost::property_tree::ptree &tree,
            const std::string                 &path,
            Declared                          &declared)
    {
      for (const auto &[name, node] : tree)
        {
          const std::string child = path.empty() ? name : path + "/" + name;
          const auto        pattern =
            node.get_optional<std::string>("pattern_description");
          if (pattern && node.find("default_value") != node.not_found())
            declared.parameters.push_back(
              {child,
               node.get<std::string>("default_value"),
               node.get<std::string>("value"),
               node.get<std::string>("documentation", ""),
               *pattern});
          else
            {
              declared.sections.push_back(child);
              collect(node, child, declared);
            }
        }
    }


    /// The one of @p candidates, full paths, that is most like @p path. The
    /// last name counts more than the sections before it: people forget the
    /// section more often than they misspell the whole path.
    std::string
    nearest_path(const std::string              &path,
                 const std::vector<std::string> &candidates)
    {
      std::vector<std::string> siblings, relatives;
      for (const std::string &candidate : candidates)
        if (parent_of(candidate) == parent_of(path))
          siblings.push_back(candidate);
        else if (edit_distance(leaf_of(candidate), leaf_of(path)) == 0)
          relatives.push_back(candidate);

      std::vector<std::string> leaves;
      leaves.reserve(siblings.size());
      for (const std::string &sibling : siblings)
        leaves.push_back(leaf_of(sibling));
      const std::string leaf = nearest(leaf_of(path), leaves);
      if (!leaf.empty())
        return siblings[std::find(leaves.begin(), leaves.end(), leaf) -
                        leaves.begin()];

      const auto likeness = [&path](const std::string &a,
                                    const std::string &b) {
        return edit_distance(path, a) < edit_distance(path, b);
      };
      if (!relatives.empty())
        return *std::min_element(relatives.begin(), relatives.end(), likeness);
      return nearest(path, candidates);
    }
  } // namespace


  Declared::Declared(const dealii::ParameterHandler &prm)
  {
    std::stringstream json;
    prm.print_parameters(json,
                         static_cast<dealii::ParameterHandler::OutputStyle>(
                           dealii::ParameterHandler::JSON |
                           dealii::ParameterHandler::KeepDeclarationOrder));
    boost::property_tree::ptree tree;
    boost::property_tree::read_json(json, tree);
    collect(tree, "", *this);
    for (std::size_t i = 0; i < parameters.size(); ++i)
      index[parameters[i].path] = i;
    known_sections.insert(sections.begin(), sections.end());
  }


  const DeclaredParameter *
  Declared::parameter(const std::string &path) const
  {
    const auto found = index.find(path);
    return found == index.end() ? nullptr : &parameters[found->second];
  }


  bool
  Declared::has_section(const std::string &path) const
  {
    return known_sections.count(path) > 0;
  }


  std::string
  Declared::nearest_parameter(const std::string &path) const
  {
    std::vector<std::string> paths;
    for (const DeclaredParameter &parameter : parameters)
      paths.push_back(parameter.path);
    return nearest_path(path, paths);
  }


  std::string
  Declared::nearest_section(const std::string &path) const
  {
    return nearest_path(path, sections);
  }


  std::string
  leaf_of(const std::string &path)
  {
    return path.substr(path.rfind('/') + 1);
  }


  std::string
  parent_of(const std::string &path)
  {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "" : path.substr(0, slash);
  }
} // namespace Thalweg
