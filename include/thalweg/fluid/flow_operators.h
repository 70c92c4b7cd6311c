// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_flow_operators_h
#define thalweg_fluid_flow_operators_h

#include <thalweg/fields/cell_operator.h>
#include <thalweg/fields/flow_boundary.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief The integrals of a flow with constant properties in a pair of
   * spaces (Eq. 73), made once for a mesh.
   *
   * With N of the velocity's space and q of the pressure's:
   * M = int N_i N_j, K = int grad N_i . grad N_j, L = int grad q_i . grad q_j,
   * G = int N_i grad q_j, D = -int q_i div N_j.
   */
  template <int dim>
  class FlowOperators
  {
  public:
    /**
     * @param velocity_space and @p pressure_space on the same mapping
     * @param boundary tells where velocities are fixed
     * @param lumped_mass M by the quadrature at the nodes: a diagonal
     */
    FlowOperators(const LagrangeSpace<dim> &velocity_space,
                  const LagrangeSpace<dim> &pressure_space,
                  const FlowBoundary<dim>  &boundary,
                  const bool                lumped_mass);

    CellOperator<dim> mass;
    CellOperator<dim> stiffness;
    CellOperator<dim> pressure_stiffness;
    CellOperator<dim> pressure_mass; ///< int q_i q_j

    /// force += factor G p; not folded. @param pressure ghosted
    void
    add_gradient(const Vector &pressure,
                 Vector       &force,
                 const double  factor) const;

    /// result += factor G^T V; not folded. @param velocity ghosted
    void
    add_weak_gradient(const Vector       &velocity,
                      Vector             &result,
                      const double        factor,
                      const double *const cell_factors = nullptr) const;

    /// result += factor D V; not folded. @param velocity ghosted
    void
    add_divergence(const Vector &velocity,
                   Vector       &result,
                   const double  factor) const;

    /// force += factor D^T p; not folded. @param pressure ghosted
    void
    add_pressure_force(const Vector &pressure,
                       Vector       &force,
                       const double  factor) const;

    /// force += factor int N dV/dn over the boundaries where the velocity is
    /// given or zero; not folded. @param velocity ghosted
    void
    add_boundary_gradient(const Vector &velocity,
                          Vector       &force,
                          const double  factor) const;

    /// The shortest edge of each owned cell, m.
    const std::vector<double> &
    cell_lengths() const
    {
      return lengths;
    }

    const LagrangeSpace<dim> &velocity_space;
    const LagrangeSpace<dim> &pressure_space;

  private:
    /// The integrals of one cell.
    void
    integrate_cell(const unsigned int cell,
                   const unsigned int shape,
                   const bool         lumped_mass);

    void
    integrate_boundary(const FlowBoundary<dim> &boundary);

    /// Numbers the shapes of the cells. @return a cell of each shape
    std::vector<unsigned int>
    find_shapes();

    /// [shape][node of velocity][node of pressure][d]: int N d_d q
    std::vector<double> gradient;
    /// likewise: int d_d N q
    std::vector<double> divergence;
    std::vector<double> lengths;

    /// A boundary face's int N_i dN_j/dn.
    struct BoundaryFace
    {
      unsigned int        cell;
      std::vector<double> matrix;
    };
    std::vector<BoundaryFace> faces;
  };
} // namespace Thalweg

#endif
