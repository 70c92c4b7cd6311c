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
   * @brief A velocity that is given by its nodal values and does not change
   * during the step, for StreamlineWalk.
   *
   * A multilinear velocity whose divergence is zero in the mean of each cell
   * still has one that varies inside: particles gather on one side of the cell
   * and leave the other. `evenly_divergent` adds to each reference rate a
   * parabola that is zero at the faces that it crosses, so that nothing more
   * flows through any face (Meyer and Jenny, PAMM 4 (2004) 466, there for
   * boxes). Here it is the flux of the Piola transform, so that it holds for
   * all quadrilaterals and parallelepipeds; in other hexahedra the divergence
   * is that of the multilinear one without its linear part.
   */
  template <int dim>
  class SteadyField
  {
  public:
    static constexpr unsigned int n_vertices  = 1 << dim;
    static constexpr bool         accelerates = false;
    static constexpr bool         disperses   = false;
    static constexpr bool         has_bubbles = true;
    using WalkerType                          = Walker<dim>;
    using Coordinates                         = std::array<double, dim>;

    /**
     * @param graph the cells
     * @param velocity nodal values of all owned and ghost cells, in m/s
     * @param greatest_way of a substep, in parts of the cell
     * @param direction 1 to go with the velocity, -1 against it
     * @param shape of the velocity inside the cells
     */
    SteadyField(const CellGraph<dim>    &graph,
                const CellVelocity<dim> &velocity,
                const double             greatest_way,
                const double             direction,
                const VelocityShape      shape = VelocityShape::multilinear);

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

    /// Adds to a rate of the reference coordinates, in 1/s, what is not
    /// multilinear. @param stretch determinant of the cell's Jacobian there, 1
    /// where the cell is axis-parallel
    void
    add_bubbles(const WalkerType  &walker,
                const Coordinates &reference,
                const double       stretch,
                Coordinates       &rate) const
    {
      const Bubbles &a = flow[walker.cell].bubbles;
      Coordinates    from_middle;
      for (unsigned int d = 0; d < dim; ++d)
        from_middle[d] = reference[d] - .5;
      for (unsigned int d = 0; d < dim; ++d)
        rate[d] += reference[d] * (1. - reference[d]) / stretch *
                   factor(a, d, from_middle);
    }

  private:
    /// Coefficients of 1, x, y, xy, z, ... for each component.
    using Polynomial = std::array<double, dim * n_vertices>;
    /// Derivatives of a cell's map at its vertices.
    using Jacobians = std::array<dealii::Tensor<2, dim>, n_vertices>;
    /// Half of what the divergence rises along x, y, (z), and in three
    /// dimensions a quarter of its coefficients of yz, xz, xy.
    using Bubbles = std::array<double, dim == 2 ? 2 : 6>;

    struct Flow
    {
      Polynomial velocity;
      Bubbles    bubbles;
      double     longest_substep;
    };

    static double
    factor(const Bubbles     &bubbles,
           const unsigned int d,
           const Coordinates &from_middle)
    {
      if constexpr (dim == 2)
        return bubbles[d];
      else
        {
          const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;
          return bubbles[d] + bubbles[3 + e] * from_middle[f] +
                 bubbles[3 + f] * from_middle[e];
        }
    }

    static Flow
    prepare(const typename CellGraph<dim>::Cell &cell,
            const Polynomial                    &nodal_velocity,
            const double                         greatest_way,
            const double                         direction,
            const VelocityShape                  shape);

    /// What evens out a divergence, in the reference cell, with these values
    /// at the vertices.
    static Bubbles
    bubbles_of(const std::array<double, n_vertices> &divergence);

    /// A bound of what the bubbles add to a rate where the cell is stretched
    /// least.
    static double
    fastest_bubble(const Bubbles &bubbles);

    std::vector<Flow> flow;
  };
} // namespace Thalweg

#endif
