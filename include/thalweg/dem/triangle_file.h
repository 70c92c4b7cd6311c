// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_triangle_file_h
#define thalweg_dem_triangle_file_h

#include <thalweg/dem/vec3.h>

#include <array>
#include <string>
#include <vector>

namespace Thalweg
{
  using Triangle = std::array<Vec3, 3>;

  /**
   * @brief The triangles of a file, STL (ASCII or binary) or OBJ, whose polygons
   * are cut into triangles. Those without an area are left out.
   * @throws dealii::ExcMessage if it cannot be read, is cut short, has what is
   *   no number or no triangles at all
   */
  std::vector<Triangle>
  read_triangles(const std::string &path);
} // namespace Thalweg

#endif
