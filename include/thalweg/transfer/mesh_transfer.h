// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_transfer_mesh_transfer_h
#define thalweg_transfer_mesh_transfer_h

#include <thalweg/core/compat_weights.h>
#include <thalweg/fields/state.h>
#include <thalweg/particles/particle_storage.h>
#include <thalweg/particles/population_snapshot.h>

#include <cstdint>
#include <functional>
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
   * @brief Carries fields and particles from one mesh to the next, to other
   * ranks, and into files: both travel attached to the cells.
   *
   * On refined cells fields are interpolated; coarsened cells keep the values
   * at the nodes that remain. Particles stay where they are, and each comes to
   * the cell that covers its place in the reference cell: none can get lost
   * between two cells.
   */
  template <int dim>
  class MeshTransfer
  {
  public:
    /// All populations that travel, always in the same order.
    using Populations = std::vector<std::reference_wrapper<Population<dim>>>;

    /// @param mesh, populations must outlive the object
    MeshTransfer(Mesh<dim> &mesh, const Populations &populations);

    /**
     * @brief Attaches @p state and the particles to the cells of the mesh,
     * which then may change; the populations are empty until unpack().
     * Collective.
     *
     * @param state the spaces of its fields must not go before the mesh has
     *   changed
     */
    void
    pack(const State<dim> &state);

    /**
     * @brief Gives @p state and the populations what belongs to the cells of
     * the new mesh. Collective.
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
     * @brief Gives @p state and the populations what pack_to_save() returned,
     * after keep(). Collective.
     * @param cells of this rank
     * @throws dealii::ExcMessage if they do not hold what they must
     */
    void
    unpack_saved(const State<dim> &state, const PackedCells &cells);

    /// Names which fields the cells carry, for the mesh that is loaded:
    /// those that nobody wants any more are passed over.
    void
    keep(const Archive &archive);

  private:
    using CellIterator = typename dealii::Triangulation<dim>::cell_iterator;
    using Bytes        = std::vector<char>;
    using ByteRange    = boost::iterator_range<typename Bytes::const_iterator>;
    /// The particles of each owned cell.
    using Received = std::vector<std::vector<ParticleRecord<dim>>>;

    /// Takes what is to be packed.
    void
    take(const State<dim> &state);

    /// Prepares the unpacking of cells.
    void
    begin_to_unpack(const State<dim> &state);

    /// Makes fields and particles whole when all cells are unpacked.
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

    /// Whether the particles that came are in their cells and carry numbers.
    /// @throws dealii::ExcMessage if not
    void
    check_received() const;

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

    void
    unpack_particle(ParticleRecord<dim>    particle,
                    const CellIterator    &cell,
                    const Compat::CellFate fate,
                    Received              &received) const;

    Mesh<dim>                     &mesh;
    const Populations              populations;
    std::vector<CarriedField<dim>> fields;
    /// The names of the fields, and how many values a cell has of each.
    std::vector<std::string>  names;
    std::vector<unsigned int> n_values;
    /// Ghosted copies of the fields that were packed.
    std::vector<Vector> values;
    /// Of each population what was packed, and what has come.
    std::vector<PopulationSnapshot<dim>> particles;
    std::vector<Received>                received;
    unsigned int handle = dealii::numbers::invalid_unsigned_int;
  };
} // namespace Thalweg

#endif
