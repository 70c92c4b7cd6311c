// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_path_field_h
#define thalweg_particles_path_field_h

#include <thalweg/mesh/cell_graph.h>
#include <thalweg/particles/path_convection.h>
#include <thalweg/particles/walker.h>

#include <array>
#include <vector>

namespace Thalweg
{
  /**
   * @brief A velocity and an acceleration that are polynomials of a degree in
   * each coordinate, and linear in time, for StreamlineWalk.
   */
  template <int dim, unsigned int degree>
  class PathField
  {
  public:
    static constexpr unsigned int n = degree + 1;
    static constexpr unsigned int n_nodes =
      dim == 1 ? n : (dim == 2 ? n * n : n * n * n);
    static constexpr bool accelerates = true;
    static constexpr bool disperses   = false;
    static constexpr bool has_bubbles = false;
    using WalkerType                  = PathWalker<dim>;
    using Coordinates                 = std::array<double, dim>;

    /**
     * @param graph the cells
     * @param fields of the given degree
     * @param dt the length of the step, in s
     * @param greatest_way of a substep, in parts of the cell
     * @param direction 1 to go from the beginning of the step to its end, -1
     *   for the opposite
     */
    PathField(const CellGraph<dim>  &graph,
              const PathFields<dim> &fields,
              const double           dt,
              const double           greatest_way,
              const double           direction);

    double
    longest_substep(const WalkerType &walker) const
    {
      return flow[walker.cell].longest_substep;
    }

    Coordinates
    velocity(const WalkerType  &walker,
             const Coordinates &reference,
             const double       time_left) const
    {
      return evaluate(flow[walker.cell].velocity, reference, time_left);
    }

    Coordinates
    acceleration(const WalkerType  &walker,
                 const Coordinates &reference,
                 const double       time_left) const
    {
      return evaluate(flow[walker.cell].acceleration, reference, time_left);
    }

    /// The velocity of the flow, whatever the cell and the direction, in m/s.
    Coordinates
    flow_velocity(const typename CellGraph<dim>::Cell &geometry,
                  const unsigned int                   cell,
                  const Coordinates                   &reference,
                  const double                         time_left) const
    {
      Coordinates result = evaluate(flow[cell].velocity, reference, time_left);
      for (unsigned int d = 0; d < dim; ++d)
        result[d] *=
          direction * (geometry.axis_parallel ? geometry.extent[d] : 1.);
      return result;
    }

  private:
    /// Values at the beginning of the step and how much they change in it.
    static constexpr unsigned int width = 2 * dim;
    using Pair                          = std::array<double, width>;
    /// Coefficients of 1, x, xx, y, xy, ...
    using Polynomial = std::array<Pair, n_nodes>;

    struct Flow
    {
      Polynomial velocity;
      Polynomial acceleration;
      double     longest_substep;
    };

    static Polynomial
    nodal_values(const std::vector<double> &begin,
                 const std::vector<double> &end,
                 const unsigned int         cell);

    static void
    to_polynomial(Polynomial &values);

    double
    scale_velocity(const typename CellGraph<dim>::Cell &geometry,
                   Polynomial                          &velocity) const;

    /// result = result * x + summand
    static void
    horner(Pair &result, const double x, const Pair &summand)
    {
      for (unsigned int c = 0; c < width; ++c)
        result[c] = result[c] * x + summand[c];
    }

    static Pair
    row(const Pair *a, const double x)
    {
      Pair result = a[degree];
      for (unsigned int i = degree; i > 0; --i)
        horner(result, x, a[i - 1]);
      return result;
    }

    static Pair
    plane(const Pair *a, const Coordinates &x)
    {
      Pair result = row(a + n * degree, x[0]);
      for (unsigned int i = degree; i > 0; --i)
        horner(result, x[1], row(a + n * (i - 1), x[0]));
      return result;
    }

    Coordinates
    evaluate(const Polynomial  &a,
             const Coordinates &x,
             const double       time_left) const
    {
      Pair pair;
      if constexpr (dim == 2)
        pair = plane(a.data(), x);
      else
        {
          pair = plane(a.data() + n * n * degree, x);
          for (unsigned int i = degree; i > 0; --i)
            horner(pair, x[dim - 1], plane(a.data() + n * n * (i - 1), x));
        }
      const double s = first_part + part_per_time * time_left;
      Coordinates  result;
      for (unsigned int c = 0; c < dim; ++c)
        result[c] = pair[c] + s * pair[dim + c];
      return result;
    }

    const double direction;
    /// The part of the step that is over is linear in a walker's time left.
    double            first_part;
    double            part_per_time;
    std::vector<Flow> flow;
  };
} // namespace Thalweg

#endif
