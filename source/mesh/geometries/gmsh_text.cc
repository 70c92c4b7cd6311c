// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/gmsh.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace Thalweg
{
  namespace Geometries
  {
    namespace
    {
      /// Meshes farther away than this times their extent are moved.
      constexpr double far = 10.;
    } // namespace



    std::string
    gmsh_text(const MeshOutline    &outline,
              const unsigned int    dim,
              dealii::Tensor<1, 3> &offset)
    {
      offset = dealii::Tensor<1, 3>();
      if (!outline.points.empty())
        {
          const auto first  = outline.points[0];
          double     extent = 0.;
          for (const auto &point : outline.points)
            extent = std::max(extent, first.distance(point));
          if (first.norm() > far * extent)
            offset = first;
        }
      std::ostringstream text;
      text.precision(std::numeric_limits<double>::max_digits10);
      text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n"
           << outline.points.size() << '\n';
      for (std::size_t i = 0; i < outline.points.size(); ++i)
        text << i + 1 << ' ' << outline.points[i] - offset << '\n';
      std::size_t        n = 0;
      std::ostringstream elements;
      for (const auto &element : outline.elements)
        if (dimension_of(element.shape) + 1 >= dim)
          {
            elements << ++n << ' ' << static_cast<int>(element.shape) << " 1 "
                     << element.tag;
            for (const unsigned int node : element.nodes)
              elements << ' ' << node + 1;
            elements << '\n';
          }
      text << "$EndNodes\n$Elements\n"
           << n << '\n'
           << elements.str() << "$EndElements\n";
      return text.str();
    }
  } // namespace Geometries
} // namespace Thalweg
