// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_transfer_projection_h
#define thalweg_transfer_projection_h

#include <thalweg/core/registry.h>
#include <thalweg/fields/node_space.h>
#include <thalweg/materials/fluids.h>
#include <thalweg/particles/population.h>

#include <limits>

namespace Thalweg
{
  /**
   * @brief From the particles to the nodes; registered under "Projection".
   */
  template <int dim>
  class Projection
  {
  public:
    virtual ~Projection() = default;

    virtual void
    declare_parameters(const Section &section) = 0;

    /**
     * @brief Projects what the particles carry.
     * @param population particles with valid reference coordinates
     * @param space nodes to project to
     * @param fluids for the particles' densities
     * @param velocity in: fallback at nodes that no particle reaches; out:
     *   V*, ghosted, m/s
     * @param level_set likewise
     */
    virtual void
    project(const Population<dim> &population,
            const NodeSpace<dim>  &space,
            const Fluids          &fluids,
            Vector                &velocity,
            Vector                &level_set) const = 0;

    /// At how many times the shortest edge of their cell particles' level sets
    /// are cut off before they are averaged.
    double band = std::numeric_limits<double>::infinity();

    /// Whether it is kept a distance while particles move (CarriedDistance):
    /// what is not on a plane then is noise, otherwise what the flow has
    /// distorted.
    bool distances_are_kept = false;

    /// Whether what particles carry is the distance from the interface.
    bool
    takes_distances() const
    {
      return band < std::numeric_limits<double>::infinity();
    }
  };

  /**
   * @brief V* from the particles' momentum: means with the shape functions and
   * the densities as weights (Eq. 69), and once more the means of what they
   * leave, V* = P V_p + P (V_p - N P V_p).
   *
   * Beside a surface or a wall the particles around a node stand to one side
   * of it, and their mean is off by their distance times the velocity's
   * gradient: of first order. What they miss of it tells the difference. The
   * first two terms of the series for the least squares with the particles'
   * masses; never more than twice as sensitive to single particles as means.
   *
   * @param velocity in: what stays at nodes that no particle reaches; out:
   *   ghosted, m/s
   */
  template <int dim>
  void
  project_momentum(const Population<dim> &population,
                   const NodeSpace<dim>  &space,
                   const Fluids          &fluids,
                   Vector                &velocity);

  /// V_p += factor (V^{n+1} - V*)(x_p), Eq. 81e and 87.
  template <int dim>
  void
  add_increment(Population<dim>      &population,
                const NodeSpace<dim> &space,
                const Vector         &new_velocity,
                const Vector         &velocity_star,
                const double          factor = 1.);

  /**
   * @brief Adds @p factor times a shift of the level set to what particles
   * carry, so that it lasts. Their fluids stay, and their places.
   * @param shift at the nodes, ghosted, in units of the level set
   */
  template <int dim>
  void
  shift_level_sets(Population<dim>      &population,
                   const NodeSpace<dim> &space,
                   const Vector         &shift,
                   const double          factor);
} // namespace Thalweg

#endif
