// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>

#include <gtest/gtest.h>

using namespace Thalweg;

namespace
{
  template <int dim>
  struct Shape
  {
    virtual ~Shape() = default;
    virtual void
    declare_parameters(const Section &)
    {}
    virtual double
    measure() const = 0;
  };

  template <int dim>
  struct Cube : public Shape<dim>
  {
    double edge = 2.;

    void
    declare_parameters(const Section &section) override
    {
      section.add("Edge", edge, "m", "Length of an edge.");
    }

    double
    measure() const override
    {
      return dim == 2 ? edge * edge : edge * edge * edge;
    }
  };

  template <int dim>
  struct Point : public Shape<dim>
  {
    double
    measure() const override
    {
      return 0.;
    }
  };

  THALWEG_REGISTER(Shape, Cube, "cube", "All edges are equal.")
  THALWEG_REGISTER(Shape, Point, "point", "No extent.")
} // namespace


TEST(Registry, ListsNamesAndTextsInBothDimensions)
{
  EXPECT_EQ(Registry<Shape<2>>::names(), "cube|point");
  EXPECT_EQ(Registry<Shape<3>>::names(), "cube|point");
  EXPECT_EQ(Registry<Shape<2>>::description(),
            "\n`cube`: All edges are equal.\n`point`: No extent.");
}


TEST(Registry, ChoiceMakesTheNamedModelWithItsParameters)
{
  dealii::ParameterHandler prm;
  Choice<Shape<3>>         shape;
  {
    const Section root(prm);
    shape.declare_parameters(root.enter("Shape"), "point", "shape");
  }
  EXPECT_EQ(shape.model_name(), "point");
  EXPECT_EQ(shape->measure(), 0.);

  prm.parse_input_from_string("subsection Shape\nset Model = cube\nend\n");
  prm.parse_input_from_string(
    "subsection Shape\nsubsection cube\nset Edge = 3\nend\nend\n");
  EXPECT_EQ(shape.model_name(), "cube");
  EXPECT_EQ((*shape).measure(), 27.);
  EXPECT_ANY_THROW(
    prm.parse_input_from_string("subsection Shape\nset Model = sphere\nend\n"));
}


TEST(Registry, ChoicesKeepTheOrderOfTheInput)
{
  dealii::ParameterHandler prm;
  Choices<Shape<2>>        shapes;
  {
    const Section root(prm);
    shapes.declare_parameters(root.enter("Shapes"), "shapes");
  }
  EXPECT_TRUE(shapes.chosen().empty());

  prm.parse_input_from_string(
    "subsection Shapes\nset Models = point, cube\nend\n");
  ASSERT_EQ(shapes.chosen().size(), 2u);
  EXPECT_EQ(shapes.chosen()[0]->measure(), 0.);
  EXPECT_EQ(shapes.chosen()[1]->measure(), 4.);
  EXPECT_ANY_THROW(prm.parse_input_from_string(
    "subsection Shapes\nset Models = point, disk\nend\n"));
}
