// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/dem/wall_shape.h>

namespace Thalweg
{
  namespace
  {
    /// An endless plane with grains in front of it.
    class PlaneWall : public WallShape
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        using namespace dealii::Patterns;
        section.add("Point",
                    point,
                    "m",
                    "One of the plane; nothing: the origin.",
                    List(Double()));
        section.add("Normal",
                    normal,
                    "",
                    "The direction in which grains are, of any length.",
                    List(Double()));
      }

      std::vector<Facet>
      facets(const int dim, const std::string &where) const override
      {
        Facet facet{};
        facet.kind      = Facet::Kind::plane;
        facet.is_solid  = true;
        facet.corner[0] = vector_of(point, dim, {0., 0., 0.}, where + "/Point");
        facet.normal    = direction_of(normal, dim, where + "/Normal");
        return {facet};
      }

      Vec3
      center(const int dim) const override
      {
        return vector_of(point, dim, {0., 0., 0.}, "Point");
      }

    private:
      std::vector<double> point, normal;
    };



    const Registration<WallShape, PlaneWall>
      plane_wall("plane", "an endless plane with grains on one side.");
  } // namespace
} // namespace Thalweg
