// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_boundary_entries_h
#define thalweg_fields_boundary_entries_h

#include <thalweg/mesh/mesh.h>

#include <string>
#include <utility>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Splits what users give boundary by boundary,
   * `left: 1; 0 | top: 2; 0`, into names and expressions.
   * @param where the parameter, for the message
   * @throws dealii::ExcMessage for an entry without a colon
   */
  std::vector<std::pair<std::string, std::string>>
  split_by_boundary(const std::string &text, const std::string &where);

  /// The boundary called @p name. @param section where it is named, for the
  /// message @throws dealii::ExcMessage if there is none
  template <int dim>
  dealii::types::boundary_id
  find_boundary(const Mesh<dim>   &mesh,
                const std::string &name,
                const std::string &section);

  /// Whether a boundary is one of those that are joined to another one.
  template <int dim>
  bool
  is_periodic(const Mesh<dim> &mesh, const dealii::types::boundary_id id);
} // namespace Thalweg

#endif
