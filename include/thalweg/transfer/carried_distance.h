// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_transfer_carried_distance_h
#define thalweg_transfer_carried_distance_h

#include <thalweg/fields/node_space.h>
#include <thalweg/particles/population.h>

namespace Thalweg
{
  /**
   * @brief Keeps what particles carry the distance from the interface while
   * they move.
   *
   * A particle at @f$x@f$ that moves with @f$V(x)@f$ goes away from the nearest
   * point @f$c@f$ of the interface at the rate
   * @f$r = (V(x) - V(c))\cdot n@f$ (the velocity of an interface, extended
   * along its normals, leaves a distance one: D. Adalsteinsson and J. Sethian,
   * J. Comput. Phys. 148, 1999). What is carried is multiplied, so that it
   * never changes its sign, and where the motion is a rigid one it does not
   * change.
   *
   * Without it the velocity's kink at the interface of two fluids bends what is
   * carried there, and the interface lags behind by a part of @f$kh@f$.
   */
  template <int dim>
  class CarriedDistance
  {
  public:
    explicit CarriedDistance(const NodeSpace<dim> &space);

    /**
     * @brief Finds the rates in two rings of cells around the interface.
     * @param phi distance from the interface at the nodes, m, ghosted
     * @param velocity of the motion, m/s, ghosted
     */
    void
    find_rates(const Vector &phi, const Vector &velocity);

    /// Changes what the particles carry as the motion of the next @p dt
    /// seconds does.
    void
    apply(Population<dim> &population, const double dt) const;

    /// The same for @p level_set at the nodes, which new particles get.
    void
    apply(Vector &level_set, const double dt) const;

  private:
    /// The normal component of the strain rate in the middle of a cell, 1/s.
    double
    normal_stretch(const unsigned int cell,
                   const Vector      &phi,
                   const Vector      &velocity) const;

    /// Finds rates at the nodes of cut cells, or where there are none yet at
    /// those of cells beside the nodes that have one.
    void
    spread(const Vector &phi,
           const Vector &velocity,
           const bool    from_cut_cells);

    /// Turns the sums over cells into means where there are none yet.
    void
    take_means();

    const NodeSpace<dim> &space;
    Vector                distance; ///< copy of phi
    Vector                rate;     ///< r, m/s
    Vector                is_known; ///< 1 where the rate is known
    /// What the cells around a node say of it: a + b phi, of so many cells.
    Vector sum, slopes, count;
  };
} // namespace Thalweg

#endif
