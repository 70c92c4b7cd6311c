// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_interface_curvature_h
#define thalweg_interface_curvature_h

#include <thalweg/fields/node_space.h>

#include <map>
#include <vector>

namespace Thalweg
{
  /**
   * @brief The curvature of the interface, from the distance to it.
   *
   * Around each node a linear function is sought that fits the gradients in
   * the middles of the cells best, @f$b + H (x - x_i)@f$; where the mesh is
   * made of parallelepipeds it is exact for polynomials of second degree, and
   * the sum of the principal curvatures is the trace of
   * @f$S = P H P / |b|@f$ with @f$P = I - b b^T / |b|^2@f$. At walls the
   * direction of the gradient is given by the contact angle. A node at the
   * distance @f$\phi@f$ tells of the nearest point of the interface
   * @f$k / (1 - \phi k)@f$ for each principal curvature @f$k@f$ of its own
   * contour; a filter of means over cells around it, in which those near the
   * interface with large gradients count most, takes the noise away and
   * reaches to nodes that know nothing.
   */
  template <int dim>
  class Curvature
  {
  public:
    /// @param space must outlive the object @param angles at walls, measured
    ///   where the level set is negative, rad
    Curvature(const NodeSpace<dim>                               &space,
              const std::map<dealii::types::boundary_id, double> &angles);

    /**
     * @brief Finds it at the nodes near the interface. Collective.
     * @param distance from the interface at the nodes, m, ghosted. That from
     *   the interface which the mesh shows: what particles carry besides
     *   would let it drift away from where the force vanishes
     * @param curvature div(grad phi / |grad phi|), 1/m, ghosted
     * @param weight 1 where it is known, ghosted
     */
    void
    find(const Vector &distance, Vector &curvature, Vector &weight) const;

    /**
     * @brief Lets nodes that do not know a quantity take the mean of cells
     * around them where others do. Collective.
     * @param weight 1 where it is known, ghosted
     * @param factor what the mean is multiplied by
     */
    void
    spread(const double factor, Vector &weight, Vector &quantity) const;

    /// Whether a node of a cell is near the interface. @param distance ghosted
    bool
    is_near(const unsigned int cell, const Vector &distance) const;

  private:
    struct Moments;

    /// Adds the gradient in the middle of a cell to its nodes.
    void
    add_cell(const unsigned int    cell,
             const Vector         &distance,
             std::vector<Moments> &nodal) const;

    /// Adds what walls ask of it, where the interface is near.
    void
    add_walls(const unsigned int    cell,
              const Vector         &distance,
              std::vector<Moments> &nodal) const;

    /// Adds a gradient at @p position to the nodes of a cell that do not hang;
    /// to those of one face, if @p face_no is one.
    void
    add(const unsigned int            cell,
        const int                     face_no,
        const dealii::Point<dim>     &position,
        const dealii::Tensor<1, dim> &gradient,
        std::vector<Moments>         &nodal) const;

    /// Lets nodes near the interface take means over the cells around them.
    void
    take_means(const Vector &distance, Vector &weight, Vector &curvature) const;

    /**
     * With the operator S of take_means(): 3 S^2 - 2 S^3, which takes away
     * what is not longer than three cells and leaves what is longer than ten,
     * to fourth order. The sum over such short waves, which particles carry
     * and the mesh hardly shows, would drive them.
     */
    void
    filter(const Vector &distance, Vector &weight, Vector &curvature) const;

    /**
     * @brief Finds the weighted mean of a quantity at the nodes of the cells
     * around each owned node. Collective.
     * @param weight of a node in a cell
     * @param mean 0 where there is none
     * @param is_known whether there is one
     */
    template <typename Weight>
    void
    find_means(const Vector      &quantity,
               const Weight      &weight,
               Vector            &mean,
               std::vector<bool> &is_known) const;

    const NodeSpace<dim>                              &space;
    const std::map<dealii::types::boundary_id, double> angles;
    /// How far from the interface the nodes of a cell tell of it, m.
    std::vector<double> reach;
  };
} // namespace Thalweg

#endif
