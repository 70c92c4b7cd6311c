// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_boundary_name_h
#define thalweg_mesh_boundary_name_h

#include <deal.II/base/types.h>

#include <map>
#include <string>

namespace Thalweg
{
  /// How messages call the boundary @p id: by a name that was given to it
  /// rather than by its number.
  inline std::string
  boundary_name(const std::map<std::string, dealii::types::boundary_id> &names,
                const dealii::types::boundary_id                         id)
  {
    const std::string number = std::to_string(id);
    for (const auto &[name, named] : names)
      if (named == id && name != number)
        return name;
    return number;
  }
} // namespace Thalweg

#endif
