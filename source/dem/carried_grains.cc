// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/dem/carried_grains.h>
#include <thalweg/mesh/cell_order.h>

#include <cmath>

namespace Thalweg
{
  template <int dim>
  void
  CarriedGrains<dim>::save()
  {
    saved = grains.all();
    std::vector<unsigned int> cells;
    for (const GrainRecord &grain : saved.grains)
      cells.push_back(grain.cell);
    CellOrder order(cells, mesh.graph().n_owned_cells());
    of_cell.swap(order.things);
    begin_of_cell.swap(order.begin);
  }



  template <int dim>
  void
  CarriedGrains<dim>::restore()
  {
    grains.restore(saved);
  }



  template <int dim>
  void
  CarriedGrains<dim>::pack(const CellIterator    &cell,
                           const Compat::CellFate fate,
                           std::vector<char>     &bytes) const
  {
    const auto    sources = this->cells_before(mesh.graph(), cell, fate);
    std::uint32_t n       = 0;
    for (const unsigned int c : sources)
      n += begin_of_cell[c + 1] - begin_of_cell[c];
    append_plain(bytes, n);
    for (const unsigned int c : sources)
      for (auto k = begin_of_cell[c]; k < begin_of_cell[c + 1]; ++k)
        {
          const std::uint32_t g        = of_cell[k];
          const auto         &contacts = saved.contacts;
          append_plain(bytes, saved.grains[g]);
          append_plain(bytes, contacts.begin[g + 1] - contacts.begin[g]);
          append_plain(bytes, saved.wall_begin[g + 1] - saved.wall_begin[g]);
          for (auto i = contacts.begin[g]; i < contacts.begin[g + 1]; ++i)
            append_plain(bytes, contacts.contacts[i]);
          for (auto i = saved.wall_begin[g]; i < saved.wall_begin[g + 1]; ++i)
            append_plain(bytes, saved.walls[i]);
        }
  }



  template <int dim>
  void
  CarriedGrains<dim>::unpack(const CellIterator &,
                             const Compat::CellFate,
                             PlainReader &reader)
  {
    std::uint32_t n = 0;
    reader.read(n);
    std::vector<ContactRecord> contacts;
    std::vector<WallMemory>    walls;
    const auto                 read_list = [&](auto &list, const auto length) {
      AssertThrow(length <= reader.left() / sizeof(list[0]),
                  dealii::ExcMessage("its grains are cut short"));
      list.resize(length);
      for (auto &entry : list)
        reader.read(entry);
    };
    for (std::uint32_t g = 0; g < n; ++g)
      {
        GrainRecord   grain;
        std::uint32_t n_contacts = 0, n_walls = 0;
        reader.read(grain);
        reader.read(n_contacts);
        reader.read(n_walls);
        read_list(contacts, n_contacts);
        read_list(walls, n_walls);
        received.append(
          grain, contacts.data(), n_contacts, walls.data(), n_walls);
      }
  }



  template <int dim>
  void
  CarriedGrains<dim>::check_unpacked() const
  {
    const auto is_finite = [](const Vec3 &v) {
      return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    for (const GrainRecord &grain : received.grains)
      AssertThrow(is_finite(grain.x) && is_finite(grain.v) &&
                    is_finite(grain.w) && is_finite(grain.force) &&
                    is_finite(grain.torque) && is_finite(grain.reference) &&
                    std::isfinite(grain.r) && grain.r > 0. &&
                    grain.material < n_materials,
                  dealii::ExcMessage("it has grains that cannot be."));
  }



  THALWEG_INSTANTIATE(CarriedGrains)
} // namespace Thalweg
