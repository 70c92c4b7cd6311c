// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/interface/volume_correction.h>

#include <cmath>

#include "support/dimensions.h"
#include "support/scene.h"

using namespace Thalweg;

namespace
{
  template <typename T>
  class VolumeCorrectionMpi : public testing::Test
  {};
  TYPED_TEST_SUITE(VolumeCorrectionMpi, Dimensions);

  /// Water below y = 0.3, and another pond above y = 0.7.
  template <int dim>
  double
  two_ponds(const dealii::Point<dim> &p)
  {
    return std::min(p[1] - .3, .7 - p[1]);
  }


  /// The volumes below and above the middle.
  template <int dim>
  std::pair<double, double>
  pond_volumes(const Scene<dim> &scene, const Vector &phi)
  {
    double below = 0, above = 0;
    for (unsigned int c = 0; c < scene.mesh.graph().n_owned_cells(); ++c)
      {
        std::array<double, (1 << dim)> values;
        for (unsigned int v = 0; v < values.size(); ++v)
          values[v] = phi.local_element(scene.space->nodes(c)[v]);
        const auto &cell = scene.mesh.graph().cell(c);
        (cell.vertices[0][1] < .49 ? below : above) +=
          negative_volume<dim>(cell, values);
      }
    return {sum_of_all(below), sum_of_all(above)};
  }


  /// What is carried if each cell carries what the mesh has in it, and the
  /// lowest cells @p more of the first fluid besides.
  template <int dim>
  typename VolumeCorrection<dim>::Carried
  carried(const Scene<dim> &scene, const Vector &phi, const double more)
  {
    const auto                             &graph = scene.mesh.graph();
    typename VolumeCorrection<dim>::Carried volumes(graph.n_owned_cells());
    double                                  lowest = 0;
    for (unsigned int c = 0; c < volumes.size(); ++c)
      if (graph.cell(c).vertices[0][1] < 1e-9)
        lowest += graph.cell(c).measure;
    lowest = sum_of_all(lowest);
    for (unsigned int c = 0; c < volumes.size(); ++c)
      {
        std::array<double, (1 << dim)> values;
        for (unsigned int v = 0; v < values.size(); ++v)
          values[v] = phi.local_element(scene.space->nodes(c)[v]);
        const auto &cell = graph.cell(c);
        volumes[c][0]    = negative_volume<dim>(cell, values);
        volumes[c][1]    = cell.measure - volumes[c][0];
        if (cell.vertices[0][1] < 1e-9)
          volumes[c][0] += more * cell.measure / lowest;
      }
    return volumes;
  }
} // namespace



TYPED_TEST(VolumeCorrectionMpi, PondsExchangeNothing)
{
  constexpr int          dim = TypeParam::value;
  const Scene<dim>       scene(hanging_box<dim>(16));
  Vector                 phi = scene.scalar(two_ponds<dim>);
  const FluidBodies<dim> bodies(*scene.space, phi);
  EXPECT_EQ(bodies.size(), 3u);

  VolumeCorrection<dim> correction(*scene.space, *scene.boundary);
  const auto            before = pond_volumes(scene, phi);
  correction.apply(phi, carried(scene, phi, .01), .5 / 16);
  const auto after = pond_volumes(scene, phi);
  EXPECT_NEAR(after.first, before.first + .01, 1e-12);
  EXPECT_NEAR(after.second, before.second, 1e-14);
  EXPECT_NEAR(correction.shift(), -.01, 1e-12);
  EXPECT_NEAR(correction.debt()[0], 0., 1e-12);
}



TYPED_TEST(VolumeCorrectionMpi, WhatIsAsItIsCarriedStays)
{
  constexpr int         dim = TypeParam::value;
  const Scene<dim>      scene(hanging_box<dim>(8));
  Vector                phi    = scene.scalar(two_ponds<dim>);
  const Vector          before = phi;
  VolumeCorrection<dim> correction(*scene.space, *scene.boundary);
  correction.apply(phi, carried(scene, phi, 0.), .5 / 8);
  EXPECT_EQ(correction.shift(), 0.);
  for (unsigned int n = 0; n < phi.locally_owned_size(); ++n)
    EXPECT_EQ(phi.local_element(n), before.local_element(n));
}



TYPED_TEST(VolumeCorrectionMpi, MoreThanHalfACellIsADebt)
{
  constexpr int         dim = TypeParam::value;
  const Scene<dim>      scene(unit_box<dim>(8));
  Vector                phi = scene.scalar(two_ponds<dim>);
  VolumeCorrection<dim> correction(*scene.space, *scene.boundary);
  const auto            before = pond_volumes(scene, phi);
  correction.apply(phi, carried(scene, phi, .2), .5 / 8);
  const auto after = pond_volumes(scene, phi);
  EXPECT_NEAR(after.first, before.first + .5 / 8, 1e-12);
  EXPECT_NEAR(correction.debt()[0], .2 - .5 / 8, 1e-12);
}



TYPED_TEST(VolumeCorrectionMpi, DryStaysDryAndFullStaysFull)
{
  constexpr int    dim = TypeParam::value;
  const Scene<dim> scene(unit_box<dim>(4));
  for (const double value : {-1., 1.})
    {
      Vector phi     = scene.scalar([=](const auto &) { return value; });
      auto   volumes = carried(scene, phi, .1);
      VolumeCorrection<dim> correction(*scene.space, *scene.boundary);
      correction.apply(phi, volumes, .5 / 4);
      EXPECT_NEAR(correction.debt()[0], .1, 1e-12);
      EXPECT_EQ(correction.shift(), 0.);
      for (unsigned int n = 0; n < phi.locally_owned_size(); ++n)
        EXPECT_EQ(phi.local_element(n), value);
    }
}



TYPED_TEST(VolumeCorrectionMpi, ClosedPocketsKeepTheirVolume)
{
  // A bubble in water below air, with more air than it shows.
  constexpr int      dim = TypeParam::value;
  const Scene<dim>   scene(unit_box<dim>(32 / (dim - 1)));
  dealii::Point<dim> center;
  for (unsigned int d = 0; d < dim; ++d)
    center[d] = .5;
  center[1]         = .4;
  const auto bubble = [=](const dealii::Point<dim> &p) {
    return p.distance(center) - .2;
  };
  Vector       phi     = scene.scalar([=](const dealii::Point<dim> &p) {
    return std::max(-bubble(p), p[1] - .85);
  });
  auto         volumes = carried(scene, phi, 0.);
  const double more    = .004;
  double       inside  = 0;
  const auto  &graph   = scene.mesh.graph();
  for (unsigned int c = 0; c < volumes.size(); ++c)
    if (graph.cell(c).vertices[0][1] < .75)
      inside += volumes[c][1];
  inside = sum_of_all(inside);
  for (unsigned int c = 0; c < volumes.size(); ++c)
    if (graph.cell(c).vertices[0][1] < .75)
      volumes[c][1] *= 1. + more / inside;
  VolumeCorrection<dim> correction(*scene.space, *scene.boundary);
  correction.apply(phi, volumes, .5 * graph.minimal_extent());
  double after = 0;
  for (unsigned int c = 0; c < volumes.size(); ++c)
    if (graph.cell(c).vertices[0][1] < .75)
      {
        std::array<double, (1 << dim)> values;
        for (unsigned int v = 0; v < values.size(); ++v)
          values[v] = phi.local_element(scene.space->nodes(c)[v]);
        after +=
          graph.cell(c).measure - negative_volume<dim>(graph.cell(c), values);
      }
  // The water's own shift, which comes afterwards, moves a little of cells
  // that the pocket has grown into.
  EXPECT_NEAR(sum_of_all(after), inside + more, 1e-4 * more);
  EXPECT_NEAR(correction.debt()[0], 0., 1e-9);
}
