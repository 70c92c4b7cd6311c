#include <thalweg/mesh/mesh.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/utilities.h>
#include <deal.II/grid/grid_tools.h>

#include <boost/crc.hpp>

namespace Thalweg
{
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
                  dealii::Patterns::Integer(0, 20));
      section.add("Local levels",
                  local_refinement,
                  "",
                  "How often a cell is refined beyond the global levels: an "
                  "expression of the cell's centre, for example "
                  "'if(y < 0.3, 2, 0)'.");
    }
  }



  template <int dim>
  Mesh<dim>::Mesh(const MPI_Comm communicator)
    : tria(communicator,
           dealii::Triangulation<dim>::limit_level_difference_at_vertices)
  {}



  template <int dim>
  void
  Mesh<dim>::create_coarse(const MeshParameters<dim> &parameters)
  {
    parameters.geometry->create(tria);
    names = parameters.geometry->boundary_names();
    join_periodic_boundaries(parameters.periodic_boundaries);
  }



  template <int dim>
  void
  Mesh<dim>::create(const MeshParameters<dim> &parameters)
  {
    create_coarse(parameters);
    tria.refine_global(parameters.global_refinement);
    refine_locally(parameters.global_refinement, parameters.local_refinement);
    update();
  }



  template <int dim>
  std::uint64_t
  Mesh<dim>::coarse_checksum() const
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
  void
  Mesh<dim>::update()
  {
    cell_graph.build(tria);
  }



  template <int dim>
  dealii::types::boundary_id
  Mesh<dim>::boundary_id(const std::string &name) const
  {
    const auto entry = names.find(name);
    if (entry != names.end())
      return entry->second;
    std::string all;
    for (const auto &[existing, id] : names)
      all += (all.empty() ? "'" : ", '") + existing + "'";
    AssertThrow(false,
                dealii::ExcMessage("There is no boundary '" + name +
                                   "'. The geometry has " + all + "."));
    return dealii::numbers::invalid_boundary_id;
  }



  template <int dim>
  typename Mesh<dim>::PeriodicPair
  Mesh<dim>::find_periodic_pair(const std::string &names) const
  {
    const auto parts = dealii::Utilities::split_string_list(names, ':');
    AssertThrow(parts.size() == 2,
                dealii::ExcMessage("'" + names +
                                   "' in 'Geometry/Periodic boundaries' is no "
                                   "pair of names; write, for example, "
                                   "'left:right'."));
    PeriodicPair       pair{boundary_id(parts[0]), boundary_id(parts[1]), 0};
    dealii::Point<dim> centers[2];
    unsigned int       n_faces[2] = {0, 0};
    for (const auto &cell : tria.cell_iterators_on_level(0))
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f))
          for (const unsigned int side : {0, 1})
            if (cell->face(f)->boundary_id() ==
                (side == 0 ? pair.first : pair.second))
              {
                centers[side] += cell->face(f)->center();
                ++n_faces[side];
              }
    AssertThrow(n_faces[0] == n_faces[1] && n_faces[0] > 0,
                dealii::ExcMessage(
                  "The boundaries of the periodic pair '" + names +
                  "' do not match: one has " + std::to_string(n_faces[0]) +
                  " faces, the other " + std::to_string(n_faces[1]) + "."));
    const auto distance = centers[1] - centers[0];
    for (unsigned int d = 1; d < dim; ++d)
      if (std::abs(distance[d]) > std::abs(distance[pair.direction]))
        pair.direction = d;
    for (unsigned int d = 0; d < dim; ++d)
      AssertThrow(d == pair.direction ||
                    std::abs(distance[d]) <=
                      1e-8 * std::abs(distance[pair.direction]),
                  dealii::ExcMessage("The boundaries of the periodic pair '" +
                                     names +
                                     "' do not face each other along an "
                                     "axis."));
    return pair;
  }



  template <int dim>
  void
  Mesh<dim>::join_periodic_boundaries(const std::vector<std::string> &pairs)
  {
    using CellIterator = typename Triangulation::cell_iterator;
    std::vector<dealii::GridTools::PeriodicFacePair<CellIterator>> faces;
    for (const std::string &pair : pairs)
      {
        periodic.push_back(find_periodic_pair(pair));
        dealii::GridTools::collect_periodic_faces(tria,
                                                  periodic.back().first,
                                                  periodic.back().second,
                                                  periodic.back().direction,
                                                  faces);
      }
    if (!faces.empty())
      tria.add_periodicity(faces);
  }



  template <int dim>
  void
  Mesh<dim>::refine_locally(const unsigned int global_levels,
                            const std::string &extra_levels)
  {
    dealii::FunctionParser<dim> levels;
    levels.initialize(dealii::FunctionParser<dim>::default_variable_names(),
                      extra_levels,
                      {{"pi", dealii::numbers::PI}});
    bool any = true;
    while (any)
      {
        any = false;
        for (const auto &cell : tria.active_cell_iterators())
          if (cell->is_locally_owned() &&
              cell->level() <
                static_cast<int>(global_levels) +
                  static_cast<int>(std::lround(levels.value(cell->center()))))
            {
              cell->set_refine_flag();
              any = true;
            }
        any = dealii::Utilities::MPI::logical_or(any, tria.get_communicator());
        if (any)
          tria.execute_coarsening_and_refinement();
      }
  }



  template struct MeshParameters<2>;
  template struct MeshParameters<3>;
  THALWEG_INSTANTIATE(Mesh)
} // namespace Thalweg
