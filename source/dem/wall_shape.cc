// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/dem/wall_shape.h>

#include <algorithm>

namespace Thalweg
{
  Vec3
  vector_of(const std::vector<double> &numbers,
            const int                  dim,
            const Vec3                &otherwise,
            const std::string         &where)
  {
    if (numbers.empty())
      return otherwise;
    AssertThrow(numbers.size() == static_cast<unsigned int>(dim),
                dealii::ExcMessage("'" + where + "' has " +
                                   std::to_string(numbers.size()) +
                                   " numbers, but " + std::to_string(dim) +
                                   " are needed, separated by commas."));
    return {numbers[0], numbers[1], dim == 3 ? numbers[2] : 0.};
  }



  Vec3
  direction_of(const std::vector<double> &numbers,
               const int                  dim,
               const std::string         &where)
  {
    const Vec3   direction = vector_of(numbers, dim, {0., 0., 0.}, where);
    const double length    = norm(direction);
    AssertThrow(length > 0.,
                dealii::ExcMessage("'" + where +
                                   "' must be a direction, such as '" +
                                   (dim == 3 ? "0, 0, 1'." : "0, 1'.")));
    return (1. / length) * direction;
  }



  Facet
  thin_polygon(const std::vector<Vec3> &corners)
  {
    std::vector<Vec3> all = corners;
    if (corners.size() == 2)
      {
        const Vec3 up{0., 0., norm(corners[1] - corners[0])};
        all = {corners[0] - up,
               corners[1] - up,
               corners[1] + up,
               corners[0] + up};
      }
    Facet facet{};
    facet.kind      = Facet::Kind::polygon;
    facet.n_corners = all.size();
    std::copy(all.begin(), all.end(), facet.corner);
    const Vec3 normal = cross(all[1] - all[0], all[2] - all[0]);
    facet.normal      = (1. / norm(normal)) * normal;
    return facet;
  }
} // namespace Thalweg
