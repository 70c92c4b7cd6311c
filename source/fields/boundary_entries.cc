// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/fields/boundary_entries.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace Thalweg
{
  std::vector<std::pair<std::string, std::string>>
  split_by_boundary(const std::string &text, const std::string &where)
  {
    using dealii::Utilities::trim;
    std::vector<std::pair<std::string, std::string>> result;
    for (const std::string &entry :
         dealii::Utilities::split_string_list(text, '|'))
      {
        if (entry.empty())
          continue;
        const auto colon = entry.find(':');
        AssertThrow(colon != std::string::npos,
                    dealii::ExcMessage("'" + entry + "' in '" + where +
                                       "' has no colon between the boundary's "
                                       "name and the expression."));
        result.emplace_back(trim(entry.substr(0, colon)),
                            trim(entry.substr(colon + 1)));
      }
    return result;
  }



  template <int dim>
  dealii::types::boundary_id
  find_boundary(const Mesh<dim>   &mesh,
                const std::string &name,
                const std::string &section)
  {
    try
      {
        return mesh.boundary_id(name);
      }
    catch (const dealii::ExcMessage &exception)
      {
        throw dealii::ExcMessage(message_of(exception) + " See '" + section +
                                 "'.");
      }
  }



  template <int dim>
  bool
  is_periodic(const Mesh<dim> &mesh, const dealii::types::boundary_id id)
  {
    return std::any_of(mesh.periodic_pairs().begin(),
                       mesh.periodic_pairs().end(),
                       [id](const auto &pair) {
                         return pair.first == id || pair.second == id;
                       });
  }



  template dealii::types::boundary_id
  find_boundary<2>(const Mesh<2> &, const std::string &, const std::string &);
  template dealii::types::boundary_id
  find_boundary<3>(const Mesh<3> &, const std::string &, const std::string &);
  template bool
  is_periodic<2>(const Mesh<2> &, const dealii::types::boundary_id);
  template bool
  is_periodic<3>(const Mesh<3> &, const dealii::types::boundary_id);
} // namespace Thalweg
