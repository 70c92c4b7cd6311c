// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/dem/carried_grains.h>

#include <cmath>

namespace Thalweg
{
  template <int dim>
  void
  CarriedGrains<dim>::save()
  {
    saved                = grains.all();
    const unsigned int n = mesh.graph().n_owned_cells();
    begin_of_cell.assign(n + 1, 0);
    for (const GrainRecord &grain : saved.grains)
      ++begin_of_cell[grain.cell + 1];
    for (unsigned int c = 0; c < n; ++c)
      begin_of_cell[c + 1] += begin_of_cell[c];
    std::vector<std::uint32_t> next(begin_of_cell);
    of_cell.resize(saved.grains.size());
    for (std::uint32_t g = 0; g < saved.grains.size(); ++g)
      of_cell[next[saved.grains[g].cell]++] = g;
  }



  template <int dim>
  void
  CarriedGrains<dim>::restore()
  {
    grains.restore(saved, true);
  }



  template <int dim>
  void
  CarriedGrains<dim>::pack(const CellIterator    &cell,
                           const Compat::CellFate fate,
                           std::vector<char>     &bytes) const
  {
    const bool         is_coarsened = fate == Compat::CellFate::is_coarsened;
    const unsigned int n_sources    = is_coarsened ? cell->n_children() : 1u;
    std::uint32_t      n            = 0;
    const auto         index        = [&](const unsigned int c) {
      return mesh.graph().index(is_coarsened ? cell->child(c) : cell);
    };
    for (unsigned int c = 0; c < n_sources; ++c)
      n += begin_of_cell[index(c) + 1] - begin_of_cell[index(c)];
    append_plain(bytes, n);
    for (unsigned int c = 0; c < n_sources; ++c)
      for (auto k = begin_of_cell[index(c)]; k < begin_of_cell[index(c) + 1];
           ++k)
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
