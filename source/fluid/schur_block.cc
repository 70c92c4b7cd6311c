// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fluid/schur_block.h>

#include <memory>

namespace Thalweg
{
  namespace
  {
    /**
     * With the Laplacian L of PressureSystem and the diagonal Q of the mass
     * matrix of functions divided by the viscosity,
     *
     *   S^{-1} = 1/dt L^{-1} + theta Q^{-1}
     *
     * (J. Cahouet, J.-P. Chabard, Int. J. Numer. Methods Fluids 8, 1988), which
     * is what S tends to where inertia rules, and where viscosity does.
     */
    template <int dim>
    class CahouetChabard : public SchurBlock<dim>
    {
    public:
      using Parts = typename SchurBlock<dim>::Parts;

      void
      declare_parameters(const Section &) override
      {}

      void
      initialize(const Parts &parts_) override
      {
        parts = std::make_unique<Parts>(parts_);
        Thalweg::initialize(parts->space, masses);
        parts->space.initialize_scalar(mixed);
        parts->space.initialize_scalar(own);
      }

      void
      update(const double inverse_dt_, const double theta_) override
      {
        inverse_dt = inverse_dt_;
        theta      = theta_;
        for (Vector *vector : {&nodal(masses), &star(masses), &mixed, &own})
          *vector = 0.;
        for (unsigned int c = 0;
             c < parts->space.mesh().graph().n_owned_cells();
             ++c)
          add_masses(c);
        for (Vector *vector : {&nodal(masses), &star(masses), &mixed, &own})
          parts->space.fold(*vector, 1);
      }

      void
      vmult(EnrichedPressure       &destination,
            const EnrichedPressure &source) const override
      {
        parts->pressure.precondition(destination, source);
        for (unsigned int n = 0; n < own.locally_owned_size(); ++n)
          {
            double      &p = nodal(destination).local_element(n);
            double      &q = star(destination).local_element(n);
            const double r = nodal(source).local_element(n);
            const double s = star(source).local_element(n);
            p *= inverse_dt;
            q *= inverse_dt;
            if (theta == 0.)
              continue;
            if (const double S = star(masses).local_element(n); S > 0.)
              {
                const double N           = own.local_element(n),
                             M           = mixed.local_element(n);
                const double determinant = N * S - M * M;
                p += theta * (S * r - M * s) / determinant;
                q += theta * (N * s - M * r) / determinant;
              }
            else if (const double N = nodal(masses).local_element(n); N > 0.)
              p += theta * r / N;
          }
      }

    protected:
      /// Adds int N_i^2 / mu, lumped, and int (N_j psi)^2 / mu with what the
      /// stabilization has of functions with a kink, which nodal values hardly
      /// balance. What a pressure in a cut cell moves has to deform both
      /// fluids.
      void
      add_masses(const unsigned int cell)
      {
        const double mu       = parts->viscous.cell_viscosity(cell).viscosity;
        const auto  &graph    = parts->space.mesh().graph();
        const auto   measures = integrals.node_measures(graph.cell(cell));
        const auto  &nodes    = parts->space.nodes(cell);
        // of int N_i in a parallelepiped
        static const double share = std::pow(1.5, -dim);
        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            nodal(masses).local_element(nodes[i]) += measures[i] / mu;
            own.local_element(nodes[i]) += share * measures[i] / mu;
          }
        const int cut = parts->phase.cut_index(cell);
        if (cut < 0 || !parts->phase.cut_cells()[cut].enriched)
          return;
        const CutCell<dim> &enriched = parts->phase.cut_cells()[cut];
        const double        tau      = parts->stabilization_times[cell];
        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            star(masses).local_element(nodes[i]) +=
              enriched.star_mass[i] / mu +
              tau * enriched.laplace_star_star[i][i];
            mixed.local_element(nodes[i]) +=
              enriched.mixed_mass[i] / mu + tau * enriched.laplace_star[i][i];
            own.local_element(nodes[i]) += tau * enriched.laplace[i][i];
          }
      }

      std::unique_ptr<Parts> parts;
      Q1Integrals<dim>       integrals;
      double                 inverse_dt = 0., theta = 0.;
      /// Of N_i, lumped, and of N_i psi.
      EnrichedPressure masses;
      /// Of both together, and of N_i by itself.
      Vector mixed, own;
    };



    /// Only the Laplacian.
    template <int dim>
    class LaplaceSchurBlock : public CahouetChabard<dim>
    {
    public:
      void
      update(const double inverse_dt, const double) override
      {
        this->inverse_dt = inverse_dt;
        this->theta      = 0.;
      }
    };
  } // namespace

  THALWEG_REGISTER(SchurBlock,
                   CahouetChabard,
                   "cahouet chabard",
                   "the Laplacian with the densities (a cycle of algebraic "
                   "multigrid, exact beside the interface) and the mass matrix "
                   "with the viscosities together, for any time step")
  THALWEG_REGISTER(SchurBlock,
                   LaplaceSchurBlock,
                   "laplace",
                   "the Laplacian alone, where inertia rules")
} // namespace Thalweg
