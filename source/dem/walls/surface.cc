// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/dem/triangle_file.h>
#include <thalweg/dem/wall_shape.h>

namespace Thalweg
{
  namespace
  {
    /// Triangles out of a file.
    class SurfaceWall : public WallShape
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        using namespace dealii::Patterns;
        section.add("File",
                    file,
                    "",
                    "With the ending `.stl` (ASCII or binary) or `.obj`. The "
                    "surface is thin, and felt from both sides.",
                    Anything());
        section.add("Scale",
                    scale,
                    "",
                    "All coordinates in the file are multiplied by this; 0.001 "
                    "where they are in millimetres.",
                    Double(std::numeric_limits<double>::min()));
        section.add("Shift",
                    shift,
                    "m",
                    "Then all is moved by this; nothing: it stays.",
                    List(Double()));
      }

      std::vector<Facet>
      facets(const int dim, const std::string &where) const override
      {
        AssertThrow(dim == 3,
                    dealii::ExcMessage("'" + where +
                                       "' is a surface of triangles, which is "
                                       "for three dimensions: in two, write a "
                                       "'polygon'."));
        AssertThrow(!file.empty(),
                    dealii::ExcMessage("'" + where + "/File' is missing."));
        const Vec3 way = vector_of(shift, 3, {0., 0., 0.}, where + "/Shift");
        std::vector<Facet> facets;
        for (const Triangle &triangle : read_triangles(file))
          {
            std::vector<Vec3> corners;
            for (const Vec3 &corner : triangle)
              corners.push_back(way + scale * corner);
            facets.push_back(thin_polygon(corners));
          }
        return facets;
      }

    private:
      std::string         file;
      double              scale = 1.;
      std::vector<double> shift;
    };



    const Registration<WallShape, SurfaceWall> surface_wall(
      "surface",
      "triangles out of an STL or OBJ file, felt from both sides.");
  } // namespace
} // namespace Thalweg
