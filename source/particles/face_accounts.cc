// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/particles/face_accounts.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>
#include <deal.II/grid/cell_id.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace Thalweg
{
  namespace
  {
    void
    add(FaceAccount &sum, const FaceAccount &account, const double share)
    {
      for (unsigned int f = 0; f < 2; ++f)
        {
          sum.waiting[f] += share * account.waiting[f];
          sum.owed[f] += share * account.owed[f];
        }
    }

    /// Whether @p text is the id of a cell, such as "3_2:01", as deal.II reads
    /// it without looking.
    bool
    is_cell_id(const std::string &text)
    {
      unsigned int coarse = 0, n_levels = 0;
      int          place = 0;
      if (std::sscanf(text.c_str(), "%9u_%2u:%n", &coarse, &n_levels, &place) <
            2 ||
          place == 0 || n_levels > 30 || text.size() != place + n_levels)
        return false;
      return std::all_of(text.begin() + place, text.end(), [](const char c) {
        return c >= '0' && c <= '7';
      });
    }

    /// How many levels @p descendant is finer than its @p ancestor.
    int
    levels_between(const dealii::CellId &ancestor,
                   const dealii::CellId &descendant)
    {
      return static_cast<int>(descendant.get_child_indices().size()) -
             static_cast<int>(ancestor.get_child_indices().size());
    }
  } // namespace


  template <int dim>
  FaceAccounts<dim>::FaceAccounts(const CellGraph<dim>     &graph,
                                  const BoundaryNodes<dim> &boundary)
    : graph(graph)
    , boundary(boundary)
    , accounts(boundary.passable_faces().size())
  {
    for (unsigned int i = 0; i < accounts.size(); ++i)
      {
        const auto &face                   = boundary.passable_faces()[i];
        numbers[{face.cell, face.face_no}] = i;
      }
  }


  template <int dim>
  void
  FaceAccounts<dim>::keep(const Archive &archive, const MPI_Comm communicator)
  {
    namespace MPI = dealii::Utilities::MPI;
    std::vector<std::string>  cells;
    std::vector<unsigned int> faces;
    std::vector<double>       values;
    if (!archive.is_restoring())
      {
        for (unsigned int i = 0; i < accounts.size(); ++i)
          {
            const auto &[waiting, owed] = accounts[i];
            if (waiting == FluidVolumes() && owed == FluidVolumes())
              continue;
            const auto &face = boundary.passable_faces()[i];
            cells.push_back(graph.iterator(face.cell)->id().to_string());
            faces.push_back(face.face_no);
            values.insert(values.end(),
                          {waiting[0], waiting[1], owed[0], owed[1]});
          }
        const auto gather = [&](auto &list) {
          const auto of_ranks = MPI::all_gather(communicator, list);
          list.clear();
          for (const auto &of_rank : of_ranks)
            list.insert(list.end(), of_rank.begin(), of_rank.end());
        };
        if (MPI::n_mpi_processes(communicator) > 1)
          {
            gather(cells);
            gather(faces);
            gather(values);
          }
      }
    archive.value("cells", cells);
    archive.value("faces", faces);
    archive.value("values", values);
    AssertThrow(faces.size() == cells.size() &&
                  values.size() == 4 * cells.size(),
                dealii::ExcMessage("the accounts of its faces are damaged."));
    AssertThrow(std::all_of(cells.begin(), cells.end(), is_cell_id),
                dealii::ExcMessage("a cell in the accounts of its faces has no "
                                   "name."));
    if (archive.is_restoring())
      distribute(cells, faces, values);
  }


  template <int dim>
  void
  FaceAccounts<dim>::distribute(const std::vector<std::string>  &cells,
                                const std::vector<unsigned int> &faces,
                                const std::vector<double>       &values)
  {
    accounts.assign(accounts.size(), FaceAccount());
    std::map<std::pair<std::string, unsigned int>, unsigned int> places;
    for (unsigned int i = 0; i < accounts.size(); ++i)
      {
        const auto &face = boundary.passable_faces()[i];
        places[{graph.iterator(face.cell)->id().to_string(), face.face_no}] = i;
      }
    for (unsigned int k = 0; k < cells.size(); ++k)
      {
        const auto        value = values.begin() + 4 * k;
        const FaceAccount account{{{value[0], value[1]}},
                                  {{value[2], value[3]}}};
        const auto        place = places.find({cells[k], faces[k]});
        if (place != places.end())
          add(accounts[place->second], account, 1.);
        else
          add_to_relatives(cells[k], faces[k], account);
      }
  }


  template <int dim>
  void
  FaceAccounts<dim>::add_to_relatives(const std::string &cell,
                                      const unsigned int face_no,
                                      const FaceAccount &account)
  {
    // Children have their parent's numbers of faces.
    const dealii::CellId id(cell);
    for (unsigned int i = 0; i < accounts.size(); ++i)
      {
        const auto &face = boundary.passable_faces()[i];
        if (face.face_no != face_no)
          continue;
        const dealii::CellId own = graph.iterator(face.cell)->id();
        if (id.is_ancestor_of(own))
          add(accounts[i],
              account,
              std::pow(.5, (dim - 1) * levels_between(id, own)));
        else if (own.is_ancestor_of(id))
          add(accounts[i], account, 1.);
      }
  }
} // namespace Thalweg

THALWEG_INSTANTIATE(Thalweg::FaceAccounts)
