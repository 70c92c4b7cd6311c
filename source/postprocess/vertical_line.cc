// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/q1_cell.h>
#include <thalweg/interface/simplex_cut.h>
#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/vertical_line.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace Thalweg
{
  namespace
  {
    /// The barycentric coordinates in a simplex are linear along the line:
    /// at(s) = value + s * slope.
    template <int dim>
    struct LineInSimplex
    {
      std::array<double, dim + 1> value;
      std::array<double, dim + 1> slope;
    };


    template <int dim>
    LineInSimplex<dim>
    enter(const std::array<dealii::Point<dim>, dim + 1> &corners,
          const dealii::Point<dim>                      &origin,
          const unsigned int                             axis)
    {
      dealii::Tensor<2, dim> edges;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int d = 0; d < dim; ++d)
          edges[d][i] = corners[i + 1][d] - corners[0][d];
      const dealii::Tensor<2, dim> inverse = invert(edges);
      const dealii::Tensor<1, dim> start   = inverse * (origin - corners[0]);
      LineInSimplex<dim>           line;
      line.value[0] = 1.;
      line.slope[0] = 0.;
      for (unsigned int i = 0; i < dim; ++i)
        {
          line.value[i + 1] = start[i];
          line.slope[i + 1] = inverse[i][axis];
          line.value[0] -= start[i];
          line.slope[0] -= inverse[i][axis];
        }
      return line;
    }


    /// Restricts [from, to] to where value + s * slope >= 0.
    void
    restrict_to_positive(const double value,
                         const double slope,
                         double      &from,
                         double      &to)
    {
      if (slope > 0.)
        from = std::max(from, -value / slope);
      else if (slope < 0.)
        to = std::min(to, -value / slope);
      else if (value < 0.)
        to = from - 1.;
    }


    /// Adds what the line through @p origin meets in one simplex.
    template <int dim>
    void
    add_simplex(const typename CellGraph<dim>::Cell &cell,
                const SimplexCut::Simplex<dim>      &simplex,
                const dealii::Point<dim>            &origin,
                const unsigned int                   axis,
                LineContent                         &content)
    {
      std::array<dealii::Point<dim>, dim + 1> corners;
      double from = std::numeric_limits<double>::max();
      double to   = -from;
      for (unsigned int i = 0; i <= dim; ++i)
        {
          corners[i] = Q1::position<dim>(cell.vertices, simplex.corners[i]);
          from       = std::min(from, corners[i][axis] - origin[axis]);
          to         = std::max(to, corners[i][axis] - origin[axis]);
        }
      const auto line = enter<dim>(corners, origin, axis);
      double     phi = 0., phi_slope = 0.;
      for (unsigned int i = 0; i <= dim; ++i)
        {
          restrict_to_positive(line.value[i], line.slope[i], from, to);
          phi += line.value[i] * simplex.phi[i];
          phi_slope += line.slope[i] * simplex.phi[i];
        }
      if (from >= to)
        return;
      content.length += to - from;
      restrict_to_positive(-phi, -phi_slope, from, to);
      if (from >= to)
        return;
      content.wet_length += to - from;
      content.top = std::max(content.top, origin[axis] + to);
    }


    /// The level set at the vertices of a cell of the graph.
    template <int dim>
    using CellLevelSet =
      std::function<std::array<double, (1 << dim)>(const unsigned int)>;


    /// The line through exactly @p origin.
    template <int dim>
    LineContent
    cut_shifted_line(const Mesh<dim>          &mesh,
                     const CellLevelSet<dim>  &level_set,
                     const dealii::Point<dim> &origin,
                     const unsigned int        axis)
    {
      const CellGraph<dim> &graph = mesh.graph();
      LineContent           content;
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        {
          const auto &cell  = graph.cell(c);
          bool        meets = true;
          for (unsigned int d = 0; d < dim; ++d)
            if (d != axis)
              {
                double lower = cell.vertices[0][d], upper = lower;
                for (const auto &vertex : cell.vertices)
                  {
                    lower = std::min(lower, vertex[d]);
                    upper = std::max(upper, vertex[d]);
                  }
                meets = meets && lower <= origin[d] && origin[d] <= upper;
              }
          if (meets)
            for (const auto &simplex : SimplexCut::divide<dim>(level_set(c)))
              add_simplex<dim>(cell, simplex, origin, axis, content);
        }
      const MPI_Comm communicator = mesh.triangulation().get_communicator();
      content.length =
        dealii::Utilities::MPI::sum(content.length, communicator);
      content.wet_length =
        dealii::Utilities::MPI::sum(content.wet_length, communicator);
      content.top = dealii::Utilities::MPI::max(content.top, communicator);
      return content;
    }


    /// The line through @p point or, if it lies in faces, beside it.
    template <int dim>
    LineContent
    cut_line_of(const Mesh<dim>          &mesh,
                const CellLevelSet<dim>  &level_set,
                const dealii::Point<dim> &point,
                const unsigned int        axis)
    {
      double shift = 0.;
      for (unsigned int c = 0; c < mesh.graph().n_owned_cells(); ++c)
        {
          const auto &cell = mesh.graph().cell(c);
          shift            = std::max(shift,
                           1e-9 * cell.extent.norm() +
                             coordinate_round_off(cell.vertices.back()));
        }
      shift =
        dealii::Utilities::MPI::max(shift,
                                    mesh.triangulation().get_communicator());

      LineContent best;
      for (unsigned int side = 0; side < (1u << dim); ++side)
        {
          if ((side >> axis) & 1u)
            continue;
          dealii::Point<dim> origin = point;
          for (unsigned int d = 0; d < dim; ++d)
            if (d != axis)
              // Unequal in each direction, to stay off diagonals too.
              origin[d] +=
                ((side >> d) & 1u ? -1. : 1.) * (1. + .3 * d) * shift;
          const LineContent content =
            cut_shifted_line(mesh, level_set, origin, axis);
          if (content.length > best.length * (1. + 1e-6))
            best = content;
        }
      return best;
    }
  } // namespace


  template <int dim>
  LineContent
  cut_line(const FlowView<dim>      &solution,
           const dealii::Point<dim> &point,
           const unsigned int        axis)
  {
    return cut_line_of<dim>(
      solution.mesh,
      [&](const unsigned int cell) { return cell_level_set(solution, cell); },
      point,
      axis);
  }


  template <int dim>
  bool
  meets_line(const Mesh<dim>          &mesh,
             const dealii::Point<dim> &point,
             const unsigned int        axis)
  {
    const auto positive = [](const unsigned int) {
      std::array<double, (1 << dim)> phi;
      phi.fill(1.);
      return phi;
    };
    return cut_line_of<dim>(mesh, positive, point, axis).length > 0.;
  }


  template LineContent
  cut_line(const FlowView<2> &, const dealii::Point<2> &, const unsigned int);
  template LineContent
  cut_line(const FlowView<3> &, const dealii::Point<3> &, const unsigned int);
  template bool
  meets_line(const Mesh<2> &, const dealii::Point<2> &, const unsigned int);
  template bool
  meets_line(const Mesh<3> &, const dealii::Point<3> &, const unsigned int);
} // namespace Thalweg
