// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_path_convection_h
#define thalweg_particles_path_convection_h

#include <thalweg/particles/population.h>
#include <thalweg/particles/streamline_convection.h>

#include <map>
#include <vector>

namespace Thalweg
{
  /**
   * @brief What moves particles in one time step: a velocity and an
   * acceleration at the beginning and at the end of the step, linear in time
   * in between.
   *
   * Nodal values are copied out cell by cell, for all owned and ghost cells
   * in the order of the CellGraph: entry
   * `[(cell * n_nodes_per_cell() + node) * dim + component]`. The nodes of a
   * cell are equidistant in its reference coordinates and numbered
   * lexicographically, x fastest. Fields have to be continuous, also at
   * hanging nodes.
   */
  template <int dim>
  struct PathFields
  {
    /// 1 or 2.
    unsigned int        degree = 1;
    std::vector<double> begin_velocity;     ///< m/s
    std::vector<double> end_velocity;       ///< m/s
    std::vector<double> begin_acceleration; ///< m/s^2
    std::vector<double> end_acceleration;   ///< m/s^2

    /// (degree + 1)^dim
    unsigned int
    n_nodes_per_cell() const
    {
      unsigned int n = 1;
      for (unsigned int d = 0; d < dim; ++d)
        n *= degree + 1;
      return n;
    }

    /// Makes room for the values of @p n_cells cells, all zero.
    void
    resize(const unsigned int n_cells)
    {
      const std::size_t n =
        static_cast<std::size_t>(n_cells) * n_nodes_per_cell() * dim;
      for (auto *field : {&begin_velocity,
                          &end_velocity,
                          &begin_acceleration,
                          &end_acceleration})
        field->assign(n, 0.);
    }
  };

  /**
   * @brief Moves particles along their paths in a velocity field that changes
   * during the step, and changes their velocity by the acceleration that they
   * meet on the way (Eq. 62-66, 81a), at any Courant number and across ranks.
   *
   * Position and velocity are integrated together by the same scheme: with
   * the order of the integrator in the substep where the fields are smooth.
   */
  template <int dim>
  class PathConvection
  {
  public:
    /**
     * @param mesh its cell graph must be up to date at each call; must
     *   outlive this object
     * @param parameters the integrator
     * @param walls what particles do at which boundary; those that are not
     *   listed are walls
     * @throws dealii::ExcMessage for parameters that make no sense
     */
    PathConvection(const Mesh<dim>            &mesh,
                   const ConvectionParameters &parameters,
                   const std::map<dealii::types::boundary_id, WallKind> &walls);

    /**
     * @brief Moves all particles by the time @p dt: x_p along its path, and
     * V_p += integral of a(x_p(t), t) dt. Collective.
     *
     * Afterwards the particles of each cell are ordered by id, whatever their
     * order was before; iterators to particles are invalid. A particle whose
     * position or velocity becomes undefined is removed and counted as lost.
     *
     * @param population each particle's reference coordinates must be those
     *   in its cell
     * @param fields at the beginning and the end of this step
     * @param dt in s, not negative
     */
    ConvectionReport
    move(Population<dim>       &population,
         const PathFields<dim> &fields,
         const double           dt) const;

    /**
     * @brief Follows the paths through given points back from the end of the
     * step to its beginning. Collective; ranks may ask for any number of
     * points.
     *
     * `Foot::velocity` is what a particle would have on arrival that had the
     * velocity of the field where and when its path began: the velocity field
     * at the foot plus the integral of the acceleration from there to the
     * point. A path that came in through an open boundary begins there at
     * that time, otherwise at the beginning of the step. `Foot::level_set` is
     * -1: there is one fluid. A foot that was not found stands at the point
     * itself and has the velocity there at the end of the step.
     *
     * @param cells numbers of owned cells in the cell graph, one a point
     * @param reference_points coordinates in these cells
     * @param fields at the beginning and the end of this step
     * @param dt in s, not negative
     * @return one foot a point
     */
    std::vector<Foot<dim>>
    trace_back(const std::vector<unsigned int>       &cells,
               const std::vector<dealii::Point<dim>> &reference_points,
               const PathFields<dim>                 &fields,
               const double                           dt) const;

    const Mesh<dim> &
    mesh() const
    {
      return mesh_;
    }

  private:
    template <unsigned int degree>
    ConvectionReport
    move_in(Population<dim>       &population,
            const PathFields<dim> &fields,
            const double           dt) const;

    template <unsigned int degree>
    std::vector<Foot<dim>>
    trace_back_in(const std::vector<unsigned int>       &cells,
                  const std::vector<dealii::Point<dim>> &reference_points,
                  const PathFields<dim>                 &fields,
                  const double                           dt) const;

    const Mesh<dim>   &mesh_;
    const WalkSettings settings;
  };
} // namespace Thalweg

#endif
