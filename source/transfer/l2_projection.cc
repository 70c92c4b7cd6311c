// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/lagrange_shape.h>
#include <thalweg/fields/operator_solver.h>
#include <thalweg/transfer/velocity_projection.h>

namespace Thalweg
{
  namespace
  {
    /**
     * @brief The field of the space that is nearest to the particles'
     * velocities, sum_p w_p |V*(x_p) - V_p|^2 = min, where each particle
     * stands for its share w_p of its cell: the L2 projection with the
     * particles as quadrature points.
     *
     * Fields of the space are reproduced exactly, and the projection never
     * adds energy (in the same sum).
     */
    template <int dim>
    class L2Projection : public VelocityProjection<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        section.add("Tolerance",
                    tolerance,
                    "",
                    "Residual relative to the right hand side.",
                    dealii::Patterns::Double(0, 1));
        section.add("Regularization",
                    regularization,
                    "",
                    "The part of the mass matrix that holds the velocity at "
                    "its extrapolated value where too few particles speak; "
                    "negative: 0.001 for velocities of degree 1 and 0.1 for "
                    "those of degree 2, whose finest modes particles on the "
                    "same streamlines may not see.",
                    dealii::Patterns::Double(-1, 1));
      }


      unsigned int
      project(const Population<dim>    &population,
              const LagrangeSpace<dim> &space,
              Vector                   &velocity) const override
      {
        CellOperator<dim> matrix(space);
        matrix.reinit(space.mesh().graph().n_owned_cells());
        Vector load;
        space.initialize(load, dim);
        if (space.degree() == 1)
          accumulate<1>(population, velocity, matrix, load);
        else
          accumulate<2>(population, velocity, matrix, load);
        space.fold(load, dim);
        const OperatorSolver<dim> solver(matrix, dim);
        return solver
          .solve(velocity, load, tolerance, maximum, "projection of velocities")
          .iterations;
      }

    private:
      /// Sums over the particles cell by cell.
      template <unsigned int degree>
      void
      accumulate(const Population<dim> &population,
                 const Vector          &velocity,
                 CellOperator<dim>     &matrix,
                 Vector                &load) const
      {
        constexpr unsigned int n     = LagrangeShape::n_nodes(dim, degree);
        const auto            &space = matrix.space();
        const auto            &graph = space.mesh().graph();
        for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
          {
            matrix.set_shape(c, c);
            double *const      entries = matrix.matrix(c);
            const unsigned int n_here  = population.n_in_cell(c);
            const double weight = graph.cell(c).measure / std::max(1u, n_here);
            std::array<double, dim * n> sums{};
            for (const auto &particle : population.in_cell(c))
              {
                const auto shape =
                  LagrangeShape::values<dim, degree>(particle.reference());
                const auto properties = particle.properties();
                for (unsigned int i = 0; i < n; ++i)
                  {
                    const double w = weight * shape[i];
                    for (unsigned int j = 0; j <= i; ++j)
                      entries[i * n + j] += w * shape[j];
                    for (unsigned int d = 0; d < dim; ++d)
                      sums[dim * i + d] +=
                        w * properties[Population<dim>::velocity_offset + d];
                  }
              }
            regularize<degree>(space, c, velocity, entries, sums);
            for (unsigned int i = 0; i < n; ++i)
              {
                for (unsigned int j = 0; j < i; ++j)
                  entries[j * n + i] = entries[i * n + j];
                for (unsigned int d = 0; d < dim; ++d)
                  load.local_element(dim * space.nodes(c)[i] + d) +=
                    sums[dim * i + d];
              }
          }
      }


      /// Adds some of a lumped mass matrix, and the same times the guess.
      template <unsigned int degree, std::size_t n_values>
      void
      regularize(const LagrangeSpace<dim>     &space,
                 const unsigned int            cell,
                 const Vector                 &velocity,
                 double *const                 entries,
                 std::array<double, n_values> &sums) const
      {
        constexpr unsigned int n    = LagrangeShape::n_nodes(dim, degree);
        const double           part = regularization >= 0. ? regularization
                                      : degree == 1        ? 1e-3
                                                           : .1;
        const double mass = part * space.mesh().graph().cell(cell).measure / n;
        for (unsigned int i = 0; i < n; ++i)
          {
            entries[i * n + i] += mass;
            for (unsigned int d = 0; d < dim; ++d)
              sums[dim * i + d] +=
                mass * velocity.local_element(dim * space.nodes(cell)[i] + d);
          }
      }


      static constexpr unsigned int maximum = 1000;

      double tolerance      = 1e-8;
      double regularization = -1.;
    };
  } // namespace

  THALWEG_REGISTER(VelocityProjection,
                   L2Projection,
                   "l2",
                   "the field nearest to the particles in the mean square: "
                   "the order of the space")
} // namespace Thalweg
