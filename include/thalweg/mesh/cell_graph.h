// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_cell_graph_h
#define thalweg_mesh_cell_graph_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>
#include <deal.II/distributed/tria_base.h>

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace Thalweg
{
  /// How much the coordinates of a point may differ from what was meant, m:
  /// some units in their last place.
  template <int dim>
  inline double
  coordinate_round_off(const dealii::Point<dim> &point)
  {
    return 8. * std::numeric_limits<double>::epsilon() * point.norm();
  }



  /**
   * @brief The locally owned and ghost cells of a mesh in flat arrays: their
   * corners, and what lies behind each face.
   *
   * Particles walk through millions of cells a step; this copy of what they
   * need costs one pass after each change of the mesh and spares them the
   * triangulation. Cells are numbered with the locally owned ones first, then
   * the ghost cells, both along p4est's space-filling curve, also where METIS
   * has cut the mesh into parts. Unlike the order of the triangulation this
   * one only depends on the mesh as it is, not on how it was refined and
   * coarsened: sums over cells have the same bits before and after a
   * restart.
   */
  template <int dim>
  class CellGraph
  {
  public:
    static constexpr unsigned int n_faces         = 2 * dim;
    static constexpr unsigned int n_vertices      = 1 << dim;
    static constexpr unsigned int n_face_children = 1 << (dim - 1);

    /// What lies behind a face.
    enum class Behind : std::uint8_t
    {
      /// one cell, of the same or a coarser level
      cell,
      /// the 2^(dim-1) children of a refined neighbour
      refined,
      /// the end of the domain
      boundary
    };

    /// A face as seen from a cell.
    struct Face
    {
      Behind behind = Behind::boundary;
      /// Index into periodic_offsets() of the vector to be added to the
      /// position of a particle that passes, -1 for none.
      std::int8_t periodic = -1;
      /// Of the boundary, where there is one behind.
      dealii::types::boundary_id boundary_id =
        dealii::numbers::invalid_boundary_id;
      /// The cell behind; for a refined neighbour an index into
      /// face_children().
      int index = -1;
    };

    /// A cell and its faces; faces of ghost cells are not filled.
    struct Cell
    {
      /// Corners in deal.II's order.
      std::array<dealii::Point<dim>, n_vertices> vertices;
      /// Whether the edges are parallel to the axes, in the usual
      /// orientation: then x = vertices[0] + xi * extent.
      bool                      axis_parallel;
      dealii::Tensor<1, dim>    extent;
      dealii::Tensor<1, dim>    inverse_extent;
      double                    measure;
      std::array<Face, n_faces> faces;
      /// The rank that owns the cell.
      dealii::types::subdomain_id owner;
      /// The place among all cells of all ranks; each rank's are consecutive.
      dealii::types::global_cell_index global_index;

      /// The lengths of the shortest and the longest edge, m.
      std::pair<double, double>
      edges() const;
    };

    using CellIterator =
      typename dealii::Triangulation<dim>::active_cell_iterator;

    /// Reads the triangulation anew; call it after every change of the mesh.
    void
    build(const dealii::parallel::DistributedTriangulationBase<dim> &tria);

    /// The number of locally owned cells, which are the first ones.
    unsigned int
    n_owned_cells() const
    {
      return n_owned;
    }

    /// The number of locally owned and ghost cells.
    unsigned int
    n_cells() const
    {
      return cells.size();
    }

    const Cell &
    cell(const unsigned int index) const
    {
      return cells[index];
    }

    /// The cell in the triangulation.
    const CellIterator &
    iterator(const unsigned int index) const
    {
      return iterators[index];
    }

    /// The number of the locally owned or ghost cell @p cell in this graph.
    unsigned int
    index(const CellIterator &cell) const
    {
      return index_of_active_cell[cell->active_cell_index()];
    }

    /// The same from `active_cell_index()`.
    unsigned int
    index_from_active_cell_index(const unsigned int active_cell_index) const
    {
      return index_of_active_cell[active_cell_index];
    }

    /// The number of the locally owned cell with this global index.
    unsigned int
    owned_index(const dealii::types::global_cell_index global_index) const
    {
      return global_index - first_global_index;
    }

    /// Whether the domain ends at a face of an owned or ghost cell; at
    /// periodic boundaries it does not, nor where a ghost cell's neighbour is
    /// unknown here.
    bool
    at_boundary(const unsigned int cell, const unsigned int face_no) const;

    /// The cells behind a face with a refined neighbour.
    const std::array<int, n_face_children> &
    face_children(const int index) const
    {
      return children[index];
    }

    /// Offsets that particles get when they pass a periodic face.
    const std::vector<dealii::Tensor<1, dim>> &
    periodic_offsets() const
    {
      return offsets;
    }

    /// Whether all cells that this rank knows are axis-parallel.
    bool
    all_axis_parallel() const
    {
      return axis_parallel;
    }

    /// The shortest edge over all locally owned cells (local to the rank).
    double
    minimal_extent() const
    {
      return shortest_edge;
    }

  private:
    void
    add_cell(const CellIterator &cell);

    /// Numbers the cells over all ranks. Collective.
    void
    number_globally(
      const dealii::parallel::DistributedTriangulationBase<dim> &tria);

    Face
    face_behind(const CellIterator &cell, const unsigned int face_no);

    unsigned int                                  n_owned            = 0;
    dealii::types::global_cell_index              first_global_index = 0;
    bool                                          axis_parallel      = true;
    double                                        shortest_edge      = 0;
    std::vector<Cell>                             cells;
    std::vector<CellIterator>                     iterators;
    std::vector<unsigned int>                     index_of_active_cell;
    std::vector<std::array<int, n_face_children>> children;
    std::vector<dealii::Tensor<1, dim>>           offsets;
  };
} // namespace Thalweg

#endif
