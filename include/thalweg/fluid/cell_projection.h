// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_cell_projection_h
#define thalweg_fluid_cell_projection_h

#include <thalweg/fluid/nodal_mass.h>
#include <thalweg/linear_algebra/krylov.h>

#include <vector>

namespace Thalweg
{
  template <int dim>
  class PressureSystem;

  /**
   * @brief Finds the velocity that is nearest to a given one, in kinetic
   * energy, and lets as much fluid into each cell as out of it.
   *
   * With the masses M of the nodes and D V = int_K div V, one row a cell, this
   * is V - M^{-1} D^T x where D M^{-1} D^T x = D V: bilinear velocities and
   * multipliers that are constant in each cell. The multipliers may have
   * a part that alternates from cell to cell and moves nothing; the velocity
   * is unique. As a projection that is orthogonal in the kinetic energy it
   * never adds to it.
   *
   * The pressure of equal order cannot do this: what its gradient does to the
   * nodes has another divergence than its own equation says, and what is left
   * stays on the particles from step to step.
   */
  template <int dim>
  class CellProjection
  {
  public:
    /// All must outlive the object.
    CellProjection(const NodeSpace<dim>      &space,
                   const BoundaryNodes<dim>  &boundary,
                   const NodalMass<dim>      &mass,
                   const PressureSystem<dim> &pressure);

    /**
     * @brief Projects. Collective.
     * @param velocity ghosted and consistent, with its boundary values, m/s
     * @param tolerance the iterations end when one changes the velocity by
     *   less than this part of the whole change, in the norm of the kinetic
     *   energy. (The norm of the outflows would mostly see multipliers that
     *   alternate from cell to cell, which take six times as many iterations
     *   and move hardly anything.) What is left, the next step finds.
     * @param maximum of iterations
     * @return iterations, and as residual the root mean square of the
     *   divergence that is left, 1/s
     * @throws StepFailure
     */
    SolveReport
    project(Vector            &velocity,
            const double       tolerance,
            const unsigned int maximum);

    /// y = D M^{-1} D^T x, m^{2 dim}/kg x; for the solver.
    void
    vmult(Vector &y, const Vector &x) const;

  private:
    static constexpr unsigned int n_vertices = 1 << dim;

    /// The diagonal, and a cycle of the pressure's multigrid for what is
    /// smooth.
    class Preconditioner;

    /// y = D V
    void
    find_outflow(const Vector &velocity, Vector &y) const;

    /// change = M^{-1} D^T x, without fixed components
    void
    find_change(const Vector &x) const;

    /// The inverse of the operator's diagonal where that is not zero.
    void
    find_diagonal();

    /// Finds the cells at whose nodes the velocity is given as a whole.
    void
    find_rigid_cells();

    /// Takes away what no change of velocity can do: the net outflow of a
    /// domain without open boundaries, and those of rigid cells.
    void
    balance(Vector &y) const;

    /// How iterations went.
    struct Iterations
    {
      SolveReport  report;
      unsigned int best          = 0; ///< after which the residual was least
      bool         has_converged = false;
    };

    /// When the residual is so many times as large as it was at first, the
    /// outflows have a part that no velocity can take away: velocities that
    /// are given all around cells whose multipliers alternate and move nothing
    /// may ask for one.
    static constexpr double incompatible = 100.;

    /// Conjugate gradients for the multipliers of @ref outflow, which
    /// becomes the residual; until it has converged, after @p maximum
    /// iterations, or when it cannot converge.
    Iterations
    iterate(const double       tolerance,
            const double       smallest_residual,
            const unsigned int maximum);

    /// Finds the multipliers that take away what velocities can of the outflow
    /// of @p velocity; @ref outflow becomes the residual. @throws StepFailure
    SolveReport
    solve(const Vector      &velocity,
          const double       tolerance,
          const unsigned int maximum);

    /// The norm of the outflows that are round-off of a velocity and of the
    /// cells' corners. In regular meshes these let multipliers that alternate
    /// from cell to cell, and move nothing, ask for velocities of any size.
    double
    round_off(const Vector &velocity) const;

    const NodeSpace<dim>      &space;
    const BoundaryNodes<dim>  &boundary;
    const NodalMass<dim>      &mass;
    const PressureSystem<dim> &pressure;
    /// int grad N_i, cell by cell
    std::vector<std::array<dealii::Tensor<1, dim>, n_vertices>> gradients;
    std::vector<unsigned int>                                   rigid_cells;
    Vector inverse_diagonal;
    Vector outflow;
    Vector multiplier, preconditioned, direction, image;
    double domain_measure = 0;
    /// Of an edge, the part that is round-off of its ends.
    double         edge_round_off = 0;
    mutable Vector change;
  };
} // namespace Thalweg

#endif
