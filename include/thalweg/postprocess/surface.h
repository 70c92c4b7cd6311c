// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_surface_h
#define thalweg_postprocess_surface_h

#include <thalweg/postprocess/flow_access.h>

#include <deal.II/base/types.h>

#include <functional>
#include <set>
#include <vector>

namespace Thalweg
{
  /// A point on a boundary and what the fluid does to it.
  template <int dim>
  struct SurfacePoint
  {
    dealii::Point<dim>     position;
    dealii::Tensor<1, dim> normal;   ///< out of the fluid
    double                 weight;   ///< for integrals, m^(dim-1)
    double                 pressure; ///< Pa
    /// The viscous force of the fluid per area, -mu (grad v + grad v^T) n,
    /// in Pa.
    dealii::Tensor<1, dim> viscous;
    /// The same by the residual of the momentum equation where the method
    /// has it and the boundary fixes the velocity, zero at other boundaries
    /// of such a method; else that of the gradient.
    dealii::Tensor<1, dim> traction;
  };

  /**
   * @brief Calls @p visit(face, id, points) for each face of a locally owned
   * cell at the boundaries @p ids, always in the same order.
   * @param n_points of Gauss in each direction of a face
   */
  template <int dim>
  void
  visit_surface(const FlowFields<dim>                      &flow,
                const std::set<dealii::types::boundary_id> &ids,
                const unsigned int                          n_points,
                const std::function<void(
                  const typename dealii::Triangulation<dim>::face_iterator &,
                  const dealii::types::boundary_id,
                  const std::vector<SurfacePoint<dim>> &)> &visit);

  /// A force in N (N/m in 2D) and its moment in N m (N in 2D).
  template <int dim>
  struct Load
  {
    /// About z in 2D.
    static constexpr unsigned int n_moments = dim == 2 ? 1 : 3;

    dealii::Tensor<1, dim>       force;
    dealii::Tensor<1, n_moments> moment;

    /// Adds a force with its lever.
    void
    add(const dealii::Tensor<1, dim> &lever,
        const dealii::Tensor<1, dim> &additional_force);

    Load &
    operator+=(const Load &other)
    {
      force += other.force;
      moment += other.moment;
      return *this;
    }
  };

  /// What the stresses at a boundary add up to.
  template <int dim>
  struct StressLoads
  {
    Load<dim> pressure;
    Load<dim> viscous;
  };

  /// Integrates the stresses of the fluid on the boundaries @p ids.
  /// Collective. @param center m, of the moments
  template <int dim>
  StressLoads<dim>
  integrate_stresses(const FlowFields<dim>                      &flow,
                     const std::set<dealii::types::boundary_id> &ids,
                     const dealii::Point<dim>                   &center);

  /**
   * @brief Adds up the reactions of all degrees of freedom on the boundaries
   * @p ids. Collective.
   *
   * Nodes that these boundaries share with others count as a whole.
   */
  template <int dim>
  Load<dim>
  sum_reactions(const FlowFields<dim>                      &flow,
                const std::set<dealii::types::boundary_id> &ids,
                const dealii::Point<dim>                   &center);
} // namespace Thalweg

#endif
