#include <thalweg/fields/q1_cell.h>
#include <thalweg/interface/sampled_volume.h>
#include <thalweg/interface/simplex_cut.h>

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
      {
        for (unsigned int i = 0; i < values.size(); ++i)
          {
            dealii::Point<dim> xi;
            for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= n + 1)
              xi[d] = static_cast<double>(rest % (n + 1)) / n;
            values[i] = function.value(Q1::position<dim>(cell.vertices, xi));
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
      starts_negative() const
      {
        return values[0] < 0.;
      }

      /// The part of the cell where the function is negative, from a linear
      /// cut of each sub-cell.
      double
      negative_fraction() const
      {
        double sum = 0;
        for (unsigned int s = 0; s < dealii::Utilities::pow(n, dim); ++s)
          sum += SimplexCut::negative_fraction<dim>(corners(s));
        return sum / dealii::Utilities::pow(n, dim);
      }

    private:
      std::array<double, (1 << dim)>
      corners(const unsigned int sub_cell) const
      {
        std::array<double, (1 << dim)> phi;
        for (unsigned int v = 0; v < phi.size(); ++v)
          {
            unsigned int index = 0, stride = 1;
            for (unsigned int d = 0, rest = sub_cell; d < dim; ++d, rest /= n)
              {
                index += stride * (rest % n + ((v >> d) & 1));
                stride *= n + 1;
              }
            phi[v] = values[index];
          }
        return phi;
      }

      const unsigned int  n;
      std::vector<double> values;
    };
  } // namespace


  template <int dim>
  double
  sampled_negative_volume(const typename CellGraph<dim>::Cell &cell,
                          const dealii::Function<dim>         &function)
  {
    const Lattice<dim> coarse(cell, function, 2);
    if (coarse.is_far_from_zero())
      return coarse.starts_negative() ? cell.measure : 0.;
    return Lattice<dim>(cell, function, 10).negative_fraction() * cell.measure;
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
