// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_linear_algebra_amg_h
#define thalweg_linear_algebra_amg_h

#include <deal.II/lac/la_parallel_vector.h>

#include <memory>
#include <vector>

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
  /// What the inverse of a matrix enlarges most, as it is far from boundaries.
  struct NearNullSpace
  {
    /// Owned values; none: a constant
    std::vector<std::vector<double>> modes;
    unsigned int                     n_components = 1; ///< a node
  };

  /**
   * @brief An algebraic multigrid preconditioner (Trilinos ML) for a
   * symmetric and positive definite matrix.
   *
   * A hierarchy is built from the present matrix only: where the density
   * jumps by a factor of 1000, each node that the interface has passed since
   * would cost an iteration, more than a new hierarchy does. Besides, a
   * resumed run has the same hierarchies as a straight one.
   */
  class AmgPreconditioner
  {
  public:
    /// What smooths on each level.
    enum class Smoother
    {
      /// An incomplete Cholesky factorization: the fewest iterations, but it
      /// may break down for matrices with large positive entries beside the
      /// diagonal.
      incomplete_cholesky,
      /// Chebyshev's polynomial: works for every such matrix.
      chebyshev
    };

    AmgPreconditioner();
    ~AmgPreconditioner();

    /**
     * @brief Builds the hierarchy for @p matrix. Collective.
     * @param matrix must neither change nor go as long as vmult() is called
     * @param smoother for all levels but the coarsest
     */
    void
    build(const dealii::TrilinosWrappers::SparseMatrix &matrix,
          const Smoother       smoother        = Smoother::incomplete_cholesky,
          const NearNullSpace &near_null_space = {});

    /**
     * @brief Builds the hierarchy unless @p matrix has the same entries as
     * at the last update, as it has for one fluid. Collective.
     * @param matrix as for build()
     */
    void
    update(const dealii::TrilinosWrappers::SparseMatrix &matrix);

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
    std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> amg;
    std::vector<double> updated_values; ///< of this rank
    unsigned int        builds = 0;
  };
} // namespace Thalweg

#endif
