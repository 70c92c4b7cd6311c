// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/interface/cut_in_space.h>
#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/phase_integrals.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    /// Adds the quadrature point @p xi with the reference weight @p weight.
    template <int dim>
    void
    add_point(const FlowView<dim>      &solution,
              const unsigned int        c,
              const dealii::Point<dim> &xi,
              const double              weight,
              PhaseIntegrals<dim>      &integrals)
    {
      const auto            &cell  = solution.mesh.graph().cell(c);
      const auto            &nodes = solution.space.nodes(c);
      const auto             point = Q1::evaluate<dim>(cell,
                                           Q1::values<dim>(xi),
                                           Q1::reference_gradients<dim>(xi));
      dealii::Tensor<1, dim> velocity;
      for (unsigned int v = 0; v < nodes.size(); ++v)
        for (unsigned int d = 0; d < dim; ++d)
          velocity[d] += point.values[v] *
                         solution.velocity.local_element(dim * nodes[v] + d);
      const double measure = weight * point.determinant;
      integrals.volume += measure;
      integrals.moment_of_position +=
        measure * dealii::Tensor<1, dim>(Q1::position<dim>(cell.vertices, xi));
      integrals.moment_of_velocity += measure * velocity;
    }


    /// The same for cells of any shape.
    template <int dim>
    void
    add_cut_in_space(const FlowView<dim>                  &solution,
                     const unsigned int                    c,
                     const std::array<double, (1 << dim)> &phi,
                     std::array<PhaseIntegrals<dim>, 2>   &integrals)
    {
      const auto &vertices = solution.mesh.graph().cell(c).vertices;
      const auto &nodes    = solution.space.nodes(c);
      const Q1::SimplexShape<dim> shape(vertices);
      SimplexCut::cut_in_space<dim>(
        shape, phi, [&](const auto &piece, const auto &, const auto &) {
          auto      &phase  = integrals[piece.negative ? 0 : 1];
          const auto values = shape.values(piece.simplex, piece.middle);
          phase.volume += piece.measure;
          for (unsigned int v = 0; v < values.size(); ++v)
            for (unsigned int d = 0; d < dim; ++d)
              {
                phase.moment_of_position[d] +=
                  piece.measure * values[v] * vertices[v][d];
                phase.moment_of_velocity[d] +=
                  piece.measure * values[v] *
                  solution.velocity.local_element(dim * nodes[v] + d);
              }
        });
    }


    template <int dim>
    void
    add_cut_cell(const FlowView<dim>                  &solution,
                 const unsigned int                    c,
                 const std::array<double, (1 << dim)> &phi,
                 std::array<PhaseIntegrals<dim>, 2>   &integrals)
    {
      const auto &cell = solution.mesh.graph().cell(c);
      if (!Q1::is_parallelepiped<dim>(cell))
        {
          add_cut_in_space(solution, c, phi, integrals);
          return;
        }
      for (const auto &simplex : SimplexCut::divide<dim>(phi))
        SimplexCut::cut(simplex, [&](const SimplexCut::Simplex<dim> &piece) {
          auto &phase = integrals[SimplexCut::is_negative(piece) ? 0 : 1];
          for (const auto &point : SimplexCut::quadrature(piece))
            add_point(solution, c, point.xi, point.weight, phase);
        });
    }


    /// Adds up over all processes.
    template <int dim>
    void
    sum_over_ranks(std::array<PhaseIntegrals<dim>, 2> &integrals,
                   const MPI_Comm                      communicator)
    {
      std::array<double, 2 * (2 * dim + 1)> numbers;
      const auto                            exchange = [&](const auto &copy) {
        unsigned int n = 0;
        for (auto &phase : integrals)
          {
            copy(numbers[n++], phase.volume);
            for (unsigned int d = 0; d < dim; ++d)
              {
                copy(numbers[n++], phase.moment_of_position[d]);
                copy(numbers[n++], phase.moment_of_velocity[d]);
              }
          }
      };
      exchange([](double &number, const double &value) { number = value; });
      dealii::Utilities::MPI::sum(
        dealii::ArrayView<const double>(numbers.data(), numbers.size()),
        communicator,
        dealii::ArrayView<double>(numbers.data(), numbers.size()));
      exchange([](const double &number, double &value) { value = number; });
    }
  } // namespace


  template <int dim>
  std::array<PhaseIntegrals<dim>, 2>
  integrate_phases(const FlowView<dim> &solution)
  {
    static const Q1::Gauss<dim>        gauss;
    const CellGraph<dim>              &graph = solution.mesh.graph();
    std::array<PhaseIntegrals<dim>, 2> integrals;
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto phi           = cell_level_set(solution, c);
        const auto [least, most] = std::minmax_element(phi.begin(), phi.end());
        if (*least < 0. && *most > 0.)
          add_cut_cell(solution, c, phi, integrals);
        else
          for (const auto &xi : gauss.points)
            add_point(
              solution, c, xi, gauss.weight, integrals[*least < 0. ? 0 : 1]);
      }
    sum_over_ranks(integrals, solution.mesh.triangulation().get_communicator());
    return integrals;
  }


  template std::array<PhaseIntegrals<2>, 2>
  integrate_phases(const FlowView<2> &);
  template std::array<PhaseIntegrals<3>, 2>
  integrate_phases(const FlowView<3> &);
} // namespace Thalweg
