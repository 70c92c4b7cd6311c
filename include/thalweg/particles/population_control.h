// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_population_control_h
#define thalweg_particles_population_control_h

#include <thalweg/core/section.h>
#include <thalweg/particles/streamline_convection.h>

#include <functional>
#include <map>
#include <vector>

namespace Thalweg
{
  /// How many particles a cell should have.
  template <int dim>
  struct PopulationParameters
  {
    /// Declares the parameters in @p section.
    void
    declare_parameters(const Section &section);

    /// @throws dealii::ExcMessage if the limits leave no room between them
    void
    check() const;

    /// In cells with fewer, empty sub-cells are filled.
    unsigned int minimum_per_cell = dim == 2 ? 6 : 18;
    /// In cells with more, particles are removed.
    unsigned int maximum_per_cell = dim == 2 ? 18 : 54;
    /// Whether new particles get the sign of the level set, 1 or -1, instead
    /// of its value.
    bool level_set_is_sign = true;
    /// Whether particles carry volume, which new ones take from others of
    /// their fluid in the cell, and removed ones leave to their neighbours.
    bool carry_volume = false;
  };

  /// The level set of what comes in through boundaries, at a point there.
  template <int dim>
  using InflowLevelSet =
    std::map<dealii::types::boundary_id,
             std::function<double(const dealii::Point<dim> &)>>;

  /**
   * @brief Keeps the number of particles in each cell between a minimum and a
   * maximum.
   *
   * A cell is looked at by its 2^dim sub-cells, the halves of its reference
   * coordinates in each direction, so that holes are filled where they are.
   */
  template <int dim>
  class PopulationControl
  {
  public:
    static constexpr unsigned int n_sub_cells = 1 << dim;

    /**
     * @brief Finds where the particles that stand at given points now have
     * come from in this time step. Collective.
     *
     * Arguments: numbers of owned cells in the cell graph, and as many points
     * in their reference coordinates.
     */
    using Tracer = std::function<
      std::vector<Foot<dim>>(const std::vector<unsigned int> &,
                             const std::vector<dealii::Point<dim>> &)>;

    /**
     * @param parameters the bounds
     * @param convection finds the origin of new particles; must outlive this
     *   object
     * @param inflow_level_set of what comes in through open boundaries; at
     *   others new particles take it from the field
     * @throws dealii::ExcMessage if the maximum is not above the minimum, or
     *   below the number of sub-cells
     */
    PopulationControl(const PopulationParameters<dim> &parameters,
                      const StreamlineConvection<dim> &convection,
                      const InflowLevelSet<dim>       &inflow_level_set);

    /// The same for those who find the origin of new particles themselves,
    /// with a Tracer.
    PopulationControl(const PopulationParameters<dim> &parameters,
                      const InflowLevelSet<dim>       &inflow_level_set);

    /**
     * @brief Puts a particle into each empty sub-cell of the cells that have
     * fewer than the minimum. Collective.
     *
     * To be called after the particles were moved: a new particle gets the
     * velocity and the level set from the place where it was a time step
     * ago, on the streamline that leads to it.
     *
     * @param population gets the particles
     * @param tracer finds where new particles come from, and their velocity
     *   and level set; at boundaries with an inflow level set this one is
     *   taken instead
     * @return the number of new particles on this rank
     */
    unsigned int
    fill_empty_cells(Population<dim> &population, const Tracer &tracer) const;

    /**
     * @brief The same with the streamlines of a steady field for tracer.
     *
     * @param population gets the particles
     * @param velocity with which the others were moved, in m/s
     * @param level_set before they were moved
     * @param dt by which the others were moved, in s
     * @return the number of new particles on this rank
     */
    unsigned int
    fill_empty_cells(Population<dim>         &population,
                     const CellVelocity<dim> &velocity,
                     const CellField<dim, 1> &level_set,
                     const double             dt) const;

    /**
     * @brief Removes particles from cells that have more than the maximum:
     * those that are nearest to another one of the same fluid, which takes
     * their volume and momentum. Collective.
     *
     * The particles of both fluids decrease in the same proportion, and no
     * fluid vanishes from a cell.
     * @return the number of particles that were removed on this rank
     */
    unsigned int
    limit(Population<dim> &population) const;

  private:
    double
    level_set_value(const Foot<dim> &foot) const;

    const PopulationParameters<dim>  parameters;
    const StreamlineConvection<dim> *convection;
    const InflowLevelSet<dim>        inflow_level_set;
  };
} // namespace Thalweg

#endif
