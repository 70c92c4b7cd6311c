// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/linear_algebra/amg.h>

#include <deal.II/base/mpi.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_MultiVector.h>
#include <Teuchos_ParameterList.hpp>
#include <algorithm>

namespace Thalweg
{
  namespace
  {
    /// Unknowns that are coupled by less than this part of the mean of their
    /// diagonals do not aggregate. Where the density jumps by a factor of 1000
    /// light fluid and heavy do then not, which saves an eighth of the
    /// iterations.
    constexpr double strength = .02;



    /// All entries of this rank's rows.
    std::vector<double>
    values_of(const Epetra_CrsMatrix &matrix)
    {
      std::vector<double> values;
      values.reserve(matrix.NumMyNonzeros());
      for (int row = 0; row < matrix.NumMyRows(); ++row)
        {
          int     length  = 0;
          double *entries = nullptr;
          matrix.ExtractMyRowView(row, length, entries);
          values.insert(values.end(), entries, entries + length);
        }
      return values;
    }



    /// Hands modes to the multigrid's parameters.
    /// @param vectors keeps them until the hierarchy stands
    void
    set_near_null_space(const NearNullSpace                          &space,
                        const dealii::TrilinosWrappers::SparseMatrix &matrix,
                        Teuchos::ParameterList              &parameters,
                        std::unique_ptr<Epetra_MultiVector> &vectors)
    {
      if (space.modes.empty())
        return;
      vectors =
        std::make_unique<Epetra_MultiVector>(matrix.trilinos_matrix().RowMap(),
                                             space.modes.size());
      for (unsigned int m = 0; m < space.modes.size(); ++m)
        std::copy(space.modes[m].begin(), space.modes[m].end(), (*vectors)[m]);
      // With a threshold the aggregates of a system fall apart where its
      // coefficients jump by a factor of a million.
      parameters.set("aggregation: threshold", 0.);
      parameters.set("PDE equations", static_cast<int>(space.n_components));
      parameters.set("null space: type", "pre-computed");
      parameters.set("null space: dimension",
                     static_cast<int>(space.modes.size()));
      parameters.set("null space: vectors", vectors->Values());
    }
  } // namespace



  AmgPreconditioner::AmgPreconditioner()  = default;
  AmgPreconditioner::~AmgPreconditioner() = default;



  void
  AmgPreconditioner::build(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                           const Smoother       smoother,
                           const NearNullSpace &near_null_space)
  {
    dealii::TrilinosWrappers::PreconditionAMG::AdditionalData data;
    data.elliptic              = true;
    data.higher_order_elements = false;
    data.aggregation_threshold = strength;
    if (smoother == Smoother::incomplete_cholesky)
      {
        data.smoother_type   = "IC";
        data.smoother_sweeps = 1;
      }
    else
      {
        data.smoother_type   = "Chebyshev";
        data.smoother_sweeps = 2;
      }
    Teuchos::ParameterList              parameters;
    std::unique_ptr<Epetra_MultiVector> modes;
    data.set_parameters(parameters, modes, matrix);
    set_near_null_space(near_null_space, matrix, parameters, modes);
    // A tenth of the time for nothing: these parameters are known to be valid.
    parameters.set("ML validate parameter list", false);
    amg = std::make_unique<dealii::TrilinosWrappers::PreconditionAMG>();
    amg->initialize(matrix, parameters);
    ++builds;
  }



  void
  AmgPreconditioner::update(
    const dealii::TrilinosWrappers::SparseMatrix &matrix)
  {
    std::vector<double> values      = values_of(matrix.trilinos_matrix());
    const int           has_changed = !amg || values != updated_values;
    if (dealii::Utilities::MPI::max(has_changed,
                                    matrix.get_mpi_communicator()) == 0)
      return;
    updated_values = std::move(values);
    build(matrix);
  }



  void
  AmgPreconditioner::vmult(
    dealii::LinearAlgebra::distributed::Vector<double>       &destination,
    const dealii::LinearAlgebra::distributed::Vector<double> &source) const
  {
    amg->vmult(destination, source);
  }
} // namespace Thalweg
