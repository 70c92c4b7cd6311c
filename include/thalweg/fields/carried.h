// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_carried_h
#define thalweg_fields_carried_h

#include <thalweg/core/bytes.h>
#include <thalweg/core/compat_weights.h>
#include <thalweg/mesh/cell_graph.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief What sits in cells beside fields, particles for example, and goes
   * along when these are refined, coarsened, given to another rank, or saved.
   *
   * It is named in a State, and MeshTransfer and StepSnapshot do the rest.
   */
  template <int dim>
  class Carried
  {
  public:
    using CellIterator = typename dealii::Triangulation<dim>::cell_iterator;

    virtual ~Carried() = default;

    /// Remembers all that there is, until the next call.
    virtual void
    save() = 0;

    /// Makes all what it was at the last save(), on the same mesh. Collective.
    virtual void
    restore() = 0;

    /// Removes all but what save() remembers.
    virtual void
    clear() = 0;

    /**
     * @brief Appends what was in a cell at the last save().
     * @param cell an owned one of the mesh as it was then, or, if it is
     *   coarsened, the parent of such
     */
    virtual void
    pack(const CellIterator    &cell,
         const Compat::CellFate fate,
         std::vector<char>     &bytes) const = 0;

    /// Prepares unpack() for all owned cells of the new mesh.
    virtual void
    begin_to_unpack() = 0;

    /**
     * @brief Takes what pack() has written.
     * @param cell an owned one of the new mesh, or, if it is refined, the
     *   parent of such
     * @throws dealii::ExcMessage if @p reader has too little
     */
    virtual void
    unpack(const CellIterator    &cell,
           const Compat::CellFate fate,
           PlainReader           &reader) = 0;

    /// Looks at what came from a file.
    /// @throws dealii::ExcMessage if it cannot be
    virtual void
    check_unpacked() const = 0;

    /// Makes what came all that there is. Collective.
    virtual void
    end_to_unpack() = 0;

  protected:
    /// The owned cells of the mesh as it was at the last save() from which
    /// pack() is to write: the cell itself, or its children in their order.
    static std::vector<unsigned int>
    cells_before(const CellGraph<dim>  &graph,
                 const CellIterator    &cell,
                 const Compat::CellFate fate)
    {
      if (fate != Compat::CellFate::is_coarsened)
        return {graph.index(cell)};
      std::vector<unsigned int> children;
      for (unsigned int c = 0; c < cell->n_children(); ++c)
        children.push_back(graph.index(cell->child(c)));
      return children;
    }
  };
} // namespace Thalweg

#endif
