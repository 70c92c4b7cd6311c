// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/dem/wall_shape.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// A thin plate: in two dimensions a chain of lines, in three a polygon.
    class PolygonWall : public WallShape
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        section.add("Corners",
                    corners,
                    "m",
                    "Coordinates separated by commas, corners by semicolons, "
                    "`0, 0; 0.1, 0; 0.1, 0.2`: in two dimensions of a chain of "
                    "lines, which closes where it ends with the first corner; "
                    "in three of a flat polygon without notches.",
                    dealii::Patterns::Anything());
      }

      std::vector<Facet>
      facets(const int dim, const std::string &where) const override
      {
        const std::vector<Vec3> points = read(dim, where + "/Corners");
        std::vector<Facet>      all;
        if (dim == 2)
          for (std::size_t c = 0; c + 1 < points.size(); ++c)
            all.push_back(thin_polygon({points[c], points[c + 1]}));
        else
          {
            check_polygon(points, where + "/Corners");
            for (std::size_t c = 1; c + 1 < points.size(); ++c)
              all.push_back(
                thin_polygon({points[0], points[c], points[c + 1]}));
          }
        return all;
      }

      Vec3
      center(const int dim) const override
      {
        const std::vector<Vec3> points = read(dim, "Corners");
        Vec3                    sum{0., 0., 0.};
        for (const Vec3 &point : points)
          sum += (1. / points.size()) * point;
        return sum;
      }

    private:
      std::vector<Vec3>
      read(const int dim, const std::string &where) const
      {
        using dealii::Utilities::split_string_list;
        std::vector<Vec3> points;
        for (const std::string &corner : split_string_list(corners, ';'))
          {
            std::vector<double> numbers;
            try
              {
                numbers = dealii::Utilities::string_to_double(
                  split_string_list(corner));
              }
            catch (const std::exception &)
              {
                numbers.clear();
              }
            const auto is_finite = [](const double number) {
              return std::isfinite(number);
            };
            AssertThrow(
              !numbers.empty() &&
                std::all_of(numbers.begin(), numbers.end(), is_finite),
              dealii::ExcMessage("'" + where + "' has '" + corner +
                                 "', which is no corner; write '" +
                                 (dim == 3 ? "0, 0, 0.1'." : "0, 0.1'.")));
            points.push_back(vector_of(numbers, dim, {0., 0., 0.}, where));
            AssertThrow(points.size() < 2 ||
                          norm(points.back() - points[points.size() - 2]) > 0.,
                        dealii::ExcMessage("'" + where + "' has the corner '" +
                                           corner + "' twice in a row."));
          }
        AssertThrow(points.size() >= static_cast<unsigned int>(dim),
                    dealii::ExcMessage("'" + where + "' needs " +
                                       std::to_string(dim) +
                                       " corners or more, separated by "
                                       "semicolons."));
        return points;
      }

      static void
      check_polygon(const std::vector<Vec3> &points, const std::string &where)
      {
        const std::size_t n = points.size();
        const Vec3 normal = cross(points[1] - points[0], points[2] - points[0]);
        for (std::size_t c = 0; c < n; ++c)
          {
            const Vec3 edge = points[(c + 1) % n] - points[c];
            const Vec3 next = points[(c + 2) % n] - points[(c + 1) % n];
            AssertThrow(norm(normal) > 0. &&
                          dot(cross(edge, next), normal) > 0.,
                        dealii::ExcMessage("'" + where +
                                           "' is no polygon without notches: "
                                           "give its corners one after another "
                                           "along the edge, or make it of "
                                           "several walls."));
            const double off =
              dot(points[c] - points[0], normal) / norm(normal);
            AssertThrow(std::abs(off) < 1e-9 * norm(edge),
                        dealii::ExcMessage(
                          "'" + where + "' is not flat: corner " +
                          std::to_string(c + 1) + " is " + std::to_string(off) +
                          " m away from the plane of the first three. Make it "
                          "of several walls."));
          }
      }

      std::string corners;
    };



    const Registration<WallShape, PolygonWall>
      polygon_wall("polygon",
                   "a thin plate that is felt from both sides: a chain of "
                   "lines in 2D, a flat "
                   "polygon in 3D.");
  } // namespace
} // namespace Thalweg
