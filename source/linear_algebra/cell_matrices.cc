// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/linear_algebra/cell_matrices.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Epetra_CrsMatrix.h>
#include <algorithm>
#include <limits>

namespace Thalweg
{
  template <unsigned int n>
  void
  CellMatrices<n>::initialize(
    dealii::TrilinosWrappers::SparseMatrix  &matrix_,
    const dealii::AffineConstraints<double> &constraints_,
    const std::vector<Indices>              &cells_)
  {
    matrix      = &matrix_;
    constraints = &constraints_;
    cells       = cells_;
    rows.clear();
    columns.clear();
    place_of_cell.assign(cells.size(), general);
    for (unsigned int c = 0; c < cells.size(); ++c)
      if (find_places(cells[c]))
        place_of_cell[c] = rows.size() - 1;
  }



  template <unsigned int n>
  bool
  CellMatrices<n>::find_places(const Indices &indices)
  {
    for (const auto index : indices)
      if (constraints->is_constrained(index) || !matrix->in_local_range(index))
        return false;

    const Epetra_CrsMatrix          &epetra = matrix->trilinos_matrix();
    std::array<double *, n>          values;
    std::array<std::uint16_t, n * n> places;
    for (unsigned int i = 0; i < n; ++i)
      {
        const auto row     = static_cast<int>(indices[i]);
        int        length  = 0;
        int       *entries = nullptr;
        if (epetra.ExtractMyRowView(
              epetra.LRID(row), length, values[i], entries) != 0 ||
            length > std::numeric_limits<std::uint16_t>::max())
          return false;
        for (unsigned int j = 0; j < n; ++j)
          {
            const int  column = epetra.LCID(static_cast<int>(indices[j]));
            const int *entry  = std::find(entries, entries + length, column);
            if (entry == entries + length)
              return false;
            places[i * n + j] = entry - entries;
          }
      }
    rows.push_back(values);
    columns.push_back(places);
    return true;
  }



  template <unsigned int n>
  void
  CellMatrices<n>::add(const unsigned int cell, const Local &local)
  {
    const unsigned int place = place_of_cell[cell];
    if (place != general)
      {
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            rows[place][i][columns[place][i * n + j]] += local[i][j];
        return;
      }
    dealii::FullMatrix<double> full(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        full(i, j) = local[i][j];
    const std::vector<dealii::types::global_dof_index> indices(
      cells[cell].begin(), cells[cell].end());
    constraints->distribute_local_to_global(full, indices, *matrix);
  }



  template class CellMatrices<4>;
  template class CellMatrices<8>;
  template class CellMatrices<24>;
} // namespace Thalweg
