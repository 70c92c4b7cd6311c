// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_carried_grains_h
#define thalweg_dem_carried_grains_h

#include <thalweg/dem/grain_system.h>
#include <thalweg/fields/carried.h>
#include <thalweg/mesh/mesh.h>

namespace Thalweg
{
  /**
   * @brief Grains with their contacts as they travel with the cells of a mesh:
   * each with the cell that held its center at the last rebuild.
   */
  template <int dim>
  class CarriedGrains : public Carried<dim>
  {
  public:
    using typename Carried<dim>::CellIterator;

    /// @param grains what is carried; like @p mesh it must outlive the object
    CarriedGrains(GrainSystem &grains, const Mesh<dim> &mesh)
      : grains(grains)
      , mesh(mesh)
    {}

    void
    save() override;

    void
    restore() override;

    void
    clear() override
    {
      grains.clear();
    }

    void
    pack(const CellIterator    &cell,
         const Compat::CellFate fate,
         std::vector<char>     &bytes) const override;

    void
    begin_to_unpack() override
    {
      received = GrainSet();
    }

    void
    unpack(const CellIterator &,
           const Compat::CellFate,
           PlainReader &reader) override;

    void
    check_unpacked() const override;

    void
    end_to_unpack() override
    {
      grains.restore(received);
      received = GrainSet();
    }

    /// How many materials there are, to check what comes out of files.
    unsigned int n_materials = 1;

  private:
    GrainSystem     &grains;
    const Mesh<dim> &mesh;
    GrainSet         saved, received;
    /// The saved grains of each cell: which of them, and where they begin.
    std::vector<unsigned int> of_cell, begin_of_cell;
  };
} // namespace Thalweg

#endif
