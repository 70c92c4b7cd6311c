// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_points_h
#define thalweg_dem_points_h

#include <thalweg/dem/vec3.h>

#include <deal.II/base/point.h>

namespace Thalweg
{
  /// Grains have three coordinates always, in two dimensions the last is zero.
  template <int dim>
  Vec3
  as_vec3(const dealii::Tensor<1, dim> &t)
  {
    return {t[0], t[1], dim == 3 ? t[dim - 1] : 0.};
  }

  template <int dim>
  dealii::Point<dim>
  as_point(const Vec3 &x)
  {
    dealii::Point<dim> p;
    p[0] = x.x;
    p[1] = x.y;
    if (dim == 3)
      p[dim - 1] = x.z;
    return p;
  }
} // namespace Thalweg

#endif
