// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_dispersed_field_h
#define thalweg_particles_dispersed_field_h

#include <thalweg/mesh/cell_field.h>
#include <thalweg/mesh/cell_graph.h>
#include <thalweg/particles/steady_field.h>
#include <thalweg/particles/walker.h>

#include <array>
#include <functional>

namespace Thalweg
{
  /// How drops and bubbles move that are finer than the mesh.
  template <int dim>
  struct DispersedMotion
  {
    using Coordinates = std::array<double, dim>;

    /// What accelerates a drop, m/s^2. @param velocity of it, m/s
    std::function<Coordinates(const dealii::Point<dim> &place,
                              const Coordinates        &velocity)>
      acceleration;
    /// The velocity of a bubble through the fluid around it, m/s.
    /// @param volume of it, m^dim
    std::function<Coordinates(const dealii::Point<dim> &place,
                              const double              volume)>
      rise;
  };

  /**
   * @brief What moves drops of the first fluid in the second and bubbles of
   * the second in the first, for StreamlineWalk.
   *
   * Drops have a velocity of their own and an acceleration that does not
   * change while they fly: they follow parabolas exactly. Bubbles go with the
   * velocity of the mesh and through it. Both go until they meet their own
   * fluid.
   */
  template <int dim>
  class DispersedField
  {
  public:
    static constexpr bool accelerates = true;
    static constexpr bool disperses   = true;
    static constexpr bool has_bubbles = false;
    using WalkerType                  = DispersedWalker<dim>;
    using Coordinates                 = std::array<double, dim>;

    /**
     * @param graph the cells
     * @param level_set of all owned and ghost cells, negative in the first
     *   fluid
     * @param velocity of the mesh there, m/s
     * @param greatest_way of a substep, in parts of the cell
     * @param motion must outlive the object
     */
    DispersedField(const CellGraph<dim>       &graph,
                   const CellField<dim, 1>    &level_set,
                   const CellVelocity<dim>    &velocity,
                   const double                greatest_way,
                   const DispersedMotion<dim> &motion);

    /**
     * @brief Makes a walker that stands at @p place a drop or a bubble.
     * @param fluid that it consists of, 0 or 1
     * @param velocity m/s
     * @param volume m^dim
     */
    void
    launch(WalkerType               &walker,
           const dealii::Point<dim> &place,
           const unsigned int        fluid,
           const Coordinates        &velocity,
           const double              volume) const;

    double
    longest_substep(const WalkerType &walker) const;

    Coordinates
    velocity(const WalkerType  &walker,
             const Coordinates &reference,
             const double       time_left) const
    {
      const auto &cell   = graph.cell(walker.cell);
      Coordinates result = velocity_after(walker, walker.time - time_left);
      if (cell.axis_parallel)
        for (unsigned int d = 0; d < dim; ++d)
          result[d] *= cell.inverse_extent[d];
      if (walker.is_bubble)
        {
          const Coordinates carried =
            flow.velocity(walker, reference, time_left);
          for (unsigned int d = 0; d < dim; ++d)
            result[d] += carried[d];
        }
      return result;
    }

    Coordinates
    acceleration(const WalkerType &walker,
                 const Coordinates & /*reference*/,
                 const double /*time_left*/) const
    {
      return walker.acceleration;
    }

    /// The way of a drop in a time, m.
    static Coordinates
    way(const WalkerType &walker, const double time)
    {
      Coordinates result = velocity_after(walker, .5 * time);
      for (double &component : result)
        component *= time;
      return result;
    }

    /// Takes what goes along @p normal from the velocity of a drop: walls are
    /// inelastic and smooth.
    void
    hit(WalkerType &walker, const Coordinates &normal) const;

    /// Whether a walker stands in its own fluid.
    bool
    lands(const WalkerType &walker) const;

  private:
    /// The own velocity of a walker a time after where it is, m/s.
    static Coordinates
    velocity_after(const WalkerType &walker, const double time)
    {
      Coordinates result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = walker.first_velocity[d] + walker.integral[d] +
                    time * walker.acceleration[d];
      return result;
    }

    const CellGraph<dim>       &graph;
    const CellField<dim, 1>    &level_set;
    const SteadyField<dim>      flow;
    const double                greatest_way;
    const DispersedMotion<dim> &motion;
  };
} // namespace Thalweg

#endif
