// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/mesh/cell_graph.h>
#include <thalweg/mesh/mesh_partition.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Thalweg
{
  namespace
  {
    /// Whether the edges of a cell are those of an axis-parallel box in
    /// deal.II's standard orientation.
    template <int dim>
    bool
    is_axis_parallel(const std::array<dealii::Point<dim>, (1 << dim)> &vertices)
    {
      const dealii::Tensor<1, dim> extent = vertices.back() - vertices.front();
      const double                 tolerance =
        1e-10 * extent.norm() + coordinate_round_off(vertices.front());
      for (unsigned int v = 0; v < vertices.size(); ++v)
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double expected =
              vertices[0][d] + ((v >> d) & 1u ? extent[d] : 0.);
            if (extent[d] <= 0 ||
                std::abs(vertices[v][d] - expected) > tolerance)
              return false;
          }
      return true;
    }

    /// The derivatives of a cell's map at @p xi, those with respect to xi[d] in
    /// entry d. They are sums of edges: products of coordinates would lose
    /// their digits far from the origin.
    template <int dim>
    dealii::Tensor<2, dim>
    derivatives(const std::array<dealii::Point<dim>, (1 << dim)> &vertices,
                const dealii::Point<dim>                         &xi)
    {
      dealii::Tensor<2, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int v = 0; v < vertices.size(); ++v)
          if (((v >> d) & 1u) == 0)
            {
              double shape = 1.;
              for (unsigned int e = 0; e < dim; ++e)
                if (e != d)
                  shape *= (v >> e) & 1u ? xi[e] : 1. - xi[e];
              result[d] += shape * (vertices[v + (1u << d)] - vertices[v]);
            }
      return result;
    }



    /// The volume of a cell with straight edges: Gauss's rule of two points a
    /// direction is exact for the determinant of its map.
    template <int dim>
    double
    measure_of(const std::array<dealii::Point<dim>, (1 << dim)> &vertices)
    {
      const dealii::QGauss<dim> gauss(2);
      double                    measure = 0.;
      for (unsigned int q = 0; q < gauss.size(); ++q)
        measure += gauss.weight(q) *
                   determinant(derivatives<dim>(vertices, gauss.point(q)));
      return measure;
    }



    /// Appends the active cells inside @p cell in the order of its children,
    /// which is that of p4est's curve.
    template <int dim>
    void
    append_active(
      const typename dealii::Triangulation<dim>::cell_iterator &cell,
      std::vector<typename CellGraph<dim>::CellIterator>       &cells)
    {
      if (cell->is_active())
        cells.push_back(cell);
      else
        for (unsigned int c = 0; c < cell->n_children(); ++c)
          append_active<dim>(cell->child(c), cells);
    }



    /// The active cells along p4est's curve. Where there is no p4est the
    /// coarse cells stand in its order.
    template <int dim>
    std::vector<typename CellGraph<dim>::CellIterator>
    in_order(const dealii::parallel::DistributedTriangulationBase<dim> &tria)
    {
      using Forest = dealii::parallel::distributed::Triangulation<dim>;
      std::vector<typename CellGraph<dim>::CellIterator> cells;
      cells.reserve(tria.n_active_cells());
      if (const auto *forest = dynamic_cast<const Forest *>(&tria))
        for (const auto coarse :
             forest->get_p4est_tree_to_coarse_cell_permutation())
          append_active<dim>(typename dealii::Triangulation<dim>::cell_iterator(
                               &tria, 0, coarse),
                             cells);
      else
        for (const auto &coarse : tria.cell_iterators_on_level(0))
          append_active<dim>(coarse, cells);
      return cells;
    }
  } // namespace



  template <int dim>
  std::pair<double, double>
  CellGraph<dim>::Cell::edges() const
  {
    double shortest = std::numeric_limits<double>::max(), longest = 0.;
    for (unsigned int v = 0; v < n_vertices; ++v)
      for (unsigned int d = 0; d < dim; ++d)
        if (((v >> d) & 1u) == 0)
          {
            const double length =
              (vertices[v + (1u << d)] - vertices[v]).norm();
            shortest = std::min(shortest, length);
            longest  = std::max(longest, length);
          }
    return {shortest, longest};
  }



  template <int dim>
  void
  CellGraph<dim>::build(
    const dealii::parallel::DistributedTriangulationBase<dim> &tria)
  {
    cells.clear();
    iterators.clear();
    children.clear();
    offsets.clear();
    index_of_active_cell.assign(tria.n_active_cells(),
                                dealii::numbers::invalid_unsigned_int);
    axis_parallel = true;
    shortest_edge = std::numeric_limits<double>::max();

    const auto all = in_order(tria);
    for (const auto &cell : all)
      if (cell->is_locally_owned())
        add_cell(cell);
    n_owned = cells.size();
    for (const auto &cell : all)
      if (cell->is_ghost())
        add_cell(cell);
    number_globally(tria);

    for (unsigned int c = 0; c < n_owned; ++c)
      for (unsigned int f = 0; f < n_faces; ++f)
        cells[c].faces[f] = face_behind(iterators[c], f);
    // A rank may have a hanging node that depends on one behind a periodic
    // boundary, but none of the faces there.
    for (const auto &others :
         dealii::Utilities::MPI::all_gather(tria.get_communicator(), offsets))
      for (const auto &offset : others)
        if (std::none_of(
              offsets.begin(), offsets.end(), [&offset](const auto &known) {
                return (known - offset).norm() <= 1e-6 * offset.norm();
              }))
          offsets.push_back(offset);
  }



  template <int dim>
  void
  CellGraph<dim>::add_cell(const CellIterator &cell)
  {
    Cell entry;
    for (unsigned int v = 0; v < n_vertices; ++v)
      entry.vertices[v] = cell->vertex(v);
    entry.axis_parallel = is_axis_parallel<dim>(entry.vertices);
    entry.extent        = entry.vertices.back() - entry.vertices.front();
    if (entry.axis_parallel)
      {
        entry.measure = 1.;
        for (unsigned int d = 0; d < dim; ++d)
          entry.measure *= entry.extent[d];
      }
    else
      entry.measure = measure_of<dim>(entry.vertices);
    for (unsigned int d = 0; d < dim; ++d)
      entry.inverse_extent[d] = entry.axis_parallel ? 1. / entry.extent[d] : 0.;
    entry.owner = cell->subdomain_id();

    axis_parallel = axis_parallel && entry.axis_parallel;
    if (cell->is_locally_owned())
      shortest_edge = std::min(shortest_edge, entry.edges().first);

    index_of_active_cell[cell->active_cell_index()] = cells.size();
    cells.push_back(entry);
    iterators.push_back(cell);
  }



  template <int dim>
  void
  CellGraph<dim>::number_globally(
    const dealii::parallel::DistributedTriangulationBase<dim> &tria)
  {
    using Number = dealii::types::global_cell_index;
    // Ranks own consecutive numbers.
    first_global_index =
      tria.global_active_cell_index_partitioner().lock()->local_range().first;
    for (unsigned int c = 0; c < n_owned; ++c)
      cells[c].global_index = first_global_index + c;
    dealii::GridTools::exchange_cell_data_to_ghosts<Number>(
      tria,
      [&](const auto &cell) { return cells[index(cell)].global_index; },
      [&](const auto &cell, const Number number) {
        cells[index(cell)].global_index = number;
      });
  }



  template <int dim>
  bool
  CellGraph<dim>::at_boundary(const unsigned int cell,
                              const unsigned int face_no) const
  {
    const auto &iterator = iterators[cell];
    return iterator->at_boundary(face_no) &&
           !iterator->has_periodic_neighbor(face_no) &&
           iterator->face(face_no)->boundary_id() != unknown_neighbor;
  }



  template <int dim>
  typename CellGraph<dim>::Face
  CellGraph<dim>::face_behind(const CellIterator &cell,
                              const unsigned int  face_no)
  {
    Face       face;
    const bool is_periodic = cell->has_periodic_neighbor(face_no);
    if (cell->at_boundary(face_no) && !is_periodic)
      {
        face.boundary_id = cell->face(face_no)->boundary_id();
        return face;
      }

    const auto neighbor =
      is_periodic ? cell->periodic_neighbor(face_no) : cell->neighbor(face_no);
    if (is_periodic)
      {
        const unsigned int     direction = face_no / 2;
        dealii::Tensor<1, dim> offset;
        offset[direction] =
          neighbor->face(cell->periodic_neighbor_face_no(face_no))
            ->center()[direction] -
          cell->face(face_no)->center()[direction];
        unsigned int o = 0;
        while (o < offsets.size() &&
               (offsets[o] - offset).norm() >
                 1e-10 * offset.norm() +
                   coordinate_round_off(cell->face(face_no)->center()))
          ++o;
        if (o == offsets.size())
          offsets.push_back(offset);
        face.periodic = o;
      }

    if (neighbor->has_children())
      {
        face.behind = Behind::refined;
        std::array<int, n_face_children> behind;
        for (unsigned int s = 0; s < n_face_children; ++s)
          behind[s] = index(
            is_periodic ? cell->periodic_neighbor_child_on_subface(face_no, s)
                        : cell->neighbor_child_on_subface(face_no, s));
        face.index = children.size();
        children.push_back(behind);
      }
    else
      {
        face.behind = Behind::cell;
        face.index  = index_of_active_cell[neighbor->active_cell_index()];
      }
    return face;
  }



  THALWEG_INSTANTIATE(CellGraph)
} // namespace Thalweg
