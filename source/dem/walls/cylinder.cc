// SPDX-License-Identifier: LGPL-2.1-or-later
// Cylinders and cones: walls that are round.
#include <thalweg/dem/wall_shape.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    using dealii::Patterns::Double;

    /// What cylinders and cones have in common.
    class RoundWall : public WallShape
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        using namespace dealii::Patterns;
        section.add("Point",
                    point,
                    "m",
                    "Where the axis begins; in 2D the middle of the circle. "
                    "Nothing: the origin.",
                    List(Double()));
        section.add("Axis",
                    axis_numbers,
                    "",
                    "The direction of the axis, of any length; not in 2D.",
                    List(Double()));
        section.add("Radius", radius, "m", "At that point.", Double(0));
        section.add(
          "Grains",
          side,
          "",
          "`inside` or `outside`: behind the wall is nothing, and "
          "what is there is pushed back; `both`: it is thin, and felt "
          "from both sides.",
          Selection("inside|outside|both"));
      }

      Vec3
      center(const int dim) const override
      {
        return vector_of(point, dim, {0., 0., 0.}, "Point");
      }

      Vec3
      axis(const int dim) const override
      {
        return dim == 2 ? Vec3{0., 0., 1.}
                        : vector_of(axis_numbers, 3, {0., 0., 1.}, "Axis");
      }

    protected:
      /// The side of a truncated cone, seen from the near and the far side.
      std::vector<Facet>
      cone(const double       end_radius,
           const double       length,
           const std::string &where) const
      {
        Facet facet{};
        facet.kind               = Facet::Kind::cone;
        facet.is_solid           = side != "both";
        facet.has_grains_outside = side == "outside";
        facet.corner[0]  = vector_of(point, 3, {0., 0., 0.}, where + "/Point");
        facet.normal     = direction_of(axis_numbers, 3, where + "/Axis");
        facet.radius     = radius;
        facet.end_radius = end_radius;
        facet.length     = length;
        std::vector<Facet> facets{facet};
        if (side != "outside")
          {
            facet.is_opposite = true;
            facets.push_back(facet);
          }
        return facets;
      }

      std::vector<double> point, axis_numbers;
      double              radius = 0.;
      std::string         side   = "inside";
    };



    class CylinderWall : public RoundWall
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        RoundWall::declare_parameters(section);
        section.add("Length",
                    length,
                    "m",
                    "From the point on; 0: it is endless.",
                    Double(0));
      }

      std::vector<Facet>
      facets(const int dim, const std::string &where) const override
      {
        AssertThrow(radius > 0.,
                    dealii::ExcMessage("'" + where +
                                       "/Radius' must be above 0."));
        AssertThrow(dim == 3 || (axis_numbers.empty() && length == 0.),
                    dealii::ExcMessage("'" + where +
                                       "' is a circle in two dimensions: leave "
                                       "out its 'Axis' and 'Length'."));
        if (length > 0.)
          return cone(radius, length, where);
        AssertThrow(side != "both",
                    dealii::ExcMessage("'" + where +
                                       "/Grains' is 'both', which is for "
                                       "cylinders with a 'Length'."));
        Facet facet{};
        facet.kind      = Facet::Kind::cylinder;
        facet.is_solid  = true;
        facet.corner[0] = vector_of(point, dim, {0., 0., 0.}, where + "/Point");
        facet.normal = dim == 3 ? direction_of(axis_numbers, 3, where + "/Axis")
                                : Vec3{0., 0., 1.};
        facet.radius = side == "inside" ? radius : -radius;
        return {facet};
      }

    private:
      double length = 0.;
    };



    class ConeWall : public RoundWall
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        RoundWall::declare_parameters(section);
        section.add("End radius", end_radius, "m", "At its end.", Double(0));
        section.add("Length", length, "m", "From the point on.", Double(0));
      }

      std::vector<Facet>
      facets(const int dim, const std::string &where) const override
      {
        AssertThrow(dim == 3,
                    dealii::ExcMessage("'" + where +
                                       "' is a cone, which is for three "
                                       "dimensions: in two, write a "
                                       "'polygon'."));
        AssertThrow(length > 0. && radius + end_radius > 0.,
                    dealii::ExcMessage("'" + where +
                                       "' needs a 'Length' above 0, and a "
                                       "'Radius' or 'End radius'."));
        return cone(end_radius, length, where);
      }

    private:
      double end_radius = 0., length = 0.;
    };



    const Registration<WallShape, CylinderWall>
      cylinder_wall("cylinder", "a cylinder, endless or not; in 2D a circle.");
    const Registration<WallShape, ConeWall>
      cone_wall("cone", "a cone or a part of one, as of a hopper.");
  } // namespace
} // namespace Thalweg
