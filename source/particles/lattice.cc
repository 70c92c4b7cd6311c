// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/particles/lattice.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    /// Beyond this nobody has the memory.
    constexpr double most_points = 1e12;
  } // namespace



  template <int dim>
  Lattice<dim>::Lattice(const Mesh<dim> &mesh, const double spacing)
    : mesh(mesh)
    , spacing(spacing)
  {
    const auto &[lower, upper] = mesh.box();
    double n                   = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      n *= std::ceil((upper[d] - lower[d]) / spacing);
    std::ostringstream message;
    message << "A lattice with a spacing of " << spacing << " m has " << n
            << " points in the domain, which reaches " << mesh.extent()
            << ". Write a greater spacing.";
    AssertThrow(n <= most_points, dealii::ExcMessage(message.str()));
    for (unsigned int d = 0; d < dim; ++d)
      {
        n_along[d] = std::ceil((upper[d] - lower[d]) / spacing);
        n_all *= n_along[d];
      }
  }



  template <int dim>
  void
  Lattice<dim>::visit(const unsigned int   cell,
                      const CellMaps<dim> &maps,
                      const Range         &begin,
                      const Range         &end,
                      const Action        &action) const
  {
    const dealii::Point<dim> &lower    = mesh.box().first;
    const auto               &geometry = mesh.graph().cell(cell);
    for (Range i = begin; i[dim - 1] < end[dim - 1];)
      {
        dealii::Point<dim> place;
        std::uint64_t      number = 0, stride = 1;
        for (unsigned int d = 0; d < dim; ++d)
          {
            place[d] = lower[d] + (i[d] + .5) * spacing;
            number += stride * i[d];
            stride *= n_along[d];
          }
        std::array<double, dim> reference;
        bool is_inside = maps.to_reference(cell, {place, {}, {}}, reference);
        for (unsigned int d = 0; d < dim && is_inside; ++d)
          is_inside = geometry.axis_parallel
                        ? place[d] >= geometry.vertices.front()[d] &&
                            place[d] < geometry.vertices.back()[d]
                        : reference[d] >= 0. && reference[d] < 1.;
        if (is_inside)
          {
            dealii::Point<dim> xi;
            for (unsigned int d = 0; d < dim; ++d)
              xi[d] = reference[d];
            action(cell, xi, place, number);
          }
        ++i[0];
        for (unsigned int d = 0; d + 1 < dim && i[d] >= end[d]; ++d)
          {
            i[d] = begin[d];
            ++i[d + 1];
          }
      }
  }



  template <int dim>
  void
  Lattice<dim>::for_each_point(const Action &action) const
  {
    const dealii::Point<dim> &lower = mesh.box().first;
    const CellGraph<dim>     &graph = mesh.graph();
    const CellMaps<dim>       maps(graph);
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto &vertices = graph.cell(c).vertices;
        Range       begin, end;
        bool        is_empty = false;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const auto [least, greatest] =
              std::minmax_element(vertices.begin(),
                                  vertices.end(),
                                  [d](const auto &a, const auto &b) {
                                    return a[d] < b[d];
                                  });
            // One more on both sides, for round-off.
            begin[d] = std::max<std::int64_t>(
              0, std::floor(((*least)[d] - lower[d]) / spacing - .5));
            end[d] = std::min<std::int64_t>(
              n_along[d],
              std::ceil(((*greatest)[d] - lower[d]) / spacing - .5) + 1);
            is_empty |= begin[d] >= end[d];
          }
        if (!is_empty)
          visit(c, maps, begin, end, action);
      }
  }



  THALWEG_INSTANTIATE(Lattice)
} // namespace Thalweg
