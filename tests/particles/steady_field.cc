// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/particles/cell_maps.h>
#include <thalweg/particles/steady_field.h>

#include <gtest/gtest.h>
#include <random>

#include "setup.h"

using namespace ParticleTest;
using Thalweg::VelocityShape;

namespace
{
  /// The rates of the reference coordinates along a field.
  template <int dim>
  struct Rates
  {
    using Coordinates = std::array<double, dim>;

    const Thalweg::CellGraph<dim>  &graph;
    const Thalweg::CellMaps<dim>    maps;
    const Thalweg::SteadyField<dim> field;

    Rates(const Thalweg::CellGraph<dim>    &graph,
          const Thalweg::CellVelocity<dim> &velocity,
          const VelocityShape               shape)
      : graph(graph)
      , maps(graph)
      , field(graph, velocity, .5, 1., shape)
    {}

    double
    stretch(const unsigned int cell, const Coordinates &x) const
    {
      return graph.cell(cell).axis_parallel
               ? 1.
               : determinant(maps.jacobian(cell, x));
    }

    Coordinates
    operator()(const unsigned int cell, const Coordinates &x) const
    {
      const auto walker =
        Thalweg::Walker<dim>::start(cell, dealii::Point<dim>(), 1.);
      Coordinates rate = field.velocity(walker, x, 0.);
      if (!graph.cell(cell).axis_parallel)
        rate =
          Thalweg::CellPolynomial::solve<dim>(maps.jacobian(cell, x), rate);
      field.add_bubbles(walker, x, stretch(cell, x), rate);
      return rate;
    }

    /// The divergence in the reference cell, by central differences that are
    /// exact for what is quadratic in each coordinate.
    double
    divergence(const unsigned int cell, const Coordinates &x) const
    {
      constexpr double h   = .01;
      double           sum = 0;
      for (unsigned int d = 0; d < dim; ++d)
        for (const double side : {-1., 1.})
          {
            Coordinates y = x;
            y[d] += side * h;
            sum += side * (*this)(cell, y)[d] * stretch(cell, y) / (2. * h);
          }
      return sum;
    }
  };


  template <int dim>
  Thalweg::CellVelocity<dim>
  random_velocity(const Thalweg::Mesh<dim> &mesh)
  {
    std::mt19937                           generator(7);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    Thalweg::CellVelocity<dim>             velocity(mesh.graph().n_cells());
    for (auto &cell : velocity)
      for (double &value : cell)
        value = uniform(generator);
    return velocity;
  }


  /// Both go with the same random velocity.
  template <int dim>
  struct BothShapes
  {
    explicit BothShapes(const Thalweg::Mesh<dim> &mesh)
      : even(mesh.graph(),
             random_velocity(mesh),
             VelocityShape::evenly_divergent)
      , plain(mesh.graph(), random_velocity(mesh), VelocityShape::multilinear)
    {}

    const Rates<dim> even, plain;
  };


  template <int dim>
  std::array<double, dim>
  point(const double x, const double y, [[maybe_unused]] const double z)
  {
    if constexpr (dim == 2)
      return {{x, y}};
    else
      return {{x, y, z}};
  }


  template <int dim>
  void
  check_divergence(const Thalweg::Mesh<dim> &mesh)
  {
    const auto &[even, plain] = BothShapes<dim>(mesh);
    for (unsigned int cell = 0; cell < mesh.graph().n_cells(); ++cell)
      {
        const double mean = even.divergence(cell, point<dim>(.5, .5, .5));
        // What flows out is as it was.
        EXPECT_NEAR(mean,
                    plain.divergence(cell, point<dim>(.5, .5, .5)),
                    1e-9 * (1. + std::abs(mean)));
        for (const auto &x : {point<dim>(.1, .2, .3),
                              point<dim>(.9, .1, .6),
                              point<dim>(.3, .8, .9)})
          EXPECT_NEAR(even.divergence(cell, x),
                      mean,
                      1e-9 * (1. + std::abs(mean)));
      }
  }


  /// Nothing more goes through any face.
  template <int dim>
  void
  check_faces(const Thalweg::Mesh<dim> &mesh)
  {
    const auto &[even, plain] = BothShapes<dim>(mesh);
    for (unsigned int cell = 0; cell < mesh.graph().n_cells(); ++cell)
      for (unsigned int d = 0; d < dim; ++d)
        for (const double side : {0., 1.})
          {
            auto x = point<dim>(.3, .4, .7);
            x[d]   = side;
            EXPECT_EQ(even(cell, x)[d], plain(cell, x)[d]);
          }
  }
} // namespace


TEST(SteadyField, IsEvenlyDivergentInBoxes)
{
  Thalweg::Mesh<2> mesh_2d(MPI_COMM_WORLD);
  make_box(mesh_2d, 3);
  refine_around(mesh_2d, Point<2>(.2, .2), .3);
  check_divergence(mesh_2d);
  check_faces(mesh_2d);
  Thalweg::Mesh<3> mesh_3d(MPI_COMM_WORLD);
  make_box(mesh_3d, 2);
  check_divergence(mesh_3d);
  check_faces(mesh_3d);
}


TEST(SteadyField, IsEvenlyDivergentInGeneralQuadrilaterals)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 4);
  distort(mesh, .2);
  check_divergence(mesh);
  check_faces(mesh);
}


TEST(SteadyField, IsEvenlyDivergentInParallelepipeds)
{
  Thalweg::Mesh<3> mesh(MPI_COMM_WORLD);
  make_box(mesh, 2);
  Meshes::shear(mesh);
  check_divergence(mesh);
  check_faces(mesh);
}


TEST(SteadyField, HasNoDivergenceWhereNothingFlowsOut)
{
  Thalweg::Mesh<2> mesh(MPI_COMM_WORLD);
  make_box(mesh, 1);
  Thalweg::CellVelocity<2> velocity(1);
  // u = x (1 - 2 y), v = y (1 - 2 x)
  const std::array<double, 8> nodal{{0., 0., 1., 0., 0., 1., -1., -1.}};
  std::copy(nodal.begin(), nodal.end(), velocity[0].begin());
  const Rates<2> even(mesh.graph(), velocity, VelocityShape::evenly_divergent),
    plain(mesh.graph(), velocity, VelocityShape::multilinear);
  EXPECT_NEAR(even.divergence(0, {{.5, .5}}), 0., 1e-10);
  EXPECT_NEAR(even.divergence(0, {{.9, .9}}), 0., 1e-10);
  EXPECT_NEAR(plain.divergence(0, {{.9, .9}}), -1.6, 1e-10);
}
