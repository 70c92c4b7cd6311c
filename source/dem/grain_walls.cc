// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/dem/grain_walls.h>
#include <thalweg/fields/expression.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace Thalweg
{
  namespace
  {
    /// A surface that is so much larger than the domain is in millimetres.
    constexpr double too_large = 100.;



    /// An expression of t alone.
    class TimeExpression
    {
    public:
      TimeExpression(const std::string &text,
                     const unsigned int n_components,
                     const std::string &where)
        : function(parse_expression<3>(text, n_components, where))
      {
        for (const double t : {0., .37, 1.9})
          for (unsigned int c = 0; c < n_components; ++c)
            AssertThrow(value(t, c, {}) ==
                          value(t, c, dealii::Point<3>(.3, .47, .64)),
                        dealii::ExcMessage("'" + where + " = " + text +
                                           "' depends on the place, but a wall "
                                           "moves as a whole: write a function "
                                           "of t alone."));
      }

      double
      value(const double            t,
            const unsigned int      component = 0,
            const dealii::Point<3> &place     = {}) const
      {
        function->set_time(t);
        return function->value(place, component);
      }

    private:
      std::unique_ptr<dealii::FunctionParser<3>> function;
    };



    std::function<Vec3(const double)>
    vector_of_time(const std::string &text,
                   const int          dim,
                   const std::string &where)
    {
      if (text.empty())
        return {};
      const auto expression =
        std::make_shared<TimeExpression>(text, dim, where);
      return [expression, dim](const double t) {
        return Vec3{expression->value(t, 0),
                    expression->value(t, 1),
                    dim == 3 ? expression->value(t, 2) : 0.};
      };
    }
  } // namespace



  void
  WallMotion::declare_parameters(const Section &section)
  {
    using namespace dealii::Patterns;
    section.add("Velocity",
                velocity,
                "m/s",
                "With which the wall moves: functions of t separated by "
                "semicolons; nothing: it stays.",
                Anything());
    section.add("Angular velocity",
                angular_velocity,
                "rad/s",
                "With which it turns, counter-clockwise about the axis: a "
                "function of t; nothing: it does not.",
                Anything());
    section.add(
      "Center",
      center,
      "m",
      "A point of the axis at t = 0, which moves along; nothing: that "
      "of the wall's shape.",
      List(Double()));
    section.add(
      "Axis",
      axis,
      "",
      "The direction of the axis, of any length; nothing: that of the "
      "shape. In 2D it is always the third one.",
      List(Double()));
    section.add(
      "Surface velocity",
      slide,
      "m/s",
      "With which the surface slides while the wall stays, as that of "
      "a conveyor belt: functions of t. What is at right angles to "
      "the surface does not count.",
      Anything());
    section.add("First time",
                first_time,
                "s",
                "From when on the wall is there.",
                Double(0));
    section.add("Last time",
                last_time,
                "s",
                "From when on it is no longer there; 0: it stays.",
                Double(0));
  }



  WallCourse
  WallMotion::course(const int          dim,
                     const WallShape   &shape,
                     const std::string &where) const
  {
    const std::string motion = where + "/Motion";
    WallCourse        course;
    course.velocity = vector_of_time(velocity, dim, motion + "/Velocity");
    course.slide    = vector_of_time(slide, dim, motion + "/Surface velocity");
    if (!angular_velocity.empty())
      {
        const auto expression =
          std::make_shared<TimeExpression>(angular_velocity,
                                           1,
                                           motion + "/Angular velocity");
        course.angular_velocity = [expression](const double t) {
          return expression->value(t);
        };
      }
    course.center =
      vector_of(center, dim, shape.center(dim), motion + "/Center");
    AssertThrow(dim == 3 || axis.empty(),
                dealii::ExcMessage("'" + motion +
                                   "/Axis' is for three dimensions: in two, "
                                   "walls turn in the plane."));
    const Vec3 of_shape = shape.axis(dim);
    if (axis.empty() && norm(of_shape) > 0.)
      course.axis = (1. / norm(of_shape)) * of_shape;
    else if (!axis.empty())
      course.axis = direction_of(axis, dim, motion + "/Axis");
    AssertThrow(last_time == 0. || last_time > first_time,
                dealii::ExcMessage("'" + motion +
                                   "/Last time' is not after "
                                   "'First time'."));
    if (first_time > 0.)
      course.first_time = first_time;
    if (last_time > 0.)
      course.last_time = last_time;
    return course;
  }



  void
  GrainWalls::declare_parameters(const Section &section)
  {
    section.add("Names",
                names_,
                "",
                "Walls beside the boundaries, with names of your own: `drum: "
                "cylinder, gate: polygon`. Each has a section of its name in "
                "here." +
                  Registry<WallShape>::description(),
                dealii::Patterns::Anything());
    shapes.make(section.given("Names", ""), "Walls/Names");
    for (const auto &shape : shapes)
      {
        const Section own = section.enter(shape.name);
        settings.emplace_back();
        shape.object->declare_parameters(own);
        own.add("Material",
                settings.back().material,
                "",
                "What it is made of, one of `Materials/Names`; nothing: as "
                "boundaries.",
                dealii::Patterns::Anything());
        settings.back().motion.declare_parameters(own.enter("Motion"));
      }
  }



  void
  GrainWalls::check(const int                 dim,
                    const GrainMaterials     &materials,
                    std::vector<std::string> &faults) const
  {
    auto own = settings.begin();
    for (const auto &shape : shapes)
      {
        const std::string where = "Walls/" + shape.name;
        collect_fault(faults, [&]() {
          shape.object->facets(dim, where);
          own->motion.course(dim, *shape.object, where);
        });
        collect_fault(faults, [&]() {
          if (!own->material.empty())
            materials.find(own->material, where + "/Material");
        });
        ++own;
      }
  }



  std::vector<std::string>
  GrainWalls::warnings(const int dim, const Vec3 &low, const Vec3 &high) const
  {
    std::vector<std::string> all;
    for (const auto &shape : shapes)
      {
        double farthest = 0.;
        for (const Facet &facet :
             shape.object->facets(dim, "Walls/" + shape.name))
          if (facet.kind == Facet::Kind::polygon)
            for (unsigned int c = 0; c < facet.n_corners; ++c)
              farthest =
                std::max(farthest, norm(facet.corner[c] - .5 * (low + high)));
        if (farthest > too_large * norm(high - low))
          all.push_back("The wall '" + shape.name + "' reaches " +
                        std::to_string(farthest) +
                        " m away from the middle of the domain, more than " +
                        std::to_string(static_cast<int>(too_large)) +
                        " times its size. If its file is in millimetres, set "
                        "'Walls/" +
                        shape.name + "/Scale' to 0.001.");
      }
    return all;
  }



  void
  GrainWalls::add_to(WallSet                  &walls,
                     std::vector<std::string> &names,
                     const int                 dim,
                     const GrainMaterials     &materials,
                     const unsigned int        material,
                     const double              extent) const
  {
    auto own = settings.begin();
    for (const auto &shape : shapes)
      {
        const std::string where = "Walls/" + shape.name;
        names.push_back(shape.name);
        walls.add_moving(shape.object->facets(dim, where),
                         own->motion.course(dim, *shape.object, where),
                         own->material.empty()
                           ? material
                           : materials.find(own->material, where + "/Material"),
                         extent);
        ++own;
      }
  }
} // namespace Thalweg
