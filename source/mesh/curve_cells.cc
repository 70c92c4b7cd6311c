// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/mesh/curve_cells.h>

#include <deal.II/base/mpi.h>

#include <array>

namespace Thalweg
{
  namespace
  {
    /// Where a cell begins and ends on the curve through its coarse cell.
    template <int dim>
    std::array<std::uint64_t, 2>
    range_of(const CurveCell &cell)
    {
      const unsigned int shift = dim * (highest_curve_level<dim> - cell.level);
      return {{cell.path << shift, (cell.path + 1) << shift}};
    }



    template <int dim>
    bool
    is_possible(const CurveCell &cell, const std::uint64_t n_trees)
    {
      return cell.level <= highest_curve_level<dim> && cell.tree < n_trees &&
             cell.path >> (dim * cell.level) == 0;
    }
  } // namespace



  template <int dim>
  std::vector<CurveCell>
  curve_cells(const CellGraph<dim> &graph)
  {
    std::vector<CurveCell> cells(graph.n_owned_cells());
    for (unsigned int c = 0; c < cells.size(); ++c)
      {
        // Ids have the number along the curve, and not that in the mesh.
        const dealii::CellId id = graph.iterator(c)->id();
        cells[c].tree           = id.get_coarse_cell_id();
        cells[c].level          = id.get_child_indices().size();
        for (const auto child : id.get_child_indices())
          cells[c].path = cells[c].path << dim | child;
      }
    return cells;
  }



  template <int dim>
  std::string
  fault_of(const MPI_Comm                communicator,
           const std::vector<CurveCell> &cells,
           const std::uint64_t           n_trees)
  {
    namespace MPI = dealii::Utilities::MPI;
    // In units of the smallest cell, so that sums are exact in parts of trees.
    constexpr std::uint64_t whole = 1ull << (dim * highest_curve_level<dim>);
    unsigned int            fault = 0;
    for (const CurveCell &cell : cells)
      if (!is_possible<dim>(cell, n_trees))
        fault = 1;
    if (MPI::max(fault, communicator) > 0)
      return "it has cells that cannot be";

    // A place on the whole curve is a tree and a place in it; the end of a
    // tree is the beginning of the next one.
    using Place         = std::array<std::uint64_t, 2>;
    const auto place_of = [&](const std::uint64_t tree, const std::uint64_t x) {
      return x == whole ? Place{{tree + 1, 0}} : Place{{tree, x}};
    };
    const auto begin = [&](const CurveCell &cell) {
      return place_of(cell.tree, range_of<dim>(cell)[0]);
    };
    const auto end = [&](const CurveCell &cell) {
      return place_of(cell.tree, range_of<dim>(cell)[1]);
    };
    for (std::size_t c = 1; c < cells.size(); ++c)
      if (end(cells[c - 1]) != begin(cells[c]))
        fault = 1;
    std::vector<Place> ends;
    if (!cells.empty())
      ends = {begin(cells.front()), end(cells.back())};
    Place next{{0, 0}};
    for (const auto &of_rank : MPI::all_gather(communicator, ends))
      if (!of_rank.empty())
        {
          if (of_rank[0] != next)
            fault = 1;
          next = of_rank[1];
        }
    if (next != Place{{n_trees, 0}})
      fault = 1;
    return MPI::max(fault, communicator) > 0 ? "its cells do not cover the mesh"
                                             : "";
  }



#define INSTANTIATE(dim)                                                        \
  template std::vector<CurveCell> curve_cells(const CellGraph<dim> &);          \
  template std::string            fault_of<dim>(const MPI_Comm,                 \
                                     const std::vector<CurveCell> &, \
                                     const std::uint64_t);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Thalweg
