// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/dem/boundary_facets.h>
#include <thalweg/dem/triangle_file.h>
#include <thalweg/dem/wall_shape.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <gtest/gtest.h>

#include "dem/grain_scene.h"
#include "particles/setup.h"
#include "support/dimensions.h"
#include "support/files.h"

using namespace Thalweg;

namespace
{
  constexpr double r = 1e-3;

  /// The square from -1 cm to 1 cm at z = 0 as 2 n^2 triangles of one wall.
  void
  add_square(GrainScene &scene, const unsigned int n, const bool is_thin = true)
  {
    const auto triangle = [&](const Vec3 &a, const Vec3 &b, const Vec3 &c) {
      return is_thin ? thin_polygon({a, b, c})
                     : make_polygon({a, b, c}, a + Vec3{0., 0., 1.});
    };
    const double side = .02 / n;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        {
          const Vec3 a{-.01 + i * side, -.01 + j * side, 0.};
          const Vec3 x{side, 0., 0.}, y{0., side, 0.};
          scene.add_facet(triangle(a, a + x, a + x + y), i + j == 0 ? -1 : 0);
          scene.add_facet(triangle(a, a + x + y, a + y), 0);
        }
  }

  /// A grain that hits the plane z = 0 obliquely at (x, y), after the impact.
  template <typename Walls>
  GrainRecord
  bounce(const double x, const double y, const Walls &add_walls)
  {
    GrainScene scene("linear",
                     GrainScene::material(.7, .4),
                     "set Normal stiffness = 1000");
    add_walls(scene);
    const double dt = 2e-6;
    const Vec3   v{.11, -.07, -.3};
    const double time = 10.5 * dt;
    scene.add_grain(Vec3{x, y, r} - time * v, r, v, {30., 5., -20.});
    scene.begin();
    scene.advance(250, dt, {0., 0., -9.81});
    return scene.grain(0);
  }

  void
  expect_equal(const GrainRecord &a,
               const GrainRecord &b,
               const double       tolerance)
  {
    EXPECT_LT(norm(a.x - b.x), tolerance * r);
    EXPECT_LT(norm(a.v - b.v), tolerance * .3);
    EXPECT_LT(norm(a.w - b.w), tolerance * 300.);
  }

  const auto plane = [](GrainScene &scene) {
    scene.add_plane({0., 0., 0.}, {0., 0., 1.});
  };
} // namespace



TEST(GrainWalls, ImpactsAreTheSameOnAPlaneAndOnAnyTriangles)
{
  for (const auto &[x, y] : std::vector<std::pair<double, double>>{
         {.0031, .0017}, {0., 0.}, {.002, .0011}, {.002, .002}})
    {
      const GrainRecord expected = bounce(x, y, plane);
      for (const bool is_thin : {false, true})
        for (const unsigned int n : {1u, 10u, 100u})
          expect_equal(expected,
                       bounce(x,
                              y,
                              [&](GrainScene &scene) {
                                add_square(scene, n, is_thin);
                              }),
                       1e-12);
    }
}



TEST(GrainWalls, ABallKeepsItsVelocityWhileItRollsOverTriangles)
{
  GrainScene scene("linear",
                   GrainScene::material(.5, .5),
                   "set Normal stiffness = 1000");
  add_square(scene, 20);
  const double mass = 2500. * 4. / 3. * M_PI * r * r * r;
  scene.add_grain({-.008, -.0061, r - mass * 9.81 / 1000.},
                  r,
                  {.1, .07, 0.},
                  {-70., 100., 0.});
  scene.begin();
  // The spring takes up what little slip the overlap makes.
  scene.advance(2000, 1e-5, {0., 0., -9.81});
  const GrainRecord before = scene.grain(0);
  scene.advance(9000, 1e-5, {0., 0., -9.81});
  const GrainRecord after = scene.grain(0);
  EXPECT_GT(norm(after.x - before.x), .009);
  EXPECT_LT(norm(after.v - before.v), 1e-10 * norm(before.v));
}



TEST(GrainWalls, CornersAreTouchedTwoOrThreeTimesAndConvexEdgesOnce)
{
  const Vec3 nothing{0., 0., 0.};
  const Wall wall{nothing, nothing, nothing, 0, true};
  const auto n_touches = [&](const std::vector<Facet> &facets, const Vec3 &x) {
    std::vector<std::uint32_t> all(facets.size());
    for (std::uint32_t f = 0; f < all.size(); ++f)
      all[f] = f;
    FacetTouch touches[most_touches];
    return visible_touches(
      facets.data(), &wall, all.data(), all.size(), {x, r}, touches);
  };
  const double       L = .01;
  const Vec3         inside{.5 * L, .5 * L, .5 * L};
  std::vector<Facet> corner{
    make_polygon({{0., 0., 0.}, {L, 0., 0.}, {L, L, 0.}, {0., L, 0.}}, inside),
    make_polygon({{0., 0., 0.}, {0., L, 0.}, {0., L, L}, {0., 0., L}}, inside),
    make_polygon({{0., 0., 0.}, {L, 0., 0.}, {L, 0., L}, {0., 0., L}}, inside)};
  EXPECT_EQ(n_touches(corner, {.9 * r, .9 * r, .9 * r}), 3u);
  EXPECT_EQ(n_touches(corner, {.9 * r, .9 * r, 2. * r}), 2u);
  EXPECT_EQ(n_touches(corner, {.9 * r, 2. * r, 2. * r}), 1u);
  EXPECT_EQ(n_touches(corner, {2. * r, 2. * r, 2. * r}), 0u);
  // Seen from behind, the edges and the vertex are convex.
  for (Facet &facet : corner)
    facet.is_solid = false;
  EXPECT_EQ(n_touches(corner, {-.5 * r, .5 * L, -.5 * r}), 1u);
  EXPECT_EQ(n_touches(corner, {-.5 * r, -.5 * r, -.5 * r}), 1u);
  // A thin plate is felt from both sides, and beside it nothing is.
  const std::vector<Facet> plate{corner[0]};
  EXPECT_EQ(n_touches(plate, {.5 * L, .5 * L, .9 * r}), 1u);
  EXPECT_EQ(n_touches(plate, {.5 * L, .5 * L, -.9 * r}), 1u);
  EXPECT_EQ(n_touches(plate, {-1.1 * r, .5 * L, 0.}), 0u);
  EXPECT_EQ(n_touches(plate, {-.8 * r, .5 * L, .8 * r}), 0u);
  EXPECT_EQ(n_touches(plate, {-.8 * r, .5 * L, .1 * r}), 1u);
}



TEST(GrainWalls, ConesAreTouchedAtTheNearestPointOfTheirLines)
{
  const Vec3 nothing{0., 0., 0.};
  const Wall wall{nothing, nothing, nothing, 0, true};
  // From a radius of 1 cm at z = 0 to one of 2 cm at z = 1 cm.
  Facet cone{};
  cone.kind        = Facet::Kind::cone;
  cone.normal      = {0., 0., 1.};
  cone.radius      = .01;
  cone.end_radius  = .02;
  cone.length      = .01;
  const auto touch = [&](const Vec3 &x, FacetTouch *touches) {
    std::vector<Facet> facets{cone, cone};
    facets[1].is_opposite = true;
    const std::uint32_t all[]{0, 1};
    return visible_touches(facets.data(), &wall, all, 2, {x, r}, touches);
  };
  FacetTouch   touches[most_touches];
  const double root = std::sqrt(.5), height = .7 * r;
  // In front of the middle of a line, inside and outside.
  for (const double side : {1., -1.})
    {
      const Vec3 x =
        Vec3{0., .015, .005} + (side * height * root) * Vec3{0., -1., 1.};
      EXPECT_NEAR(distance_from(cone, x), height, 1e-15);
      ASSERT_EQ(touch(x, touches), 1u);
      EXPECT_NEAR(touches[0].overlap, r - height, 1e-15);
      EXPECT_NEAR(touches[0].normal.y, -side * root, 1e-12);
      EXPECT_NEAR(touches[0].normal.z, side * root, 1e-12);
    }
  // Below its end, and where nothing is.
  ASSERT_EQ(touch({.01, 0., -height}, touches), 1u);
  EXPECT_NEAR(touches[0].normal.z, -1., 1e-12);
  EXPECT_EQ(touch({0., 0., .005}, touches), 0u);
  EXPECT_EQ(touch({0., .01, -1.1 * r}, touches), 0u);
  // A narrow one holds a grain on its axis from both sides.
  cone.radius     = 0.;
  cone.end_radius = .01;
  ASSERT_EQ(touch({0., 0., r}, touches), 2u);
  EXPECT_NEAR(touches[0].overlap, r * (1. - root), 1e-15);
  EXPECT_NEAR(norm(touches[0].normal + touches[1].normal -
                   Vec3{0., 0., 2. * root}),
              0.,
              1e-12);
}



TEST(GrainWalls, SurfacesAreReadFromFilesAndRefusedWithAReason)
{
  const std::string path = own_path("surface");
  const auto        read = [&](const std::string &ending,
                        const std::string &text) -> std::string {
    const std::string name = path + ending;
    std::ofstream(name, std::ios::binary) << text;
    std::string complaint;
    try
      {
        complaint = std::to_string(read_triangles(name).size());
      }
    catch (const dealii::ExceptionBase &exception)
      {
        complaint = message_of(exception);
      }
    std::remove(name.c_str());
    return complaint;
  };
  const auto expect = [&](const std::string &ending,
                          const std::string &text,
                          const std::string &answer) {
    EXPECT_NE(read(ending, text).find(answer), std::string::npos)
      << read(ending, text);
  };
  const std::string facet = "facet normal 0 0 0\nouter loop\nvertex 0 0 0\n"
                            "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  expect(".stl", "solid a b\n" + facet + facet + "endsolid a\n", "2");
  expect(".STL", "solid\n" + facet, "is it complete?");
  expect(".stl",
         "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 nan 0",
         "finite");
  expect(".stl", "solid\nendsolid\n", "no triangle with an area");
  expect(".stl", "", "is empty");
  expect(".ply", "ply", "'.stl' or '.obj'");
  std::string binary(84, ' ');
  const char  n[]{2, 0, 0, 0};
  const float numbers[12]{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::string one(50, '\0');
  binary.replace(80, 4, n, 4);
  one.replace(0, 48, reinterpret_cast<const char *>(numbers), 48);
  expect(".stl", binary + one + one, "2");
  expect(".stl", binary + one, "134 bytes, and 2 triangles need 184");
  expect(".stl", "short", "is it complete?");
  const std::string vertices = "# a\nv 0 0 0\nv 1 0 0 1\nv 1 1 0\nv 0 1 0\n";
  expect(".obj", vertices + "vn 0 0 1\nf 1/1 2/2 3 4//1\nf -1 -2 -3", "3");
  expect(".obj", vertices + "f 1 2 5\n", "'5' of a face is none of the 4");
  expect(".obj", vertices + "f 1 2\n", "fewer than three");
}



template <typename Dimension>
class GrainBoundaryMpi : public testing::Test
{};
TYPED_TEST_SUITE(GrainBoundaryMpi, Dimensions);

TYPED_TEST(GrainBoundaryMpi, ABoxHasAsManyFacetsAsSidesWhateverItsCells)
{
  constexpr int dim = TypeParam::value;
  for (const unsigned int n : {1u, 3u})
    for (const bool has_hanging_nodes : {false, true})
      {
        Mesh<dim> mesh(MPI_COMM_WORLD);
        ParticleTest::make_box(mesh, n);
        if (has_hanging_nodes)
          Meshes::refine_around(mesh, dealii::Point<dim>(), .6);
        const auto facets = boundary_facets(mesh);
        EXPECT_EQ(facets.size(), 2u * dim) << n;
        for (const auto &[facet, id] : facets)
          {
            const Vec3 middle{.5, .5, dim == 3 ? .5 : 0.};
            EXPECT_NEAR(dot(middle - facet.corner[0], facet.normal), .5, 1e-15);
          }
      }
}
