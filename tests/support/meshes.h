// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_support_meshes_h
#define tests_support_meshes_h

#include <thalweg/mesh/mesh.h>

#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <functional>

/// Changes of a mesh that no input file can ask for.
namespace Meshes
{
  using dealii::Point;

  /// Refines the cells whose centre lies within a radius.
  template <int dim>
  void
  refine_around(Thalweg::Mesh<dim> &mesh,
                const Point<dim>   &center,
                const double        radius)
  {
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned() && cell->center().distance(center) < radius)
        cell->set_refine_flag();
    mesh.triangulation().execute_coarsening_and_refinement();
    mesh.update();
  }

  /// Moves all vertices; those of cells that are refined later follow.
  template <int dim>
  void
  transform(Thalweg::Mesh<dim>                                  &mesh,
            const std::function<Point<dim>(const Point<dim> &)> &change)
  {
    dealii::GridTools::transform(change, mesh.triangulation());
    mesh.update();
  }

  /// Bends the inner lines of the unit box.
  template <int dim>
  void
  distort(Thalweg::Mesh<dim> &mesh, const double amplitude)
  {
    transform<dim>(mesh, [&](const Point<dim> &p) {
      double bubble = amplitude;
      for (unsigned int d = 0; d < dim; ++d)
        bubble *= std::sin(dealii::numbers::PI * p[d]);
      Point<dim> q = p;
      for (unsigned int d = 0; d < dim; ++d)
        q[d] += bubble * std::cos(3. * p[(d + 1) % dim] + d);
      return q;
    });
  }

  /// Bends the inner lines of the unit box and refines one corner of it.
  template <int dim>
  void
  distort_and_refine(Thalweg::Mesh<dim> &mesh)
  {
    distort(mesh, .08);
    refine_around(mesh, Point<dim>(), .6);
  }

  /// Makes parallelograms and parallelepipeds of the cells of a box.
  template <int dim>
  void
  shear(Thalweg::Mesh<dim> &mesh)
  {
    transform<dim>(mesh, [](const Point<dim> &p) {
      Point<dim> q = p;
      q[0] += .4 * p[1];
      q[dim - 1] += .3 * p[0];
      return q;
    });
  }
} // namespace Meshes

#endif
