// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/adaptation/load_balance.h>
#include <thalweg/core/registry.h>
#include <thalweg/postprocess/cell_access.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Thalweg
{
  namespace
  {
    /// Of an empty cell, where that leaves room for all others.
    constexpr double weight_of_cell = 1000.;

    /// p4est takes weights as int.
    constexpr double largest_weight = std::numeric_limits<int>::max();



    /// The greatest over the mean, for each entry.
    std::vector<double>
    greatest_over_mean(const MPI_Comm             communicator,
                       const std::vector<double> &values)
    {
      std::vector<double> sums(values.size()), ratios(values.size());
      dealii::Utilities::MPI::sum(values, communicator, sums);
      dealii::Utilities::MPI::max(values, communicator, ratios);
      const double n_ranks =
        dealii::Utilities::MPI::n_mpi_processes(communicator);
      for (unsigned int i = 0; i < values.size(); ++i)
        ratios[i] = sums[i] > 0. ? ratios[i] * n_ranks / sums[i] : 1.;
      return ratios;
    }
  } // namespace



  std::vector<std::pair<std::string, double>>
  Imbalance::columns() const
  {
    return {{"imbalance", total},
            {"imbalance cells", cells},
            {"imbalance particles", particles},
            {"imbalance cut cells", cut_cells}};
  }



  template <int dim>
  void
  LoadBalance<dim>::declare_parameters(const Section &root)
  {
    using dealii::Patterns::Double;
    const Section section = root.enter("Load balance");
    section.add("Weight of a cell",
                cell_weight,
                "",
                "How much work a cell is; only the ratios of the three weights "
                "matter.",
                Double(0));
    section.add(
      "Weight of a particle",
      particle_weight,
      "",
      "How much work a particle is. The default was measured on a dam "
      "break: 0.12 microseconds of a step, against 3.3 for a cell.",
      Double(0));
    section.add("Weight of a cut cell",
                cut_cell_weight,
                "",
                "How much more work a cell is through which the interface "
                "passes.",
                Double(0));
    section.add("Threshold",
                threshold,
                "",
                "The cells are distributed over the processes anew when one "
                "of them has more than this times the mean of their work.",
                Double(1));
    section.add("Interval",
                interval,
                "steps",
                "After how many steps the imbalance is looked at.",
                dealii::Patterns::Integer(1));
  }



  template <int dim>
  void
  LoadBalance<dim>::check() const
  {
    AssertThrow(cell_weight + particle_weight > 0.,
                dealii::ExcMessage(
                  "'Load balance/Weight of a cell' and 'Weight of a particle' "
                  "are both 0; cells without any work cannot be distributed."));
  }



  template <int dim>
  typename LoadBalance<dim>::Load
  LoadBalance<dim>::load(const SolutionView<dim> &solution,
                         const unsigned int       cell) const
  {
    Load load;
    for (const auto &[name, flow] : solution.flows)
      {
        load.n_particles += flow.population.n_in_cell(cell);
        const auto phi = cell_level_set(flow, cell);
        const auto [smallest, largest] =
          std::minmax_element(phi.begin(), phi.end());
        load.is_cut |= *smallest < 0. && *largest >= 0.;
      }
    return load;
  }



  template <int dim>
  void
  LoadBalance<dim>::count(const SolutionView<dim> &solution)
  {
    const auto &triangulation = solution.mesh.triangulation();
    loads.assign(triangulation.n_active_cells(), {});
    double most = cost(1., 0., 0.);
    for (unsigned int c = 0; c < solution.mesh.graph().n_owned_cells(); ++c)
      {
        const Load own = load(solution, c);
        most           = std::max(most, cost(1., own.n_particles, own.is_cut));
        loads[solution.mesh.graph().iterator(c)->active_cell_index()] = own;
      }
    most = dealii::Utilities::MPI::max(most, triangulation.get_communicator());
    // All siblings together may become one cell.
    scale = std::min(weight_of_cell / std::max(cell_weight, 1e-300),
                     largest_weight / (2. * (1 << dim) * most));
  }



  template <int dim>
  unsigned int
  LoadBalance<dim>::weight(const CellIterator    &cell,
                           const Compat::CellFate fate) const
  {
    const auto of = [this](const auto &active) {
      const unsigned int index = active->active_cell_index();
      return index < loads.size() ? loads[index] : Load();
    };
    double n_particles = 0., n_cut = 0.;
    if (fate == Compat::CellFate::is_coarsened)
      for (unsigned int k = 0; k < cell->n_children(); ++k)
        {
          const Load child = of(cell->child(k));
          n_particles += child.n_particles;
          n_cut = std::max(n_cut, child.is_cut ? 1. : 0.);
        }
    else
      {
        const double n_parts =
          fate == Compat::CellFate::is_refined ? (1 << dim) : 1.;
        const Load own = of(cell);
        n_particles    = own.n_particles / n_parts;
        if (own.is_cut)
          n_cut = fate == Compat::CellFate::is_refined ? .5 : 1.;
      }
    return std::lround(
      std::clamp(scale * cost(1., n_particles, n_cut), 1., largest_weight));
  }



  template <int dim>
  Imbalance
  LoadBalance<dim>::imbalance(const SolutionView<dim> &solution) const
  {
    std::vector<double> own(4, 0.);
    for (unsigned int c = 0; c < solution.mesh.graph().n_owned_cells(); ++c)
      {
        const Load of_cell = load(solution, c);
        own[1] += 1.;
        own[2] += of_cell.n_particles;
        own[3] += of_cell.is_cut ? 1. : 0.;
      }
    own[0] = cost(own[1], own[2], own[3]);
    const auto ratio =
      greatest_over_mean(solution.mesh.triangulation().get_communicator(), own);
    return {ratio[0], ratio[1], ratio[2], ratio[3]};
  }



  template <int dim>
  bool
  LoadBalance<dim>::is_due(const SolutionView<dim> &solution,
                           const unsigned int       step) const
  {
    const MPI_Comm communicator =
      solution.mesh.triangulation().get_communicator();
    const unsigned int n_ranks =
      dealii::Utilities::MPI::n_mpi_processes(communicator);
    if (step == 0 || step % interval != 0 || n_ranks == 1)
      return false;
    double most = 0., sum = 0.;
    for (unsigned int c = 0; c < solution.mesh.graph().n_owned_cells(); ++c)
      {
        const Load   own  = load(solution, c);
        const double work = cost(1., own.n_particles, own.is_cut);
        most              = std::max(most, work);
        sum += work;
      }
    most = dealii::Utilities::MPI::max(most, communicator);
    const double mean =
      dealii::Utilities::MPI::sum(sum, communicator) / n_ranks;
    // Siblings are kept together, and nobody can do better than that.
    const double unavoidable = 1. + (1 << dim) * most / mean;
    return imbalance(solution).total > std::max(threshold, unavoidable);
  }



  THALWEG_INSTANTIATE(LoadBalance)
} // namespace Thalweg
