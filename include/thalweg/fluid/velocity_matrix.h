// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_velocity_matrix_h
#define thalweg_fluid_velocity_matrix_h

#include <thalweg/fluid/viscous_operator.h>
#include <thalweg/linear_algebra/cell_matrices.h>

#include <deal.II/lac/affine_constraints.h>

#include <memory>
#include <unordered_map>

namespace Thalweg
{
  /**
   * @brief A ViscousOperator as a sparse matrix, for preconditioners that need
   * one. Fixed directions of a node, whatever they are, have a diagonal entry
   * only.
   */
  template <int dim>
  class VelocityMatrix
  {
  public:
    /// All must outlive the object.
    VelocityMatrix(const NodeSpace<dim>       &space,
                   const BoundaryNodes<dim>   &boundary,
                   const ViscousOperator<dim> &viscous);

    ~VelocityMatrix();

    /// Reads what the operator is after its update(). Collective.
    void
    assemble();

    const dealii::TrilinosWrappers::SparseMatrix &
    matrix() const
    {
      return *sparse;
    }

  private:
    static constexpr unsigned int n_cell_values = dim * (1 << dim);

    void
    find_constraints();

    /// Removes the fixed directions of a cell's nodes from its matrix.
    void
    remove_fixed(const unsigned int                         cell,
                 typename ViscousOperator<dim>::CellMatrix &matrix) const;

    const NodeSpace<dim>                                   &space;
    const BoundaryNodes<dim>                               &boundary;
    const ViscousOperator<dim>                             &viscous;
    dealii::AffineConstraints<double>                       constraints;
    std::unique_ptr<dealii::TrilinosWrappers::SparseMatrix> sparse;
    CellMatrices<n_cell_values>                             cell_matrices;
    /// Of each local node that has one: what projects fixed directions out.
    std::unordered_map<unsigned int, dealii::Tensor<2, dim>> projectors;
  };
} // namespace Thalweg

#endif
