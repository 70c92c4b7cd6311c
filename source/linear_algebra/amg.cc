#include <thalweg/linear_algebra/amg.h>

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace Thalweg
{
  AmgPreconditioner::AmgPreconditioner()  = default;
  AmgPreconditioner::~AmgPreconditioner() = default;



  void
  AmgPreconditioner::update(
    const dealii::TrilinosWrappers::SparseMatrix &matrix)
  {
    if (!stale)
      return;
    // ML refers to the matrix it was built from, which must not change under
    // a hierarchy that is kept.
    copy = std::make_unique<dealii::TrilinosWrappers::SparseMatrix>();
    copy->copy_from(matrix);
    amg = std::make_unique<dealii::TrilinosWrappers::PreconditionAMG>();
    dealii::TrilinosWrappers::PreconditionAMG::AdditionalData data;
    data.elliptic              = true;
    data.higher_order_elements = false;
    data.smoother_sweeps       = 2;
    data.aggregation_threshold = 1e-3;
    amg->initialize(*copy, data);
    stale            = false;
    fresh_iterations = 0;
    ++builds;
  }



  void
  AmgPreconditioner::report(const unsigned int n_iterations)
  {
    if (fresh_iterations == 0)
      fresh_iterations = std::max(n_iterations, 4u);
    else if (2 * n_iterations > 3 * fresh_iterations)
      stale = true;
  }



  void
  AmgPreconditioner::invalidate()
  {
    stale = true;
  }



  void
  AmgPreconditioner::vmult(
    dealii::LinearAlgebra::distributed::Vector<double>       &destination,
    const dealii::LinearAlgebra::distributed::Vector<double> &source) const
  {
    amg->vmult(destination, source);
  }
} // namespace Thalweg
