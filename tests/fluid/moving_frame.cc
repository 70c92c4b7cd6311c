// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/body_forces.h>

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

#include "support/complaint.h"
#include "support/files.h"
#include "support/input.h"

using namespace Thalweg;

namespace
{
  template <int dim>
  struct Frame
  {
    explicit Frame(const std::string &text, const double end = 2.)
    {
      forces.declare_parameters(Section(prm));
      prm.parse_input_from_string(text);
      forces.initialize(end);
    }

    dealii::ParameterHandler prm;
    BodyForces<dim>          forces;
  };


  std::string
  moving(const std::vector<std::string> &settings)
  {
    return section("Moving frame", settings);
  }


  std::string
  complaint(const std::vector<std::string> &settings)
  {
    return complaint_of([&]() { Frame<2>(moving(settings)); });
  }


  /// The tank's place and orientation at a time, as Rodrigues would have it.
  template <int dim>
  struct Tank
  {
    dealii::Point<dim>     center;
    dealii::Tensor<1, 3>   axis;
    dealii::Tensor<1, dim> displacement;
    double                 angle;

    dealii::Tensor<1, dim>
    turned_back(const dealii::Tensor<1, dim> &x) const
    {
      dealii::Tensor<1, 3> v;
      for (unsigned int d = 0; d < dim; ++d)
        v[d] = x[d];
      const auto result = std::cos(angle) * v -
                          std::sin(angle) * dealii::cross_product_3d(axis, v) +
                          (1. - std::cos(angle)) * (axis * v) * axis;
      dealii::Tensor<1, dim> back;
      for (unsigned int d = 0; d < dim; ++d)
        back[d] = result[d];
      return back;
    }

    /// Where a point of space is in the tank.
    dealii::Point<dim>
    in_tank(const dealii::Point<dim> &x) const
    {
      return center + turned_back(x - center - displacement);
    }
  };


  /// What moves freely in space must be seen in the tank to move as the
  /// forces say.
  template <int dim>
  void
  compare_with_free_fall(const std::string                            &text,
                         const std::function<Tank<dim>(const double)> &tank,
                         const dealii::Tensor<1, dim>                 &gravity)
  {
    Frame<dim>             frame(text);
    dealii::Point<dim>     start;
    dealii::Tensor<1, dim> speed;
    for (unsigned int d = 0; d < dim; ++d)
      {
        start[d] = .3 + .2 * d;
        speed[d] = .7 - .4 * d;
      }
    const auto place = [&](const double t) {
      return tank(t).in_tank(start + t * speed + .5 * t * t * gravity);
    };
    for (const double t : {.2, .8, 1.7})
      {
        const double                 h = 1e-4;
        const dealii::Tensor<1, dim> v =
          (place(t + h) - place(t - h)) / (2. * h);
        const dealii::Tensor<1, dim> a =
          ((place(t + h) - place(t)) - (place(t) - place(t - h))) / (h * h);
        frame.forces.set_time(t);
        const dealii::Tensor<1, dim> found =
          frame.forces.uniform_acceleration() + frame.forces.field(place(t)) -
          2. * (frame.forces.spin() * v);
        EXPECT_LT((found - a).norm(), 1e-5 * (1. + a.norm())) << t;
        EXPECT_LT(
          (frame.forces.gravity() - tank(t).turned_back(gravity)).norm(),
          1e-12);
        EXPECT_LT((frame.forces.gravity(t) - frame.forces.gravity()).norm(),
                  1e-14);
      }
  }
} // namespace



TEST(MovingFrame, SeesWhatFallsFreely)
{
  compare_with_free_fall<2>(
    moving({"Displacement = 0.2*sin(3*t); 0.1*t^3",
            "Angle = 0.5*sin(2*t) + 0.3*t^2",
            "Center = 0.4, -0.2"}) +
      section("Body forces", {"Gravity = 0.5, -9.81"}),
    [](const double t) {
      return Tank<2>{dealii::Point<2>(.4, -.2),
                     dealii::Tensor<1, 3>({0., 0., 1.}),
                     dealii::Tensor<1, 2>(
                       {.2 * std::sin(3. * t), .1 * t * t * t}),
                     .5 * std::sin(2. * t) + .3 * t * t};
    },
    dealii::Tensor<1, 2>({.5, -9.81}));
}



TEST(MovingFrame, SeesWhatFallsFreely3d)
{
  const double length = std::sqrt(1. + 4. + 4.);
  compare_with_free_fall<3>(
    moving({"Velocity = 0.6*cos(3*t); 0; -0.3",
            "Angular velocity = cos(2*t) + 0.6*t",
            "Center = 0.4, -0.2, 1",
            "Axis = 1, -2, 2"}) +
      section("Body forces", {"Gravity = 0, 1, -9.81"}),
    [length](const double t) {
      return Tank<3>{dealii::Point<3>(.4, -.2, 1.),
                     dealii::Tensor<1, 3>(
                       {1. / length, -2. / length, 2. / length}),
                     dealii::Tensor<1, 3>({.2 * std::sin(3. * t), 0., -.3 * t}),
                     .5 * std::sin(2. * t) + .3 * t * t};
    },
    dealii::Tensor<1, 3>({0., 1., -9.81}));
}



TEST(MovingFrame, TablesSayWhatExpressionsSay)
{
  const std::string path = own_path("motion.csv");
  {
    std::ofstream file(path);
    file << "# a shaken tank\nt, ax; angle\n";
    file.precision(16);
    for (unsigned int i = 0; i <= 200; ++i)
      file << .01 * i << ", " << std::sin(.06 * i) << "\t"
           << .1 * std::cos(.02 * i) << "\n";
  }
  Frame<2> table(moving({"Table = " + path}));
  Frame<2> text(moving({"Acceleration = sin(6*t); 0", "Angle = 0.1*cos(2*t)"}));
  for (const double t : {0., .005, .777, 2.})
    {
      table.forces.set_time(t);
      text.forces.set_time(t);
      EXPECT_LT((table.forces.uniform_acceleration() -
                 text.forces.uniform_acceleration())
                  .norm(),
                1e-6);
      EXPECT_LT(
        (table.forces.field({.3, .4}) - text.forces.field({.3, .4})).norm(),
        1e-4);
    }
}



TEST(MovingFrame, KnowsTheVelocityOfWhatRestsInSpace)
{
  Frame<2>   frame(moving(
    {"Velocity = 2*cos(t); 0", "Angular velocity = 3", "Center = 1, 1"}));
  const auto v = frame.forces.frame().velocity_of_space({1., 1.5});
  EXPECT_NEAR(v[0], -2. + 1.5, 1e-9);
  EXPECT_NEAR(v[1], 0., 1e-9);
  EXPECT_NE(frame.forces.frame().description().find("is in motion"),
            std::string::npos);
  EXPECT_EQ(Frame<2>("").forces.frame().description(), "");
}



TEST(MovingFrame, SaysWhatCannotBe)
{
  EXPECT_NE(complaint({"Displacement = x; 0"}).find("depends on the place"),
            std::string::npos);
  EXPECT_NE(complaint({"Displacement = 0; 0", "Velocity = 1; 0"})
              .find("'Moving frame/Velocity' both say how the tank moves"),
            std::string::npos);
  EXPECT_NE(complaint({"Angle = t", "Angular velocity = 1"})
              .find("both say how the tank turns"),
            std::string::npos);
  EXPECT_NE(complaint({"Angle = sqrt(t)"}).find("no acceleration at t = 0"),
            std::string::npos);
  EXPECT_NE(complaint({"Axis = 1, 0, 0"}).find("in two the tank turns in its"),
            std::string::npos);
}
