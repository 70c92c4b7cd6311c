// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/cell_count.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    template <int dim>
    using Corners = std::array<dealii::Point<dim>, 1 << dim>;


    template <int dim>
    dealii::Point<dim>
    center_of(const Corners<dim> &corners)
    {
      dealii::Tensor<1, dim> sum;
      for (const auto &corner : corners)
        sum += corner - corners[0];
      return corners[0] + sum / double(corners.size());
    }


    template <int dim>
    class Counter
    {
    public:
      Counter(const unsigned int           global_levels,
              const dealii::Function<dim> &local_levels,
              const double                 most)
        : global_levels(global_levels)
        , local_levels(local_levels)
        , most(most)
      {}

      double n_cells = 0.;

      /// Counts what becomes of a cell.
      void
      count(const Corners<dim> &corners, const int level)
      {
        if (n_cells > most)
          return;
        const double wanted = level_at(center_of<dim>(corners));
        if (level >= wanted)
          n_cells += 1.;
        else
          for (unsigned int child = 0; child < corners.size(); ++child)
            count(child_of(corners, child), level + 1);
      }

      /// The level of the cell with this centre.
      double
      level_at(const dealii::Point<dim> &center) const
      {
        const double wanted =
          global_levels + std::round(local_levels.value(center));
        std::ostringstream message;
        if (wanted > highest_level<dim>)
          message << "'Refinement/Global levels' and 'Local levels' refine the "
                     "cell with its centre at ("
                  << center << ") " << wanted
                  << " times. It must be at the most "
                  << highest_level<dim> << " times.";
        AssertThrow(message.str().empty(), dealii::ExcMessage(message.str()));
        return std::max(wanted, 0.);
      }

    private:
      static Corners<dim>
      child_of(const Corners<dim> &corners, const unsigned int child)
      {
        Corners<dim> result;
        for (unsigned int v = 0; v < corners.size(); ++v)
          {
            dealii::Point<dim> unit;
            for (unsigned int d = 0; d < dim; ++d)
              unit[d] = .5 * (((child >> d) & 1) + ((v >> d) & 1));
            dealii::Tensor<1, dim> from_first;
            for (unsigned int w = 1; w < corners.size(); ++w)
              from_first +=
                dealii::GeometryInfo<dim>::d_linear_shape_function(unit, w) *
                (corners[w] - corners[0]);
            result[v] = corners[0] + from_first;
          }
        return result;
      }

      const double                 global_levels;
      const dealii::Function<dim> &local_levels;
      const double                 most;
    };
  } // namespace



  template <int dim>
  double
  count_cells(const dealii::Triangulation<dim> &coarse,
              const unsigned int                global_levels,
              const dealii::Function<dim>      &local_levels,
              const bool                        is_constant,
              const double                      most)
  {
    Counter<dim> counter(global_levels, local_levels, most);
    if (is_constant)
      return coarse.n_cells(0) *
             std::pow(2., dim * counter.level_at(coarse.begin(0)->center()));
    for (const auto &cell : coarse.cell_iterators_on_level(0))
      {
        Corners<dim> corners;
        for (const unsigned int v : cell->vertex_indices())
          corners[v] = cell->vertex(v);
        counter.count(corners, 0);
      }
    return counter.n_cells;
  }



  template double
  count_cells(const dealii::Triangulation<2> &,
              const unsigned int,
              const dealii::Function<2> &,
              const bool,
              const double);
  template double
  count_cells(const dealii::Triangulation<3> &,
              const unsigned int,
              const dealii::Function<3> &,
              const bool,
              const double);
} // namespace Thalweg
