// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_boundary_flux_h
#define thalweg_particles_boundary_flux_h

#include <thalweg/fields/boundary_nodes.h>
#include <thalweg/particles/population_control.h>
#include <thalweg/particles/volume_books.h>

#include <vector>

namespace Thalweg
{
  /// What passes a face at the boundary in a step, m^dim.
  struct FaceFlux
  {
    FluidVolumes in{};
    double       out = 0;
  };

  /// Which fluid comes in where.
  template <int dim>
  class Inflow
  {
  public:
    Inflow(const CellGraph<dim> &graph, const InflowLevelSet<dim> &level_sets)
      : graph(graph)
      , level_sets(level_sets)
    {}

    /// The level set of what comes in at the point @p xi of a face, given in
    /// its cell's reference coordinates.
    double
    value(const typename BoundaryNodes<dim>::Face &face,
          const dealii::Point<dim>                &xi) const;

  private:
    const CellGraph<dim>     &graph;
    const InflowLevelSet<dim> level_sets;
  };

  /**
   * @brief What passes the faces in a step. Collective.
   *
   * Where the velocity is given, this is the integral of the given function;
   * at open boundaries that of the nodal velocity, scaled so that all fluxes
   * together vanish: the domain holds a fixed volume.
   *
   * @param velocity ghosted, m/s
   * @param dt in s
   * @return one a passable face of this rank
   */
  template <int dim>
  std::vector<FaceFlux>
  find_fluxes(const NodeSpace<dim>     &space,
              const BoundaryNodes<dim> &boundary,
              const Inflow<dim>        &inflow,
              const Vector             &velocity,
              const double              dt);
} // namespace Thalweg

#endif
