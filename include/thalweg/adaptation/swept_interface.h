// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_adaptation_swept_interface_h
#define thalweg_adaptation_swept_interface_h

#include <thalweg/adaptation/refinement_criterion.h>

#include <deal.II/base/bounding_box.h>

#include <memory>

namespace Thalweg
{
  /**
   * @brief Where the interface is, and where the flow will carry it: a box
   * around its piece in each cut cell, and boxes along the way from there.
   *
   * Where fluid is thinner than a cell, only particles know of it: boxes
   * around those that stand in the midst of the other fluid belong to the
   * interface. Else a thread would be lost in the coarse cells that it is left
   * in, of whose particles many are removed.
   *
   * The level set itself says nothing about distances beyond a cell or two;
   * these boxes do, at any distance, and the answer depends neither on how
   * the mesh is distributed nor on its fineness there. Boxes are sent to the
   * processes whose cells they may concern, in a periodic domain their images
   * too.
   */
  template <int dim>
  class SweptInterface
  {
  public:
    using Box = dealii::BoundingBox<dim>;

    /**
     * @brief Collects the boxes. Collective.
     * @param solution with two fluids; with one there is no interface
     * @param levels the interface is followed in steps of a finest cell
     * @param time for which the cells' mean velocities carry it along straight
     *   lines, in s
     * @param reach up to which distance will be asked for, in finest cells
     */
    SweptInterface(const FlowView<dim> &solution,
                   const LevelRange    &levels,
                   const double         time,
                   const double         reach);

    ~SweptInterface();

    /// Whether a box of this process's part of the domain is nearer than
    /// @p distance, in m.
    bool
    is_near(const Box &box, const double distance) const;

  private:
    struct Tree;
    std::unique_ptr<Tree> tree;
  };



  /// The longest edge that a descendant (or ancestor) of a cell on level
  /// @p level has, in m, if edges halve from level to level.
  template <int dim>
  double
  edge_on_level(const CellGraph<dim> &graph,
                const unsigned int    cell,
                const unsigned int    level);
} // namespace Thalweg

#endif
