// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/plain_text.h>
#include <thalweg/core/spelling.h>
#include <thalweg/mesh/boundary_name.h>
#include <thalweg/mesh/cell_count.h>
#include <thalweg/mesh/cell_graph.h>
#include <thalweg/mesh/mesh_plan.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/utilities.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cmath>
#include <set>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    template <int dim>
    std::uint64_t
    checksum_of_coarse(const dealii::Triangulation<dim> &tria)
    {
      boost::crc_32_type crc;
      const auto         add = [&](const auto &value) {
        crc.process_bytes(&value, sizeof(value));
      };
      for (const auto &cell : tria.cell_iterators_on_level(0))
        {
          for (const unsigned int v : cell->vertex_indices())
            for (unsigned int d = 0; d < dim; ++d)
              add(cell->vertex(v)[d]);
          for (const unsigned int f : cell->face_indices())
            add(cell->face(f)->boundary_id());
        }
      return crc.checksum();
    }
    template <int dim>
    double
    level_at(const dealii::FunctionParser<dim> &levels,
             const dealii::Point<dim>          &x)
    {
      const double       level = levels.value(x);
      std::ostringstream message;
      message << "'Refinement/Local levels' is " << level << " at (" << x
              << "). It must be a finite number everywhere.";
      AssertThrow(std::isfinite(level), dealii::ExcMessage(message.str()));
      // More is refused beforehand, where that is known.
      return std::clamp<double>(level, -highest_level<dim>, highest_level<dim>);
    }



    template <int dim>
    std::pair<dealii::Point<dim>, dealii::Point<dim>>
    box_around(const dealii::Triangulation<dim> &coarse)
    {
      auto box =
        std::make_pair(coarse.get_vertices()[0], coarse.get_vertices()[0]);
      for (const auto &cell : coarse.cell_iterators_on_level(0))
        for (const unsigned int v : cell->vertex_indices())
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double x = cell->vertex(v)[d];
              box.first[d]   = std::min(box.first[d], x);
              box.second[d]  = std::max(box.second[d], x);
            }
      return box;
    }
  } // namespace



  template <int dim>
  void
  MeshParameters<dim>::declare(const Section &root)
  {
    {
      const Section section = root.enter("Geometry");
      geometry.declare_parameters(section,
                                  "box",
                                  "domain with its coarse mesh");
      section.add(
        "Periodic boundaries",
        periodic_boundaries,
        "",
        "Pairs of boundary names joined by a colon, for example 'left:right, "
        "bottom:top'. What leaves through one comes in through the other.");
    }
    {
      const Section section = root.enter("Refinement");
      section.add("Global levels",
                  global_refinement,
                  "",
                  "How often every cell of the coarse mesh is refined.",
                  dealii::Patterns::Integer(0, highest_level<dim>));
      section.add("Local levels",
                  local_refinement,
                  "",
                  "How often a cell is refined beyond the global levels: an "
                  "expression of the cell's centre, for example "
                  "'if(y < 0.3, 2, 0)'.");
      section.add(
        "Memory limit",
        memory_limit,
        "GB",
        "A mesh is refused before it is made if its cells and "
        "particles need more memory, as far as that can be estimated. "
        "0: as much as the machines have.",
        dealii::Patterns::Double(0.));
    }
    {
      const Section section = root.enter("Partition");
      partition.declare_parameters(section,
                                   "p4est",
                                   "way to distribute the cells over the "
                                   "processes");
    }
  }



  dealii::types::boundary_id
  find_boundary(const BoundaryNames &names, const std::string &name)
  {
    const auto entry = names.find(name);
    if (entry != names.end())
      return entry->second;
    std::vector<std::string> all;
    for (const auto &[existing, id] : names)
      all.push_back(existing);
    const std::string suggestion = nearest(name, all);
    AssertThrow(false,
                dealii::ExcMessage(
                  "There is no boundary '" + excerpt(name) +
                  "'. The geometry has '" + joined(all, "', '") + "'" +
                  (suggestion.empty() ? "." : did_you_mean(suggestion))));
    return dealii::numbers::invalid_boundary_id;
  }



  template <int dim>
  MeshPlan<dim>::MeshPlan(const MeshParameters<dim> &parameters)
    : parameters(parameters)
  {}



  template <int dim>
  std::unique_ptr<typename MeshPlan<dim>::Forest>
  MeshPlan<dim>::empty_forest(const MPI_Comm communicator)
  {
    return std::make_unique<Forest>(
      communicator, Triangulation::limit_level_difference_at_vertices);
  }



  template <int dim>
  void
  MeshPlan<dim>::create_coarse(Triangulation &tria)
  {
    parameters.geometry->create(tria);
    names = parameters.geometry->boundary_names();
    periodic.clear();
    std::set<dealii::types::boundary_id> joined;
    for (const std::string &pair : parameters.periodic_boundaries)
      {
        periodic.push_back(find_periodic_pair(tria, pair));
        for (const auto id : {periodic.back().first, periodic.back().second})
          AssertThrow(joined.insert(id).second,
                      dealii::ExcMessage(
                        "'Geometry/Periodic boundaries' names the boundary '" +
                        boundary_name(names, id) +
                        "' more than once; it can have one partner only."));
      }
    check_periodic_faces(tria);
    join_periodic_boundaries(tria);
    checksum = checksum_of_coarse(tria);
    corners  = box_around(tria);
  }



  template <int dim>
  void
  MeshPlan<dim>::refine(Triangulation &tria) const
  {
    tria.refine_global(parameters.global_refinement);
    dealii::FunctionParser<dim> levels;
    levels.initialize(dealii::FunctionParser<dim>::default_variable_names(),
                      parameters.local_refinement,
                      {{"pi", dealii::numbers::PI}});
    bool any = true;
    while (any)
      {
        any = false;
        for (const auto &cell : tria.active_cell_iterators())
          if (cell->is_locally_owned() &&
              cell->level() < static_cast<int>(parameters.global_refinement) +
                                static_cast<int>(std::lround(
                                  level_at(levels, cell->center()))))
            {
              cell->set_refine_flag();
              any = true;
            }
        any = dealii::Utilities::MPI::logical_or(any, tria.get_communicator());
        if (any)
          tria.execute_coarsening_and_refinement();
      }
  }



  template <int dim>
  PeriodicPair
  MeshPlan<dim>::find_periodic_pair(const Triangulation &tria,
                                    const std::string   &pair_of_names) const
  {
    const auto parts = dealii::Utilities::split_string_list(pair_of_names, ':');
    AssertThrow(parts.size() == 2,
                dealii::ExcMessage("'" + pair_of_names +
                                   "' in 'Geometry/Periodic boundaries' is no "
                                   "pair of names; write, for example, "
                                   "'left:right'."));
    PeriodicPair           pair{find_boundary(names, parts[0]),
                      find_boundary(names, parts[1]),
                      0};
    dealii::Point<dim>     first[2];
    dealii::Tensor<1, dim> centers[2];
    unsigned int           n_faces[2] = {0, 0};
    for (const auto &cell : tria.cell_iterators_on_level(0))
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f))
          for (const unsigned int side : {0, 1})
            if (cell->face(f)->boundary_id() ==
                (side == 0 ? pair.first : pair.second))
              {
                // From the first one, to keep digits far from the origin.
                if (n_faces[side] == 0)
                  first[side] = cell->face(f)->center();
                centers[side] += cell->face(f)->center() - first[side];
                ++n_faces[side];
              }
    AssertThrow(n_faces[0] == n_faces[1] && n_faces[0] > 0,
                dealii::ExcMessage(
                  "The boundaries of the periodic pair '" + pair_of_names +
                  "' do not match: one has " + std::to_string(n_faces[0]) +
                  " faces, the other " + std::to_string(n_faces[1]) + "."));
    const auto distance =
      (first[1] - first[0]) + (centers[1] - centers[0]) / double(n_faces[0]);
    for (unsigned int d = 1; d < dim; ++d)
      if (std::abs(distance[d]) > std::abs(distance[pair.direction]))
        pair.direction = d;
    for (unsigned int d = 0; d < dim; ++d)
      AssertThrow(d == pair.direction ||
                    std::abs(distance[d]) <=
                      1e-8 * std::abs(distance[pair.direction]) +
                        coordinate_round_off(first[0]),
                  dealii::ExcMessage("The boundaries of the periodic pair '" +
                                     pair_of_names +
                                     "' do not face each other along an "
                                     "axis."));
    return pair;
  }



  template <int dim>
  void
  MeshPlan<dim>::check_periodic_faces(const Triangulation &tria) const
  {
    using CellIterator = typename Triangulation::cell_iterator;
    for (const PeriodicPair &pair : periodic)
      {
        std::vector<dealii::GridTools::PeriodicFacePair<CellIterator>> faces;
        bool does_match = true;
        try
          {
            dealii::GridTools::collect_periodic_faces(
              tria, pair.first, pair.second, pair.direction, faces);
          }
        catch (const dealii::ExceptionBase &)
          {
            does_match = false;
          }
        AssertThrow(does_match,
                    dealii::ExcMessage(
                      "The nodes of the periodic boundaries '" +
                      boundary_name(names, pair.first) + "' and '" +
                      boundary_name(names, pair.second) +
                      "' do not match: each face of one needs a face of the "
                      "other that it faces along " +
                      "xyz"[pair.direction] + "."));
      }
  }



  template <int dim>
  void
  MeshPlan<dim>::join_periodic_boundaries(Triangulation &tria) const
  {
    using CellIterator = typename Triangulation::cell_iterator;
    std::vector<dealii::GridTools::PeriodicFacePair<CellIterator>> faces;
    for (const PeriodicPair &pair : periodic)
      dealii::GridTools::collect_periodic_faces(
        tria, pair.first, pair.second, pair.direction, faces);
    if (!faces.empty())
      tria.add_periodicity(faces);
  }



  template struct MeshParameters<2>;
  template struct MeshParameters<3>;
  THALWEG_INSTANTIATE(MeshPlan)
} // namespace Thalweg
