// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_interface_cut_cells_h
#define tests_interface_cut_cells_h

#include <thalweg/interface/cut_cell.h>

#include <cmath>

#include "support/meshes.h"
#include "support/scene.h"

namespace CutCells
{
  using namespace Thalweg;

  constexpr double rho[2] = {1000., 2.};
  constexpr double mu[2]  = {5., .1};

  /// A plane with positive slopes.
  template <int dim>
  struct Plane
  {
    dealii::Tensor<1, dim> slope;
    double                 level;

    double
    operator()(const dealii::Point<dim> &x) const
    {
      return slope * x - level;
    }

    /// The part of a cube with edges @p h and least corner @p corner where
    /// this is negative: signed corner volumes beyond each vertex.
    double
    fraction(const dealii::Point<dim> &corner, const double h) const
    {
      double sum = 0, factor = 1.;
      for (unsigned int v = 0; v < (1u << dim); ++v)
        {
          double rest = -(*this)(corner), sign = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            if ((v >> d) & 1u)
              {
                rest -= h * slope[d];
                sign = -sign;
              }
          sum += sign * std::pow(std::max(rest, 0.), dim);
        }
      for (unsigned int d = 0; d < dim; ++d)
        factor *= (d + 1) * h * slope[d];
      return sum / factor;
    }
  };


  template <int dim>
  Plane<dim>
  tilted(const double level)
  {
    Plane<dim> plane;
    for (unsigned int d = 0; d < dim; ++d)
      plane.slope[d] = .4 + .3 * d;
    plane.slope /= plane.slope.norm();
    plane.level = level;
    return plane;
  }


  /// A scene with one cell, or some bent ones, and two fluids.
  template <int dim>
  struct Cells : Scene<dim>
  {
    explicit Cells(const unsigned int n = 1, const bool bent = false)
      : Scene<dim>(unit_box<dim>(n) + two_fluids(rho[0], rho[1], mu[0], mu[1]),
                   bent ? typename Scene<dim>::MeshChange(
                            [](auto &mesh) { Meshes::distort(mesh, .1); })
                        : typename Scene<dim>::MeshChange())
    {}

    const typename CellGraph<dim>::Cell &
    cell(const unsigned int index = 0) const
    {
      return this->mesh.graph().cell(index);
    }

    template <typename Function>
    std::array<double, (1 << dim)>
    nodal(const Function &function, const unsigned int index = 0) const
    {
      std::array<double, (1 << dim)> values;
      for (unsigned int v = 0; v < values.size(); ++v)
        values[v] = function(cell(index).vertices[v]);
      return values;
    }

    CutCell<dim>
    cut(const Plane<dim> &plane, const unsigned int index = 0) const
    {
      return integrate_cut_cell<dim>(
        index,
        cell(index),
        nodal(plane, index),
        nodal([&](const auto &x) { return std::abs(plane(x)); }, index),
        1.,
        this->fluids,
        PressureEnrichment::gradient);
    }
  };


  /// The enrichment with the same factor at all nodes: psi itself.
  template <int dim>
  struct Enrichment
  {
    template <typename T>
    static T
    sum(const std::array<T, (1 << dim)> &parts)
    {
      T result{};
      for (const T &part : parts)
        result += part;
      return result;
    }

    static double
    stiffness(const CutCell<dim> &cut)
    {
      double result = 0;
      for (const auto &row : cut.laplace_star_star)
        result += sum(row);
      return result;
    }
  };


  /// A plane normal to the last axis, at @p height.
  template <int dim>
  Plane<dim>
  flat(const double height)
  {
    Plane<dim> plane;
    plane.slope[dim - 1] = 1.;
    plane.level          = height;
    return plane;
  }

  /// Whether vertex @p v is one of the upper ones.
  template <int dim>
  bool
  is_upper(const unsigned int v)
  {
    return (v >> (dim - 1)) & 1u;
  }
} // namespace CutCells

#endif
