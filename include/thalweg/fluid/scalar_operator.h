// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_scalar_operator_h
#define thalweg_fluid_scalar_operator_h

#include <thalweg/fields/q1_integrals.h>
#include <thalweg/interface/phase_field.h>
#include <thalweg/linear_algebra/jacobi.h>

#include <array>
#include <vector>

namespace Thalweg
{
  /**
   * @brief C/tau + K + H, by which a scalar diffuses, without a matrix.
   *
   * C is the lumped capacity, K the stiffness with the conductivity, H what
   * boundaries exchange with what is outside. In cut cells the fluids form a
   * laminate: a flux across the interface sees the harmonic mean of the
   * conductivities, one along it the arithmetic one.
   *
   * K is kept as the couplings between the vertices of each cell, so that what
   * one loses another one gets, and a uniform scalar stays as it is, to the
   * last bit.
   */
  template <int dim>
  class ScalarOperator
  {
  public:
    static constexpr unsigned int n_vertices = 1 << dim;
    static constexpr unsigned int n_pairs = n_vertices * (n_vertices - 1) / 2;

    /// Of both fluids.
    using Material = std::array<double, 2>;

    /// @param space must outlive the object
    explicit ScalarOperator(const NodeSpace<dim> &space);

    /**
     * @brief Sets up for the fluids where they are now. Collective.
     * @param capacity amount a volume and unit of the scalar
     * @param conductivity capacity times diffusivity, m^2/s
     */
    void
    update(const PhaseField<dim> &phase,
           const Material        &capacity,
           const Material        &conductivity);

    /// What there is of a material around each node, owned values; 0 at
    /// dependent nodes. Collective.
    /// @param material amount a volume
    void
    lump(const PhaseField<dim> &phase,
         const Material        &material,
         Vector                &amount) const;

    /**
     * @brief For time steps of @p tau, s, from now on.
     * @param exchange H, an owned value a node
     * @param is_given nodes whose value does not change
     * @param slopes by how much the value of a node changes with what it holds
     *   over its capacity, where that is not 1; without those that melt empty
     */
    void
    set_step(const double               tau,
             const Vector              &exchange,
             const std::vector<bool>   &is_given,
             const std::vector<double> &slopes);

    /// Lumped capacities, owned values; 0 at dependent nodes.
    const Vector &
    capacity() const
    {
      return mass;
    }

    /// Lumped volumes, m^dim, likewise.
    const Vector &
    measure() const
    {
      return volume;
    }

    /// What diffuses to each node in a second, -K s; owned values.
    /// @param scalar ghosted and consistent
    void
    diffuse(Vector &result, const Vector &scalar) const;

    /// result = (C/tau + K + H) increment, where the increment vanishes at
    /// given nodes.
    void
    vmult(Vector &result, const Vector &increment) const;

    /// Finds a diagonal that is no less than K in the sense of quadratic forms:
    /// the sums of the absolute values of its rows, owned values. Collective.
    void
    find_majorant(Vector &row_sums) const;

    const Jacobi<Vector> &
    jacobi() const
    {
      return preconditioner;
    }

  private:
    /// Sets the couplings of a cell, -int k grad N_i . grad N_j.
    void
    set_couplings(const unsigned int     cell,
                  const PhaseField<dim> &phase,
                  const Material        &conductivity);

    /// Adds -K s of this rank's cells; not folded.
    void
    add_diffusion(const Vector &scalar, Vector &result) const;

    const NodeSpace<dim>                    &space;
    Q1Integrals<dim>                         integrals;
    std::vector<std::array<double, n_pairs>> couplings;
    Vector                                   mass, volume;
    Vector                                   diagonal; ///< of K
    Vector                                   shift;    ///< C/tau + H
    std::vector<bool>                        is_fixed;
    Jacobi<Vector>                           preconditioner;
    mutable Vector                           work;
  };
} // namespace Thalweg

#endif
