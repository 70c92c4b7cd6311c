// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_transfer_scalar_projection_h
#define thalweg_transfer_scalar_projection_h

#include <thalweg/particles/population.h>
#include <thalweg/transfer/node_targets.h>
#include <thalweg/transfer/quadratic_moments.h>

#include <array>
#include <vector>

namespace Thalweg
{
  /**
   * @brief A property that was added to particles, from them to the nodes.
   *
   * Around each node the polynomial of second degree is sought that fits the
   * particles best, with the shape function as weight: what is smooth comes
   * with an error of third order, whose second derivatives, which diffusion
   * takes, still vanish with the cells. Where the particles are far from any
   * such polynomial, as at a jump, the node's value stays between theirs.
   */
  template <int dim>
  class ScalarProjection
  {
  public:
    /// @param space must outlive the object
    explicit ScalarProjection(const NodeSpace<dim> &space);

    /**
     * @brief Projects. Collective.
     * @param population particles with valid reference coordinates; those to
     *   whom the property is unknown count for nothing
     * @param property its place in their rows
     * @param scalar in: a guess, ghosted, which stays at nodes that no particle
     *   reaches; out: ghosted and consistent
     * @param fluids whose particles count
     */
    void
    project(const Population<dim>     &population,
            const unsigned int         property,
            Vector                    &scalar,
            const std::array<bool, 2> &fluids = {{true, true}});

    /// The least and the greatest value around each node in the last
    /// projection, or what was projected where there is none. Ghosted.
    const Vector &
    lower() const
    {
      return least;
    }

    const Vector &
    upper() const
    {
      return greatest;
    }

  private:
    void
    add_cell(const Population<dim>     &population,
             const unsigned int         property,
             const unsigned int         cell,
             const Vector              &guess,
             const std::array<bool, 2> &fluids);

    /// Adds up what the ranks have.
    void
    join();

    /// By how much an owned node's value is not the guess.
    double
    change(const unsigned int node) const;

    const NodeSpace<dim>              &space;
    double                             length; ///< the unit of offsets, m
    std::vector<QuadraticMoments<dim>> nodal;
    Vector                             least, greatest;
    std::vector<NodeTarget<dim>>       targets;
  };
} // namespace Thalweg

#endif
