// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_boundary_exchange_h
#define thalweg_particles_boundary_exchange_h

#include <thalweg/fields/boundary_nodes.h>
#include <thalweg/particles/boundary_flux.h>
#include <thalweg/particles/face_accounts.h>
#include <thalweg/particles/population_control.h>
#include <thalweg/particles/volume_books.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief What comes in and goes out through the boundaries, face by face,
   * as the velocity there says, at any step size.
   *
   * Particles are lumps; the flux is not. What flows in through a face waits
   * there until it fills a particle, which then starts from the face. What
   * flows out is taken from the particles in the order in which they come to
   * the face, before they cross it, from both fluids in proportion to those
   * that come next; what one of them takes out beyond that is given back to
   * those behind it, or waits at the face to go first. So the volume inside
   * follows the flux to round-off in each step. What the particles before a
   * face lack stays owed there.
   *
   * Where the velocity is given, the flux is that of the given function.
   * Those of open boundaries are scaled so that all fluxes together vanish.
   */
  template <int dim>
  class BoundaryExchange
  {
  public:
    /**
     * @param space, boundary of the present mesh
     * @param inflow_level_set of the boundaries where fluid can pass
     * @param convection moves what comes in
     * @param particles_per_direction that fill a cell
     */
    BoundaryExchange(const NodeSpace<dim>            &space,
                     const BoundaryNodes<dim>        &boundary,
                     const InflowLevelSet<dim>       &inflow_level_set,
                     const StreamlineConvection<dim> &convection,
                     const unsigned int               particles_per_direction);

    /**
     * @brief Lets fluid in and out for a step in which the particles have
     * been moved already. Collective.
     *
     * @param population loses and gets volumes and particles
     * @param report of the particles that left
     * @param velocity with which they moved, ghosted, m/s
     * @param cell_velocity the same cell by cell
     * @param dt in s; conditions are evaluated at the time they are set to
     * @return the number of new particles on this rank
     */
    unsigned int
    pass(Population<dim>         &population,
         const ConvectionReport  &report,
         const Vector            &velocity,
         const CellVelocity<dim> &cell_velocity,
         const double             dt);

    /// Begins the books with what the particles carry now. Collective.
    void
    open_books(const Population<dim> &population);

    /// Adds what waits at faces to the volumes of the owned cells.
    void
    add_waiting(std::vector<FluidVolumes> &volumes_of_cells) const;

    const VolumeBooks &
    books() const
    {
      return volume_books;
    }

    /// Names the books and what waits at the faces, for the same mesh or
    /// another one. Collective.
    void
    keep(const Archive &archive);

  private:
    void
    let_out(Population<dim>             &population,
            const std::vector<FaceFlux> &fluxes,
            const ConvectionReport      &report,
            VolumeBooks                 &counted);

    /// Drops and bubbles take nothing of the flux along: the fluid around them
    /// comes in their place.
    void
    let_out_dispersed(const std::vector<Exit> &exits, VolumeBooks &counted);

    /// Settles with the particles before a face what is owed there.
    static void
    settle(std::vector<typename Population<dim>::Particle> &nearest_first,
           FaceAccount                                     &account,
           FluidVolumes                                    &out);

    /// Makes particles of what waits at a face, a row as it comes in.
    /// @param passed what of it came in during the step, m^dim
    /// @param population that they are for
    void
    fill_particles(const Population<dim>         &population,
                   const unsigned int             face,
                   const unsigned int             fluid,
                   const double                   passed,
                   const CellVelocity<dim>       &cell_velocity,
                   const double                   dt,
                   std::vector<NewParticle<dim>> &particles);

    const NodeSpace<dim>            &space;
    const BoundaryNodes<dim>        &boundary;
    const Inflow<dim>                inflow;
    const StreamlineConvection<dim> &convection;
    const unsigned int               particles_per_direction;

    FaceAccounts<dim> accounts; ///< one a passable face
    VolumeBooks       volume_books;
  };
} // namespace Thalweg

#endif
