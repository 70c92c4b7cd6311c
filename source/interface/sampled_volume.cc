// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/q1_simplices.h>
#include <thalweg/interface/sampled_volume.h>
#include <thalweg/interface/simplex_cut.h>
#include <thalweg/mesh/round_off.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <vector>

namespace Thalweg
{
  namespace
  {
    /// Samples of a function on a lattice of n^dim sub-cells of a cell.
    template <int dim>
    class Lattice
    {
    public:
      Lattice(const typename CellGraph<dim>::Cell &cell,
              const dealii::Function<dim>         &function,
              const unsigned int                   n)
        : n(n)
        , values(dealii::Utilities::pow(n + 1, dim))
        , positions(values.size())
      {
        auto from_first = cell.vertices;
        for (auto &vertex : from_first)
          vertex = dealii::Point<dim>(vertex - cell.vertices[0]);
        const double edge = cell.edges().first;
        for (unsigned int i = 0; i < values.size(); ++i)
          {
            dealii::Point<dim> xi;
            for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= n + 1)
              xi[d] = static_cast<double>(rest % (n + 1)) / n;
            positions[i] = Q1::position<dim>(from_first, xi);
            const auto position =
              cell.vertices[0] + dealii::Tensor<1, dim>(positions[i]);
            values[i] =
              without_round_off(function.value(position), edge, position);
          }
      }

      /// Whether the function keeps away from zero by more than it varies.
      bool
      is_far_from_zero() const
      {
        const auto [least, most] =
          std::minmax_element(values.begin(), values.end());
        return std::max(*least, -*most) > *most - *least;
      }

      bool
      has_one_sign() const
      {
        const auto [least, most] =
          std::minmax_element(values.begin(), values.end());
        return *least >= 0. || *most <= 0.;
      }

      /// If it has one sign: which one.
      bool
      is_negative() const
      {
        return *std::min_element(values.begin(), values.end()) < 0.;
      }

      /// The part of the cell where the function is negative, from a linear
      /// cut of each sub-cell.
      double
      negative_fraction() const
      {
        double sum = 0;
        for (unsigned int s = 0; s < dealii::Utilities::pow(n, dim); ++s)
          sum += SimplexCut::negative_fraction<dim>(at_corners(values, s));
        return sum / dealii::Utilities::pow(n, dim);
      }

      /// The same where sub-cells differ, as a measure.
      double
      negative_measure() const
      {
        double sum = 0;
        for (unsigned int s = 0; s < dealii::Utilities::pow(n, dim); ++s)
          for (const auto &simplex :
               SimplexCut::divide<dim>(at_corners(positions, s),
                                       at_corners(values, s)))
            SimplexCut::cut(simplex, [&sum](const auto &piece) {
              if (SimplexCut::is_negative(piece))
                sum += SimplexCut::measure(piece);
            });
        return sum;
      }

    private:
      template <typename T>
      std::array<T, (1 << dim)>
      at_corners(const std::vector<T> &samples,
                 const unsigned int    sub_cell) const
      {
        std::array<T, (1 << dim)> at_corners;
        for (unsigned int v = 0; v < at_corners.size(); ++v)
          {
            unsigned int index = 0, stride = 1;
            for (unsigned int d = 0, rest = sub_cell; d < dim; ++d, rest /= n)
              {
                index += stride * (rest % n + ((v >> d) & 1));
                stride *= n + 1;
              }
            at_corners[v] = samples[index];
          }
        return at_corners;
      }

      const unsigned int  n;
      std::vector<double> values;
      /// Relative to the cell's first vertex.
      std::vector<dealii::Point<dim>> positions;
    };
  } // namespace


  template <int dim>
  double
  sampled_negative_volume(const typename CellGraph<dim>::Cell &cell,
                          const dealii::Function<dim>         &function)
  {
    const Lattice<dim> coarse(cell, function, 2);
    if (coarse.is_far_from_zero())
      return coarse.is_negative() ? cell.measure : 0.;
    const Lattice<dim> fine(cell, function, 10);
    if (fine.has_one_sign())
      return fine.is_negative() ? cell.measure : 0.;
    return Q1::is_parallelepiped<dim>(cell)
             ? fine.negative_fraction() * cell.measure
             : fine.negative_measure();
  }


  template <int dim>
  double
  sampled_negative_volume(const CellGraph<dim>        &graph,
                          const dealii::Function<dim> &function,
                          const MPI_Comm               communicator)
  {
    double volume = 0;
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      volume += sampled_negative_volume<dim>(graph.cell(c), function);
    return dealii::Utilities::MPI::sum(volume, communicator);
  }


#define THALWEG_INSTANTIATE_SAMPLED(dim)                                       \
  template double sampled_negative_volume<dim>(const CellGraph<dim>::Cell &,   \
                                               const dealii::Function<dim> &); \
  template double sampled_negative_volume<dim>(const CellGraph<dim> &,         \
                                               const dealii::Function<dim> &,  \
                                               const MPI_Comm);
  THALWEG_INSTANTIATE_SAMPLED(2)
  THALWEG_INSTANTIATE_SAMPLED(3)
#undef THALWEG_INSTANTIATE_SAMPLED
} // namespace Thalweg
