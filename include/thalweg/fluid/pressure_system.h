// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_pressure_system_h
#define thalweg_fluid_pressure_system_h

#include <thalweg/fields/boundary_nodes.h>
#include <thalweg/fields/q1_integrals.h>
#include <thalweg/fluid/body_forces.h>
#include <thalweg/fluid/enriched_matrix.h>
#include <thalweg/interface/interface_force.h>
#include <thalweg/linear_algebra/cell_matrices.h>
#include <thalweg/linear_algebra/krylov.h>

#include <array>
#include <memory>
#include <vector>

namespace dealii
{
  namespace TrilinosWrappers
  {
    class SparseMatrix;
  }
} // namespace dealii

namespace Thalweg
{
  template <int dim>
  class NodalMass;

  /**
   * @brief The pressure equation of a fractional step with the enrichment (Eq. 82
   * to 85, with a factor at each node of cut cells instead of one a cell).
   *
   * For a velocity that changes at the rate r and that forces g (and f/rho)
   * act on, with g the uniform acceleration and the nodal field of the others,
   *
   *   (grad q, grad p / rho) = (grad q, r + g + f/rho) - <q, r . n>_D
   *
   * for all functions q of the enriched space, with D the boundaries where
   * velocities are given. For those with a kink the first term is -(q, div r):
   * there are no other terms at boundaries.
   *
   * The rate is what changes, not a velocity over the step: the velocities of
   * the nodes hardly answer to the enrichment, and the divergence that its
   * equation leaves would be asked for again in each step and worked on. Waves
   * gained a third of their energy in ten periods.
   */
  template <int dim>
  class PressureSystem
  {
  public:
    /// @param tension acts besides the body forces; nullptr: none
    PressureSystem(const NodeSpace<dim>      &space,
                   const BoundaryNodes<dim>  &boundary,
                   const PhaseField<dim>     &phase,
                   const BodyForces<dim>     &forces,
                   const InterfaceForce<dim> *tension = nullptr);
    ~PressureSystem();

    /// Assembles the matrix for the present phases, and finds the
    /// accelerations at the time of the forces.
    void
    assemble();

    /// What BodyForces::field() says at the nodes, and what was added since
    /// assemble(), m/s^2, ghosted; zero if there is none.
    const Vector &
    acceleration() const
    {
      return field;
    }

    /// Adds @p factor times a nodal acceleration to what solves with forces
    /// balance, until assemble(). @param other m/s^2
    void
    add_acceleration(const double factor, const Vector &other)
    {
      has_field = true;
      field.zero_out_ghost_values();
      field.add(factor, other);
      space.interpolate(field, dim);
    }

    /**
     * @brief Solves for the increment that @p pressure lacks and adds it.
     * @param rate ghosted, m/s^2
     * @param with_forces whether body forces act (first solve of a step), or
     *   have been balanced already
     * @param pressure its residual is the right hand side
     * @param tolerance relative to the norm of the first right hand side of
     *   the step, with all forces and no pressure
     * @return cost of the solve
     * @throws StepFailure
     */
    SolveReport
    correct(const Vector      &rate,
            const bool         with_forces,
            EnrichedPressure  &pressure,
            const double       tolerance,
            const unsigned int maximal_iterations);

    /**
     * @brief Adds what the equation lacks, of this rank's cells; not folded.
     * @param rate ghosted, m/s^2; the terms at boundaries with a given
     *   velocity are left out
     * @param with_forces whether body forces act
     * @param pressure is subtracted; nullptr: none
     * @param cell_factors what each owned cell's part is multiplied by: then
     *   functions with jumps have (grad q, r) on both sides; nullptr: 1, and
     *   they have -(q, div r)
     */
    void
    add_residual(const Vector              &rate,
                 const bool                 with_forces,
                 const EnrichedPressure    *pressure,
                 const std::vector<double> *cell_factors,
                 EnrichedPressure          &load) const;

    /**
     * @brief Subtracts (q, s div r) of this rank's cells, for all q of the
     * enriched space; not folded.
     * @param cell_factors s, of each owned cell
     */
    void
    subtract_outflow(const Vector              &field,
                     const std::vector<double> &cell_factors,
                     EnrichedPressure          &load) const;

    /// Multiplies by an approximate inverse of the present matrix. Collective.
    /// @param load folded @param result owned values only
    void
    precondition(EnrichedPressure &result, const EnrichedPressure &load) const
    {
      enriched->precondition(result, load, amg);
    }

    /// Lets the owned nodes where the pressure is given be zero.
    void
    remove_given(Vector &load) const
    {
      enriched->remove_given(load);
    }

    /// One multigrid cycle for the present matrix. @param load nodal, folded
    /// @param result ghosted and consistent
    void
    precondition(Vector &result, Vector &load) const;

    /// Subtracts int N_i grad p in N, on both sides where the pressure jumps,
    /// of this rank's cells; not folded.
    void
    subtract_gradient(const EnrichedPressure &pressure, Vector &force) const;

    /// Subtracts int N_i p n over the interface, of jumps; likewise.
    void
    subtract_jump_forces(const EnrichedPressure &pressure, Vector &force) const;

    /**
     * @brief The acceleration of the nodes by a pressure, without jumps, and
     * by body forces. Collective.
     * @param pressure ghosted, Pa
     * @param mass of the nodes, see NodalMass::accelerate()
     * @param result ghosted, m/s^2
     */
    void
    accelerate(const EnrichedPressure &pressure,
               const bool              with_forces,
               const NodalMass<dim>   &mass,
               Vector                 &result) const;

    /// Sets the nodes at open boundaries to their value.
    void
    apply_open_boundary(Vector &pressure) const;

  private:
    /// After how many iterations the usual smoother is held to have failed;
    /// it needs about ten.
    static constexpr unsigned int patience = 150;

    /// Adds int N_i f of the force density, of this rank's cells; not folded.
    void
    add_force_density(Vector &force) const;

    /// The same of surface tension.
    void
    add_tension(Vector &force) const;

    /// The right hand side of a cell: for N_i, and for N_i psi.
    struct Load
    {
      std::array<double, (1 << dim)> nodal{};
      std::array<double, (1 << dim)> star{};
    };

    /// all += factor load
    void
    add(const unsigned int cell,
        const Load        &load,
        const double       factor,
        EnrichedPressure  &all) const;

    using CellMatrix = typename CellMatrices<(1 << dim)>::Local;

    struct Preconditioner
    {
      const EnrichedMatrix<dim> &matrix;
      const AmgPreconditioner   &amg;

      void
      vmult(EnrichedPressure &result, const EnrichedPressure &load) const
      {
        matrix.precondition(result, load, amg);
      }
    };

    void
    initialize_matrix();

    /// Evaluates the field of accelerations at the nodes.
    void
    find_acceleration();

    /// int grad N_i . grad N_j / rho
    CellMatrix
    cell_matrix(const unsigned int cell) const;

    /// The integrals of a cell that the interface cuts, or nullptr.
    const CutCell<dim> *
    cut_cell(const unsigned int cell) const
    {
      const int index = phase.cut_index(cell);
      return index < 0 ? nullptr : &phase.cut_cells()[index];
    }

    /// The same for an enriched cell only.
    const CutCell<dim> *
    enriched_cell(const unsigned int cell) const
    {
      const CutCell<dim> *cut = cut_cell(cell);
      return cut && cut->enriched ? cut : nullptr;
    }

    /// (grad q, r) and -(q psi, div r); the first terms of a load.
    void
    add_divergence(const unsigned int cell,
                   const Vector      &rate,
                   Load              &load) const;

    /// -(q psi, div r) of a field at the cell's nodes
    void
    subtract_star_outflow(const unsigned int                         cell,
                          const std::array<double, dim *(1 << dim)> &field,
                          Load &load) const;

    /// Subtracts int q r . n over the interface, of the jumps of q: from -(q,
    /// div r) to (grad q, r) on both sides.
    void
    subtract_jumps(const CutCell<dim>                        &cut,
                   const std::array<double, dim *(1 << dim)> &field,
                   Load                                      &load) const;

    /**
     * (grad q, g + f/rho). The mean of the field at
     * the cell's nodes acts as gravity does, so that a field that is the same
     * everywhere is balanced as exactly; what differs is a bilinear field.
     */
    void
    add_forces(const unsigned int cell, Load &load) const;

    /// (grad q, f / rho) of surface tension
    void
    add_tension(const unsigned int                             cell,
                const typename InterfaceForce<dim>::CellForce &force,
                Load                                          &load) const;

    /// (grad q, grad p / rho)
    void
    subtract_pressure(const unsigned int      cell,
                      const EnrichedPressure &pressure,
                      Load                   &load) const;

    /// The same of what is no kink or jump; added with @p factor.
    void
    add_nodal_pressure(const unsigned int                    cell,
                       const std::array<double, (1 << dim)> &pressure,
                       const double                          factor,
                       Load                                 &load) const;

    /// The residual of all cells, folded.
    /// @param pressure is subtracted; nullptr: none
    void
    assemble_residual(const Vector           &rate,
                      const bool              with_forces,
                      const EnrichedPressure *pressure);

    /// increment = matrix^{-1} residual, with another smoother in the
    /// multigrid hierarchy if the usual one does not serve.
    SolveReport
    solve(const double tolerance, const unsigned int maximal_iterations);

    const NodeSpace<dim>      &space;
    const BoundaryNodes<dim>  &boundary;
    const PhaseField<dim>     &phase;
    const BodyForces<dim>     &forces;
    const InterfaceForce<dim> *tension;
    Q1Integrals<dim>           integrals;

    dealii::AffineConstraints<double>                       constraints;
    std::unique_ptr<dealii::TrilinosWrappers::SparseMatrix> matrix;
    CellMatrices<(1 << dim)>                                cell_matrices;
    AmgPreconditioner                                       amg;
    /// Whether there is an acceleration besides the uniform one.
    bool                                 has_field = false;
    bool                                 singular;
    std::unique_ptr<EnrichedMatrix<dim>> enriched;
    double                               reference_norm = 0;
    EnrichedPressure                     residual;
    EnrichedPressure                     increment;
    Vector                               field;
  };
} // namespace Thalweg

#endif
