#ifndef thalweg_linear_algebra_amg_h
#define thalweg_linear_algebra_amg_h

#include <deal.II/lac/la_parallel_vector.h>

#include <memory>

namespace dealii
{
  namespace TrilinosWrappers
  {
    class SparseMatrix;
    class PreconditionAMG;
  } // namespace TrilinosWrappers
} // namespace dealii

namespace Thalweg
{
  /**
   * @brief An algebraic multigrid preconditioner (Trilinos ML) for a scalar,
   * symmetric and positive definite matrix that changes a little from step
   * to step: the hierarchy is kept as long as it serves.
   */
  class AmgPreconditioner
  {
  public:
    AmgPreconditioner();
    ~AmgPreconditioner();

    /// Makes sure of a hierarchy for @p matrix, which it copies if it must
    /// build one.
    void
    update(const dealii::TrilinosWrappers::SparseMatrix &matrix);

    /// Tells how many iterations a solve took; when they grow to more than
    /// half again what the fresh hierarchy needed, the next update() builds
    /// anew.
    void
    report(const unsigned int n_iterations);

    /// Whether no solve has been reported since the hierarchy was built.
    bool
    is_fresh() const
    {
      return fresh_iterations == 0;
    }

    /// After how many iterations it pays to build anew instead of going on.
    unsigned int
    patience() const
    {
      return 4 * fresh_iterations + 20;
    }

    /// Builds anew at the next update().
    void
    invalidate();

    /// One multigrid cycle.
    void
    vmult(
      dealii::LinearAlgebra::distributed::Vector<double>       &destination,
      const dealii::LinearAlgebra::distributed::Vector<double> &source) const;

    /// How many hierarchies have been built so far.
    unsigned int
    n_builds() const
    {
      return builds;
    }

  private:
    std::unique_ptr<dealii::TrilinosWrappers::SparseMatrix>    copy;
    std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> amg;
    unsigned int                                               builds = 0;
    unsigned int fresh_iterations                                     = 0;
    bool         stale                                                = true;
  };
} // namespace Thalweg

#endif
