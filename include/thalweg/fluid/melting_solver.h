// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_melting_solver_h
#define thalweg_fluid_melting_solver_h

#include <thalweg/fluid/nodal_melting.h>
#include <thalweg/fluid/scalar_operator.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief Finds the heat h with C/tau h + (K + H) s(h) = b, where the scalar s
   * changes less with the heat where something melts, or not at all.
   *
   * Its solution minimizes a convex function of s with a kink at the melting
   * point. Two steps take turns (C. Graeser and R. Kornhuber, J. Comput. Math.
   * 27, 2009, p. 1): one in which each node minimizes a bound of it by itself,
   * which always goes down; and one of Newton's with those nodes kept that melt
   * at one temperature, as far as that goes down. The latter ends it if then
   * no node begins or ceases to melt.
   */
  template <int dim>
  class MeltingSolver
  {
  public:
    /// A linear implicit step, see ScalarOperator::set_step().
    struct Step
    {
      double                   tau; ///< s
      const Vector            &exchange;
      const std::vector<bool> &is_given;
    };

    /// @param space, matrix, melting must outlive the object
    MeltingSolver(const NodeSpace<dim>    &space,
                  ScalarOperator<dim>     &matrix,
                  const NodalMelting<dim> &melting);

    /// Behind each change of the matrix, whose conductivities it has to know.
    /// Collective.
    void
    update()
    {
      matrix.find_majorant(majorant);
    }

    /**
     * @brief Solves. Collective.
     * @param heat in: a guess, with given nodes as they are to be; out: the
     *   solution; ghosted and consistent
     * @param right_side b, owned values
     * @param tolerance a part of the first residual
     * @return iterations of the linear solver. @throws StepFailure
     */
    unsigned int
    solve(Vector       &heat,
          const Vector &right_side,
          const Step   &step,
          const double  tolerance);

  private:
    bool
    is_free(const unsigned int node, const Step &step) const
    {
      return !step.is_given[node] && !space.is_dependent(node);
    }

    /// b - (K + H) s of owned nodes into `gain`, @p value ghosted.
    void
    find_gain(const Vector &value, const Vector &right_side, const Step &step);

    /// What is missing, into `residual`.
    void
    find_residual(const Vector &heat,
                  const Vector &right_side,
                  const Step   &step);

    /// Each node by itself goes to where it would rest if all others went with
    /// it; from `value`, which it updates.
    void
    relax(Vector &heat, const Vector &right_side, const Step &step);

    /// Finds the `increment` of the value by Newton's method.
    unsigned int
    linearize(const Step &step, const double tolerance, const double round_off);

    /// The states of nodes with a heat. @return whether any has changed on any
    /// rank
    bool
    find_states(const Vector &heat);

    /// How far along `increment` it goes down, up to 1.
    double
    length_of_step(const Step &step) const;

    const NodeSpace<dim>    &space;
    ScalarOperator<dim>     &matrix;
    const NodalMelting<dim> &melting;
    Vector                   majorant, value, gain, residual, increment, change;
    std::vector<Melting::State> states;
    std::vector<double>         slopes;
  };
} // namespace Thalweg

#endif
