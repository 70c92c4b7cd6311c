// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/interface/simplex_cut.h>
#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/phase_extent.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    constexpr double nowhere = -std::numeric_limits<double>::max();


    /// The greatest sign * x[axis] on the part of the edge from @p a to @p b
    /// that lies in the band.
    template <int dim>
    double
    extent_of_edge(const dealii::Point<dim> &a,
                   const dealii::Point<dim> &b,
                   const unsigned int        axis,
                   const double              sign,
                   const Band               &band)
    {
      double       from = 0., to = 1.;
      const double start = a[band.axis];
      const double slope = b[band.axis] - start;
      if (slope == 0.)
        {
          if (start < band.lower || start > band.upper)
            return nowhere;
        }
      else
        {
          const double t0 = (band.lower - start) / slope;
          const double t1 = (band.upper - start) / slope;
          from            = std::max(from, std::min(t0, t1));
          to              = std::min(to, std::max(t0, t1));
          if (from > to)
            return nowhere;
        }
      const double length = b[axis] - a[axis];
      return std::max(sign * (a[axis] + from * length),
                      sign * (a[axis] + to * length));
    }


    /// The same over the negative part of a cell: it consists of simplices,
    /// and a linear function on a clipped simplex is greatest on its edges.
    template <int dim>
    double
    extent_of_cell(const typename CellGraph<dim>::Cell  &cell,
                   const std::array<double, (1 << dim)> &phi,
                   const unsigned int                    axis,
                   const double                          sign,
                   const Band                           &band)
    {
      double extent = nowhere;
      for (const auto &simplex : SimplexCut::divide<dim>(cell.vertices, phi))
        SimplexCut::cut(simplex, [&](const SimplexCut::Simplex<dim> &piece) {
          if (!SimplexCut::is_negative(piece))
            return;
          const auto &corners = piece.corners;
          for (unsigned int i = 0; i <= dim; ++i)
            for (unsigned int j = 0; j < i; ++j)
              extent = std::max(
                extent,
                extent_of_edge(corners[i], corners[j], axis, sign, band));
        });
      return extent;
    }
  } // namespace


  template <int dim>
  double
  phase_extent(const FlowView<dim> &solution,
               const unsigned int   axis,
               const double         sign,
               const Band          &band)
  {
    const CellGraph<dim> &graph  = solution.mesh.graph();
    double                extent = nowhere;
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto &cell  = graph.cell(c);
        double      reach = nowhere;
        for (const auto &vertex : cell.vertices)
          reach = std::max(reach, sign * vertex[axis]);
        if (reach <= extent)
          continue;
        const auto phi = cell_level_set(solution, c);
        if (*std::min_element(phi.begin(), phi.end()) < 0.)
          extent =
            std::max(extent, extent_of_cell<dim>(cell, phi, axis, sign, band));
      }
    extent = dealii::Utilities::MPI::max(
      extent, solution.mesh.triangulation().get_communicator());
    return extent == nowhere ? std::numeric_limits<double>::quiet_NaN()
                             : sign * extent;
  }


  template double
  phase_extent(const FlowView<2> &,
               const unsigned int,
               const double,
               const Band &);
  template double
  phase_extent(const FlowView<3> &,
               const unsigned int,
               const double,
               const Band &);
} // namespace Thalweg
