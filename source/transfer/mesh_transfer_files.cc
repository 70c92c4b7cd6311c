// SPDX-License-Identifier: LGPL-2.1-or-later
// What MeshTransfer packs for files and takes from them.
#include <thalweg/core/registry.h>
#include <thalweg/transfer/mesh_transfer.h>

#include <deal.II/base/exceptions.h>

namespace Thalweg
{
  template <int dim>
  PackedCells
  MeshTransfer<dim>::pack_to_save(const State<dim> &state)
  {
    take(state);
    PackedCells           cells;
    const CellGraph<dim> &graph = mesh.graph();
    cells.sizes.reserve(graph.n_owned_cells());
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const Bytes bytes =
          pack_cell(graph.iterator(c), Compat::CellFate::persists);
        cells.sizes.push_back(bytes.size());
        cells.bytes.insert(cells.bytes.end(), bytes.begin(), bytes.end());
      }
    return cells;
  }



  template <int dim>
  void
  MeshTransfer<dim>::unpack_saved(const State<dim>  &state,
                                  const PackedCells &cells)
  {
    begin_to_unpack(state);
    const CellGraph<dim> &graph = mesh.graph();
    AssertDimension(cells.sizes.size(), graph.n_owned_cells());
    for (unsigned int k = 0; k < fields.size(); ++k)
      AssertThrow(fields[k].vector == nullptr ||
                    n_values[k] == fields[k].space->n_nodes_per_cell() *
                                     fields[k].n_components,
                  dealii::ExcMessage("its field '" + names[k] +
                                     "' is of another kind"));
    std::size_t place = 0;
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        AssertThrow(cells.sizes[c] <= cells.bytes.size() - place,
                    dealii::ExcMessage("its cells are cut short"));
        unpack_cell(graph.iterator(c),
                    Compat::CellFate::persists,
                    cells.bytes.data() + place,
                    cells.sizes[c]);
        place += cells.sizes[c];
      }
    for (const auto &[name, item] : carried)
      item->check_unpacked();
    end_to_unpack(state);
  }



  template PackedCells
  MeshTransfer<2>::pack_to_save(const State<2> &);
  template void
  MeshTransfer<2>::unpack_saved(const State<2> &, const PackedCells &);
  template PackedCells
  MeshTransfer<3>::pack_to_save(const State<3> &);
  template void
  MeshTransfer<3>::unpack_saved(const State<3> &, const PackedCells &);
} // namespace Thalweg
