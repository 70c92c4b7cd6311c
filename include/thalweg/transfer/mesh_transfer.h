// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_transfer_mesh_transfer_h
#define thalweg_transfer_mesh_transfer_h

#include <thalweg/fields/state.h>

#include <boost/range/iterator_range.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace Thalweg
{
  /// What cells carry, one behind the other, as files have it.
  struct PackedCells
  {
    std::vector<std::uint32_t> sizes; ///< of each cell, in bytes
    std::vector<char>          bytes;
  };

  /**
   * @brief Carries a State from one mesh to the next, to other ranks, and into
   * files: all of it travels attached to the cells.
   *
   * On refined cells fields are interpolated; coarsened cells keep the values
   * at the nodes that remain. What else sits in cells knows itself where it
   * goes.
   */
  template <int dim>
  class MeshTransfer
  {
  public:
    /// @param mesh must outlive the object
    explicit MeshTransfer(Mesh<dim> &mesh)
      : mesh(mesh)
    {}

    /**
     * @brief Attaches @p state to the cells of the mesh, which then may
     * change; what sits in cells is cleared until unpack(). Collective.
     *
     * @param state the spaces of its fields must not go before the mesh has
     *   changed
     */
    void
    pack(const State<dim> &state);

    /**
     * @brief Gives @p state what belongs to the cells of the new mesh.
     * Collective.
     *
     * To be called when the mesh's graph and the spaces of @p state are those
     * of the new mesh, after pack() and a change of the mesh.
     */
    void
    unpack(const State<dim> &state);

    /// What each cell of this rank carries, in the order of the mesh's graph,
    /// to be saved. @param state as for pack()
    PackedCells
    pack_to_save(const State<dim> &state);

    /**
     * @brief Gives @p state what pack_to_save() returned, after keep().
     * Collective.
     * @param cells of this rank
     * @throws dealii::ExcMessage if they do not hold what they must, or
     *   something else sat in them than what @p state names
     */
    void
    unpack_saved(const State<dim> &state, const PackedCells &cells);

    /// Names what the cells carry, for the mesh that is loaded: fields that
    /// nobody wants any more are passed over.
    void
    keep(const Archive &archive);

  private:
    using CellIterator = typename dealii::Triangulation<dim>::cell_iterator;
    using Bytes        = std::vector<char>;
    using ByteRange    = boost::iterator_range<typename Bytes::const_iterator>;

    /// Takes what is to be packed.
    void
    take(const State<dim> &state);

    /// Prepares the unpacking of cells.
    void
    begin_to_unpack(const State<dim> &state);

    /// Makes all whole when all cells are unpacked.
    void
    end_to_unpack(const State<dim> &state);

    /// The field of @p state called @p name, with a space and a vector if it
    /// has one.
    static CarriedField<dim>
    find(const State<dim> &state, const std::string &name);

    Bytes
    pack_cell(const CellIterator &cell, const Compat::CellFate fate) const;

    void
    unpack_cell(const CellIterator    &cell,
                const Compat::CellFate fate,
                const char            *bytes,
                const std::size_t      size);

    /// Sets the owned values of @p field in a cell of the graph.
    void
    set_nodes(const CarriedField<dim>   &field,
              const unsigned int         cell,
              const std::vector<double> &values) const;

    void
    unpack_field(const CarriedField<dim>   &field,
                 const CellIterator        &cell,
                 const Compat::CellFate     fate,
                 const std::vector<double> &values) const;

    Mesh<dim>                     &mesh;
    std::vector<CarriedField<dim>> fields;
    /// The names of the fields, and how many values a cell has of each.
    std::vector<std::string>  names;
    std::vector<unsigned int> n_values;
    /// Ghosted copies of the fields that were packed.
    std::vector<Vector> values;
    /// What sits in cells, and its names.
    std::vector<NamedCarried<dim>> carried;
    std::vector<std::string>       names_of_carried;
    unsigned int handle = dealii::numbers::invalid_unsigned_int;
  };
} // namespace Thalweg

#endif
