// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/gather.h>
#include <thalweg/particles/cell_maps.h>
#include <thalweg/postprocess/cell_access.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace Thalweg
{
  std::string
  length_unit(const unsigned int exponent)
  {
    return exponent == 1 ? "m" : "m^" + std::to_string(exponent);
  }


  template <int dim>
  std::array<double, (1 << dim)>
  cell_level_set(const FlowView<dim> &solution, const unsigned int cell)
  {
    if (solution.fluids.size() == 2)
      return gather<dim>(solution.level_set, solution.space.nodes(cell));
    std::array<double, (1 << dim)> phi;
    phi.fill(-1.);
    return phi;
  }


  namespace
  {
    /// How far outside of a cell a point may be that is said to be in it, in
    /// reference coordinates.
    constexpr double round_off = 1e-9;


    /// Finds reference coordinates; returns false if there are none, far
    /// outside.
    template <int dim>
    bool
    find_in_straight_cell(const typename CellGraph<dim>::Cell &cell,
                          const dealii::Point<dim>            &point,
                          dealii::Point<dim>                  &xi)
    {
      std::array<double, dim> way, reference;
      for (unsigned int d = 0; d < dim; ++d)
        {
          way[d]       = point[d] - cell.vertices[0][d];
          reference[d] = way[d] * cell.inverse_extent[d];
        }
      if (!cell.axis_parallel &&
          !CellMaps<dim>::find_reference(CellMaps<dim>::shape_of(cell),
                                         way,
                                         reference))
        return false;
      for (unsigned int d = 0; d < dim; ++d)
        xi[d] = reference[d];
      return true;
    }


    /// Finds reference coordinates; returns by how much they are outside of
    /// the reference cell, at most 1.
    template <int dim>
    double
    find_in_cell(const Mesh<dim>            &mesh,
                 const dealii::Mapping<dim> &mapping,
                 const unsigned int          c,
                 const dealii::Point<dim>   &point,
                 dealii::Point<dim>         &xi)
    {
      const auto &cell = mesh.graph().cell(c);
      if (&mapping == &mesh.mapping())
        {
          if (!find_in_straight_cell<dim>(cell, point, xi))
            return 1.;
        }
      else
        {
          try
            {
              xi = mapping.transform_real_to_unit_cell(mesh.graph().iterator(c),
                                                       point);
            }
          catch (const typename dealii::Mapping<dim>::ExcTransformationFailed &)
            {
              // Newton's method may diverge only for points outside.
              return 1.;
            }
        }
      double outside = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        outside = std::max({outside, -xi[d], xi[d] - 1.});
      return std::isfinite(outside) ? std::min(outside, 1.) : 1.;
    }


    /// Whether @p point may be in a cell or close to it.
    template <int dim>
    bool
    is_near(const typename CellGraph<dim>::Cell &cell,
            const dealii::Point<dim>            &point,
            const double                         relative_margin)
    {
      for (unsigned int d = 0; d < dim; ++d)
        {
          double lower = cell.vertices[0][d], upper = lower, size = 0.;
          for (const auto &vertex : cell.vertices)
            {
              lower = std::min(lower, vertex[d]);
              upper = std::max(upper, vertex[d]);
              size  = std::max(size, vertex.distance(cell.vertices[0]));
            }
          const double margin = relative_margin * size;
          if (point[d] < lower - margin || point[d] > upper + margin)
            return false;
        }
      return true;
    }


    /// The owned cell with the least number that @p point is in, or else the
    /// one that is nearest to it. @return how far outside it is
    template <int dim>
    double
    nearest_cell(const Mesh<dim>            &mesh,
                 const dealii::Mapping<dim> &mapping,
                 const dealii::Point<dim>   &point,
                 LocatedPoint<dim>          &located)
    {
      // A curved cell may bulge out of the box around its vertices.
      const double margin  = &mapping == &mesh.mapping() ? .06 : .3;
      double       nearest = 1.;
      for (unsigned int c = 0; c < mesh.graph().n_owned_cells(); ++c)
        if (is_near<dim>(mesh.graph().cell(c), point, margin))
          {
            dealii::Point<dim> xi;
            const double outside = find_in_cell(mesh, mapping, c, point, xi);
            if (outside < nearest)
              {
                nearest      = outside;
                located.cell = c;
                located.xi   = xi;
              }
            if (outside <= round_off)
              return 0.;
          }
      return nearest;
    }


    template <int dim>
    void
    throw_outside(const Mesh<dim>          &mesh,
                  const std::string        &what,
                  const dealii::Point<dim> &point)
    {
      std::ostringstream message;
      message.precision(10);
      message << what << " (" << point
              << ") lies outside the mesh; move it inside. The mesh reaches "
              << mesh.extent() << ".";
      AssertThrow(false, dealii::ExcMessage(message.str()));
    }
  } // namespace


  template <int dim>
  std::vector<LocatedPoint<dim>>
  locate(const Mesh<dim>                       &mesh,
         const std::vector<dealii::Point<dim>> &points,
         const std::string                     &what)
  {
    return locate(mesh, mesh.mapping(), points, what, round_off);
  }


  template <int dim>
  std::vector<LocatedPoint<dim>>
  locate(const Mesh<dim>                       &mesh,
         const dealii::Mapping<dim>            &mapping,
         const std::vector<dealii::Point<dim>> &points,
         const std::string                     &what,
         const double                           tolerance)
  {
    using Index                 = dealii::types::global_cell_index;
    const Index    nobody       = std::numeric_limits<Index>::max();
    const MPI_Comm communicator = mesh.triangulation().get_communicator();
    std::vector<LocatedPoint<dim>> located(points.size());
    std::vector<double>            outside(points.size());
    for (std::size_t p = 0; p < points.size(); ++p)
      outside[p] = nearest_cell(mesh, mapping, points[p], located[p]);

    std::vector<double> least_outside(points.size());
    dealii::Utilities::MPI::min(outside, communicator, least_outside);
    std::vector<Index> candidates(points.size(), nobody);
    for (std::size_t p = 0; p < points.size(); ++p)
      if (outside[p] == least_outside[p] && outside[p] <= tolerance)
        candidates[p] = mesh.graph().cell(located[p].cell).global_index;
    std::vector<Index> winners(points.size());
    dealii::Utilities::MPI::min(candidates, communicator, winners);
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        if (winners[p] == nobody)
          throw_outside(mesh, what, points[p]);
        located[p].is_here = winners[p] == candidates[p];
        if (least_outside[p] > 0.)
          located[p].xi =
            dealii::GeometryInfo<dim>::project_to_unit_cell(located[p].xi);
      }
    return located;
  }


  template <int dim>
  void
  check_reach(const Mesh<dim>   &mesh,
              const unsigned int axis,
              const double       from,
              const double       to,
              const std::string &what)
  {
    double lower = std::numeric_limits<double>::max(), upper = -lower;
    double tolerance = 0.;
    for (unsigned int c = 0; c < mesh.graph().n_owned_cells(); ++c)
      {
        const auto &cell = mesh.graph().cell(c);
        for (const auto &vertex : cell.vertices)
          {
            lower = std::min(lower, vertex[axis]);
            upper = std::max(upper, vertex[axis]);
          }
        tolerance = std::max(tolerance, round_off * cell.extent.norm());
      }
    const MPI_Comm communicator = mesh.triangulation().get_communicator();
    lower     = dealii::Utilities::MPI::min(lower, communicator);
    upper     = dealii::Utilities::MPI::max(upper, communicator);
    tolerance = dealii::Utilities::MPI::max(tolerance, communicator);
    std::ostringstream message;
    message.precision(10);
    message << what << ", "
            << "xyz"[axis] << " = " << from;
    if (from < to)
      message << " to " << to;
    message << ", lies outside the mesh, which reaches " << mesh.extent()
            << "; move it inside.";
    AssertThrow(from <= upper + tolerance && to >= lower - tolerance,
                dealii::ExcMessage(message.str()));
  }


#define THALWEG_INSTANTIATE_ACCESS(dim)                   \
  template std::vector<LocatedPoint<dim>> locate(         \
    const Mesh<dim> &,                                    \
    const dealii::Mapping<dim> &,                         \
    const std::vector<dealii::Point<dim>> &,              \
    const std::string &,                                  \
    const double);                                        \
  template std::array<double, (1 << dim)> cell_level_set( \
    const FlowView<dim> &, const unsigned int);           \
  template std::vector<LocatedPoint<dim>> locate(         \
    const Mesh<dim> &,                                    \
    const std::vector<dealii::Point<dim>> &,              \
    const std::string &);                                 \
  template void check_reach(const Mesh<dim> &,            \
                            const unsigned int,           \
                            const double,                 \
                            const double,                 \
                            const std::string &);
  THALWEG_INSTANTIATE_ACCESS(2)
  THALWEG_INSTANTIATE_ACCESS(3)
#undef THALWEG_INSTANTIATE_ACCESS
} // namespace Thalweg
