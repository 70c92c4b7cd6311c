// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_steady_field_h
#define thalweg_particles_steady_field_h

#include <thalweg/mesh/cell_field.h>
#include <thalweg/mesh/cell_graph.h>
#include <thalweg/particles/cell_polynomial.h>
#include <thalweg/particles/walker.h>

#include <array>
#include <vector>

namespace Thalweg
{
  /**
   * @brief A multilinear velocity that does not change during the step, for
   * StreamlineWalk.
   */
  template <int dim>
  class SteadyField
  {
  public:
    static constexpr unsigned int n_vertices  = 1 << dim;
    static constexpr bool         accelerates = false;
    static constexpr bool         disperses   = false;
    using WalkerType                          = Walker<dim>;
    using Coordinates                         = std::array<double, dim>;

    /**
     * @param graph the cells
     * @param velocity nodal values of all owned and ghost cells, in m/s
     * @param greatest_way of a substep, in parts of the cell
     * @param direction 1 to go with the velocity, -1 against it
     */
    SteadyField(const CellGraph<dim>    &graph,
                const CellVelocity<dim> &velocity,
                const double             greatest_way,
                const double             direction);

    double
    longest_substep(const WalkerType &walker) const
    {
      return flow[walker.cell].longest_substep;
    }

    Coordinates
    velocity(const WalkerType  &walker,
             const Coordinates &reference,
             const double /*time_left*/) const
    {
      return CellPolynomial::evaluate(flow[walker.cell].velocity, reference);
    }

  private:
    /// Coefficients of 1, x, y, xy, z, ... for each component.
    using Polynomial = std::array<double, dim * n_vertices>;

    struct Flow
    {
      Polynomial velocity;
      double     longest_substep;
    };

    static Flow
    prepare(const typename CellGraph<dim>::Cell &cell,
            const Polynomial                    &nodal_velocity,
            const double                         greatest_way,
            const double                         direction);

    std::vector<Flow> flow;
  };
} // namespace Thalweg

#endif
