// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_boundary_faces_h
#define thalweg_fields_boundary_faces_h

#include <thalweg/mesh/cell_graph.h>

#include <functional>
#include <vector>

namespace Thalweg
{
  /// A face of an owned cell at the boundary, with two to eight points for
  /// integrals.
  template <int dim>
  struct BoundaryFace
  {
    unsigned int                        cell;
    unsigned int                        face_no;
    dealii::types::boundary_id          id;
    std::vector<dealii::Point<dim>>     reference_points;
    std::vector<dealii::Tensor<1, dim>> normals_times_weight; ///< outward

    /// The outward normal times the face's measure, m^(dim-1).
    dealii::Tensor<1, dim>
    area() const;
  };

  /// The outward normal of a face at the reference coordinates @p xi times the
  /// density of its measure.
  template <int dim>
  dealii::Tensor<1, dim>
  weighted_normal(const typename CellGraph<dim>::Cell &cell,
                  const unsigned int                   face_no,
                  const dealii::Point<dim>            &xi);

  /// Those of this rank at boundaries that are @p wanted, never periodic ones;
  /// cell by cell.
  template <int dim>
  std::vector<BoundaryFace<dim>>
  boundary_faces(
    const CellGraph<dim>                                        &graph,
    const std::function<bool(const dealii::types::boundary_id)> &wanted);
} // namespace Thalweg

#endif
