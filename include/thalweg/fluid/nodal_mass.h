// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_nodal_mass_h
#define thalweg_fluid_nodal_mass_h

#include <thalweg/fields/boundary_nodes.h>
#include <thalweg/fields/q1_integrals.h>
#include <thalweg/interface/phase_field.h>

namespace Thalweg
{
  /**
   * @brief The masses of the nodes and the accelerations that nodal forces
   * give them, with the densities integrated exactly in cut cells.
   *
   * A lumped mass M_L puts the mean acceleration of the fluid around a node
   * to the node itself. Beside a surface or a wall that fluid stands to one
   * side, and the mean is off by its distance times the gradient. So the first
   * two terms of the series for the inverse of the consistent mass matrix M
   * are taken,
   *
   *   M^{-1} = M_L^{-1} + M_L^{-1} (M_L - M) M_L^{-1} + ...
   *
   * (J.-L. Guermond, R. Pasquetti, Comput. Methods Appl. Mech. Engrg. 253,
   * 2013). It is symmetric and positive, at most twice M_L^{-1} however small
   * a cut is, and exact for uniform accelerations.
   */
  template <int dim>
  class NodalMass
  {
  public:
    /// All must outlive the object.
    NodalMass(const NodeSpace<dim>     &space,
              const BoundaryNodes<dim> &boundary,
              const PhaseField<dim>    &phase);

    /// Reads the present phases. Collective.
    void
    update();

    /// M_L, kg; owned entries, zero at dependent nodes.
    const Vector &
    lumped() const
    {
      return mass;
    }

    /// 1/M_L, 1/kg; owned entries, zero at dependent nodes.
    const Vector &
    inverse_lumped() const
    {
      return inverse;
    }

    /// The mean density around an owned node that depends on no others,
    /// kg/m^dim.
    double
    density(const unsigned int node) const
    {
      return mass.local_element(node) / measure.local_element(node);
    }

    /**
     * @brief From nodal forces to accelerations. Collective.
     * @param vector in: int N_i f, N, folded; out: m/s^2, ghosted and
     *   consistent, without the normal components at slip walls (where fluid
     *   sticks, the acceleration is that of the fluid beside the wall)
     * @param uniform an acceleration of the same size everywhere that is
     *   added before, m/s^2
     * @param field another one at the nodes, or nullptr
     */
    void
    accelerate(Vector                       &vector,
               const dealii::Tensor<1, dim> &uniform,
               const Vector                 *field) const;

    /**
     * @brief The same without anything that is added, for what may not change
     * given velocities. Collective.
     * @param vector in: forces, N, folded; out: m/s^2, ghosted and consistent,
     *   without components that boundary conditions fix
     */
    void
    invert(Vector &vector) const;

  private:
    using Fixing = void (BoundaryNodes<dim>::*)(Vector &) const;

    static constexpr unsigned int n_vertices = 1 << dim;
    using CellMatrix = std::array<std::array<double, n_vertices>, n_vertices>;

    /// vector += M_L^{-1} (M_L - M) vector, without what @p project takes
    /// away.
    void
    add_second_term(Vector &vector, const Fixing project) const;

    /// vector_i := vector_i / M_L
    void
    divide(Vector &vector) const;

    /// result += (M_L - M) acceleration, of this rank's cells; not folded.
    void
    add_difference(const Vector &acceleration, Vector &result) const;

    const NodeSpace<dim>     &space;
    const BoundaryNodes<dim> &boundary;
    const PhaseField<dim>    &phase;
    Q1Integrals<dim>          integrals;
    CellMatrix                table;   ///< int N_i N_j over the reference cell
    Vector                    measure; ///< int N_i
    Vector                    mass;
    Vector                    inverse;
    mutable Vector            difference;
  };
} // namespace Thalweg

#endif
