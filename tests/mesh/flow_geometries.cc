// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/naca.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <gtest/gtest.h>

#include "made_geometry.h"

namespace
{
  using namespace Thalweg;

  /// The measure of the cells as @p mapping sees them, and the least ratio of
  /// Jacobians in a cell.
  template <int dim>
  std::pair<double, double>
  measure_and_quality(const dealii::Triangulation<dim> &mesh,
                      const unsigned int                degree)
  {
    const dealii::MappingQ<dim>   mapping(degree);
    const dealii::FE_Nothing<dim> element;
    const dealii::QGauss<dim>     gauss(3);
    const dealii::QIterated<dim>  lattice(dealii::QTrapezoid<1>(), 2);
    auto                          points  = gauss.get_points();
    auto                          weights = gauss.get_weights();
    for (const auto &point : lattice.get_points())
      points.push_back(point);
    weights.resize(points.size(), 0.);
    dealii::FEValues<dim>     values(mapping,
                                 element,
                                 dealii::Quadrature<dim>(points, weights),
                                 dealii::update_jacobians);
    std::pair<double, double> result(0., 1.);
    for (const auto &cell : mesh.active_cell_iterators())
      {
        values.reinit(cell);
        double least = 1e300, greatest = -1e300;
        for (unsigned int i = 0; i < points.size(); ++i)
          {
            const double jacobian = values.jacobian(i).determinant();
            result.first += jacobian * weights[i];
            least    = std::min(least, jacobian);
            greatest = std::max(greatest, jacobian);
          }
        result.second = std::min(result.second, least / greatest);
      }
    return result;
  }



  /// Refines @p made and compares areas: no cell is folded, and the errors of
  /// cells of degree two fall by more than @p order says.
  template <int dim>
  void
  expect_order(Made<dim>         &made,
               const double       exact,
               const unsigned int levels,
               const double       order,
               const double       least_ratio)
  {
    made.create();
    double before = 0.;
    for (unsigned int r = 0; r <= levels; ++r)
      {
        EXPECT_GT(measure_and_quality(made.mesh, 1).second, least_ratio) << r;
        const auto [area, ratio] = measure_and_quality(made.mesh, 2);
        EXPECT_GT(ratio, least_ratio) << r;
        const double error = std::abs(area - exact);
        // Rounding ends the convergence.
        if (r > 0 && error > 1e-12 * exact)
          {
            EXPECT_GT(std::log2(before / error), order) << r;
          }
        before = error;
        if (r < levels)
          made.mesh.refine_global();
      }
    EXPECT_LT(before, 1e-6 * exact);
  }



  /// The area between an airfoil's sides.
  double
  area_of(const Geometries::NacaOutline &outline)
  {
    using Side             = Geometries::NacaOutline::Side;
    double             sum = 0.;
    const unsigned int n   = 20000;
    for (const Side side : {Side::upper, Side::lower})
      for (unsigned int i = 0; i < n; ++i)
        {
          const auto a = outline.point(side, double(i) / n);
          const auto b = outline.point(side, (i + 1.) / n);
          sum += (side == Side::upper ? 1. : -1.) * .5 * (a[1] + b[1]) *
                 (b[0] - a[0]);
        }
    return sum;
  }
} // namespace



TEST(CylinderInChannel, FollowsTheCircleWithOrderFour)
{
  Made<2>      channel("cylinder in channel", "");
  const double exact = 2.2 * .41 - M_PI * .0025;
  expect_order(channel, exact, 4, 3.5, .25);
  for (const auto &face : channel.mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() == 6)
      {
        for (const unsigned int v : {0, 1})
          EXPECT_NEAR(face->vertex(v).distance({.2, .2}), .05, 1e-12);
      }
}


TEST(CylinderInChannel, HasNamedSidesAndFineCellsAtTheCylinder)
{
  Made<2> channel("cylinder in channel", "");
  channel.create();
  EXPECT_GE(channel.mesh.n_active_cells(), 60u);
  EXPECT_LE(channel.mesh.n_active_cells(), 130u);
  EXPECT_EQ(channel.geometry->boundary_names().size(), 5u);
  EXPECT_NEAR(channel.boundary_measure("left"), .41, 1e-12);
  EXPECT_NEAR(channel.boundary_measure("right"), .41, 1e-12);
  EXPECT_NEAR(channel.boundary_measure("bottom"), 2.2, 1e-12);
  EXPECT_NEAR(channel.boundary_measure("top"), 2.2, 1e-12);
  EXPECT_NEAR(channel.boundary_measure("cylinder"),
              8 * .1 * std::sin(M_PI / 8),
              1e-12);
  double last = 0.;
  for (const auto &cell : channel.mesh.active_cell_iterators())
    if (cell->at_boundary(1) && cell->face(1)->boundary_id() == 1)
      last = std::sqrt(cell->measure());
  // Rectangles are in the orientation in which particles are found fastest.
  for (const auto &cell : channel.mesh.active_cell_iterators())
    if (cell->center()[0] > .3)
      {
        EXPECT_NEAR(cell->vertex(1)[1], cell->vertex(0)[1], 1e-14);
        EXPECT_GT(cell->vertex(1)[0], cell->vertex(0)[0]);
      }
  const double first = .1 * std::sin(M_PI / 8);
  EXPECT_GT(last / first, 3.);
  EXPECT_LT(last / first, 4.);
}


TEST(CylinderInChannel, TakesOtherSizes)
{
  Made<2> channel("cylinder in channel",
                  "Length = 30\nHeight = 16\nCentre = 8, 8\nDiameter = 1\n"
                  "Cells around = 16\nSquare width = 3\nRing diameter = 2\n"
                  "Ring layers = 3\nStretching = 3");
  expect_order(channel, 30. * 16. - .25 * M_PI, 1, 3.5, .25);
  EXPECT_NEAR(channel.boundary_measure("top"), 30., 1e-12);
}


TEST(CylinderInChannel, IsDrawnOutIn3D)
{
  Made<3> channel("cylinder in channel", "Layers = 2");
  channel.create();
  EXPECT_EQ(channel.geometry->boundary_names().size(), 7u);
  EXPECT_NEAR(channel.boundary_measure("left"), .41 * .41, 1e-12);
  EXPECT_NEAR(channel.boundary_measure("cylinder"),
              .41 * 8 * .1 * std::sin(M_PI / 8),
              1e-12);
  EXPECT_NEAR(channel.boundary_measure("front"),
              channel.boundary_measure("back"),
              1e-12);
  channel.mesh.refine_global();
  const auto [volume, ratio] = measure_and_quality(channel.mesh, 2);
  EXPECT_NEAR(volume, .41 * (2.5 * .41 - M_PI * .0025), 1e-6);
  EXPECT_GT(ratio, .25);
  for (const auto &face : channel.mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() == 6)
      {
        for (const unsigned int v : face->vertex_indices())
          EXPECT_NEAR(std::hypot(face->vertex(v)[0] - .5,
                                 face->vertex(v)[1] - .2),
                      .05,
                      1e-12);
      }
}


TEST(CylinderInChannel, RefusesWhatCannotBe)
{
  const std::string model = "cylinder in channel";
  EXPECT_TRUE(contains(Made<2>(model, "Centre = 0.2, 0.09").error(),
                       "does not fit between y = 0 and 0.41 m"));
  EXPECT_TRUE(contains(Made<2>(model, "Square width = 5").error(),
                       "reduce 'Square width' below 4"));
  EXPECT_TRUE(contains(Made<2>(model, "Cells around = 12").error(),
                       "are 12; they must be a multiple of eight"));
  EXPECT_TRUE(
    contains(Made<2>(model, "Ring diameter = 0.9").error(), "'Ring diameter'"));
  EXPECT_TRUE(contains(Made<2>(model, "Diameter = -1").error(),
                       "'Diameter' of the geometry 'cylinder in channel' is "
                       "-1; it must be greater than zero"));
}


TEST(NacaOutline, HasTheThicknessAndFindsItsPoints)
{
  using Geometries::NacaOutline;
  const NacaOutline symmetric("0012", 2.);
  // The greatest thickness is at three tenths of the chord.
  EXPECT_NEAR(symmetric.point(NacaOutline::Side::upper, std::sqrt(.3))[1],
              .12,
              2e-4);
  const NacaOutline cambered("4412", 1.);
  for (const auto side : {NacaOutline::Side::upper, NacaOutline::Side::lower})
    for (double s = 0.; s <= 1.; s += .09)
      EXPECT_NEAR(cambered.parameter(side, cambered.point(side, s)), s, 1e-12);
  EXPECT_NEAR(cambered.point(NacaOutline::Side::lower, 1.).distance({1., 0.}),
              0.,
              1e-15);
}


TEST(Airfoil, FollowsTheOutlineWithOrderFour)
{
  for (const std::string digits : {"0012", "4412"})
    {
      Made<2> made("airfoil", "NACA = " + digits);
      made.create();
      // What the polygon far away encloses, which refinement keeps.
      double outer = 0.;
      for (const auto &face : made.mesh.active_face_iterators())
        if (face->at_boundary() && face->boundary_id() < 6)
          {
            const auto a = face->vertex(0), b = face->vertex(1);
            outer += .5 * std::abs((a[0] - 1.) * b[1] - a[1] * (b[0] - 1.));
          }
      const Geometries::NacaOutline outline(digits, 1.);
      Made<2>                       again("airfoil", "NACA = " + digits);
      // The camber's second derivative jumps within a cell.
      const double order = digits == "0012" ? 3.5 : 3.;
      expect_order(again, outer - area_of(outline), 2, order, .2);
      for (const auto &face : again.mesh.active_face_iterators())
        if (face->at_boundary() && face->boundary_id() == 6)
          for (const unsigned int v : {0, 1})
            {
              double distance = 1.;
              for (const auto side : {Geometries::NacaOutline::Side::upper,
                                      Geometries::NacaOutline::Side::lower})
                distance =
                  std::min(distance,
                           face->vertex(v).distance(outline.point(
                             side, outline.parameter(side, face->vertex(v)))));
              EXPECT_LT(distance, 1e-12);
            }
    }
}


TEST(Airfoil, IsDrawnOutIn3D)
{
  Made<3> made("airfoil", "Width = 0.5\nSpan cells = 1");
  made.create();
  EXPECT_EQ(made.geometry->boundary_names().size(), 5u);
  EXPECT_NEAR(made.boundary_measure("outflow"), 16. * .5, 1e-12);
  made.mesh.refine_global();
  EXPECT_GT(measure_and_quality(made.mesh, 2).second, .2);
  const Geometries::NacaOutline outline("0012", 1.);
  for (const auto &face : made.mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() == 6)
      for (const unsigned int v : face->vertex_indices())
        {
          const auto p = face->vertex(v);
          const auto q = outline.point(
            Geometries::NacaOutline::Side::upper,
            outline.parameter(Geometries::NacaOutline::Side::upper,
                              {p[0], std::abs(p[1])}));
          EXPECT_NEAR(q.distance({p[0], std::abs(p[1])}), 0., 1e-12);
        }
}


TEST(Airfoil, RefusesWhatCannotBe)
{
  const std::string model = "airfoil";
  for (const std::string digits : {"012", "abcd", "23012"})
    EXPECT_TRUE(contains(Made<2>(model, "NACA = " + digits).error(),
                         "is no NACA airfoil of the four-digit series"));
  EXPECT_TRUE(
    contains(Made<2>(model, "NACA = 0412").error(), "none or both are zero"));
  EXPECT_TRUE(contains(Made<2>(model, "NACA = 2400").error(), "thickness"));
  EXPECT_TRUE(contains(Made<2>(model, "Far field = 1").error(), "too small"));
  EXPECT_TRUE(
    contains(Made<2>(model, "First layer = 1").error(), "less than 0.8"));
  EXPECT_TRUE(contains(Made<2>(model, "Cells a side = 3").error(),
                       "Raise 'Cells a side'"));
}


TEST(BackwardStep, HasNamedSides)
{
  Made<2> step("backward step",
               "Step height = 0.94\nInlet height = 1\nOutlet length = 20");
  step.create();
  EXPECT_NEAR(dealii::GridTools::volume(step.mesh),
              4. + 20. * 1.94,
              1e-12 * 40.);
  EXPECT_NEAR(step.boundary_measure("left"), 1., 1e-12);
  EXPECT_NEAR(step.boundary_measure("right"), 1.94, 1e-12);
  EXPECT_NEAR(step.boundary_measure("bottom"), 20., 1e-12);
  EXPECT_NEAR(step.boundary_measure("step"), 4.94, 1e-12);
  EXPECT_NEAR(step.boundary_measure("top"), 24., 1e-12);

  Made<3> wide("backward step", "Layers = 2");
  wide.create();
  EXPECT_NEAR(wide.boundary_measure("step"), 4. * 5., 1e-12);
  EXPECT_NEAR(wide.boundary_measure("back"), 64., 1e-12);
  EXPECT_TRUE(contains(Made<2>("backward step", "Cell size = 0").error(),
                       "'Cell size' of the geometry 'backward step' is 0"));
}


TEST(Cavity, HasALidAndCellsDrawnToTheSides)
{
  Made<2> cavity("cavity", "Repetitions = 8, 4\nGrading = 1.5");
  cavity.create();
  EXPECT_EQ(cavity.mesh.n_active_cells(), 32u);
  EXPECT_EQ(cavity.geometry->boundary_names().size(), 2u);
  EXPECT_NEAR(cavity.boundary_measure("lid"), 1., 1e-12);
  EXPECT_NEAR(cavity.boundary_measure("walls"), 3., 1e-12);
  double least = 1., greatest = 0.;
  for (const auto &cell : cavity.mesh.active_cell_iterators())
    {
      least    = std::min(least, cell->extent_in_direction(0));
      greatest = std::max(greatest, cell->extent_in_direction(0));
    }
  EXPECT_NEAR(least, .5 * (1. - std::tanh(1.125) / std::tanh(1.5)), 1e-12);
  EXPECT_GT(greatest, 2.5 * least);

  Made<3> even("cavity", "Size = 1, 2, 3");
  even.create();
  EXPECT_NEAR(even.boundary_measure("lid"), 3., 1e-12);
  EXPECT_NEAR(even.boundary_measure("front"), 2., 1e-12);
  for (const auto &cell : even.mesh.active_cell_iterators())
    EXPECT_NEAR(cell->extent_in_direction(1), .5, 1e-12);
  EXPECT_TRUE(
    contains(Made<2>("cavity", "Size = 1, 0").error(), "The cavity from"));
}


TEST(FlowGeometriesMpi, AreDistributedWithTheirManifolds)
{
  for (const std::string model :
       {"cylinder in channel", "airfoil", "backward step", "cavity"})
    {
      Made<2>                                         made(model, "");
      dealii::parallel::distributed::Triangulation<2> mesh(MPI_COMM_WORLD);
      made.geometry->create(mesh);
      const auto n = mesh.n_global_active_cells();
      mesh.refine_global(2);
      EXPECT_EQ(mesh.n_global_active_cells(), 16 * n) << model;
      if (model == "cylinder in channel")
        for (const auto &cell : mesh.active_cell_iterators())
          if (!cell->is_artificial())
            for (const auto &face : cell->face_iterators())
              if (face->at_boundary() && face->boundary_id() == 6)
                {
                  EXPECT_NEAR(face->vertex(0).distance({.2, .2}), .05, 1e-12);
                }
    }
}
