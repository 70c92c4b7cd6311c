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
        Thalweg::initialize(parts->space, inverse_mass);
      }

      void
      update(const double inverse_dt_, const double theta) override
      {
        inverse_dt   = inverse_dt_;
        inverse_mass = 0.;
        for (unsigned int c = 0; c < parts->space.mesh().graph().n_owned_cells();
             ++c)
          add_masses(c);
        for (unsigned int b = 0; b < inverse_mass.n_blocks(); ++b)
          {
            Vector &masses = inverse_mass.block(b);
            parts->space.fold(masses, 1);
            for (unsigned int n = 0; n < masses.locally_owned_size(); ++n)
              {
                double &value = masses.local_element(n);
                value         = value > 0. ? theta / value : 0.;
              }
          }
      }

      void
      vmult(EnrichedPressure       &destination,
            const EnrichedPressure &source) const override
      {
        parts->pressure.precondition(destination, source);
        for (unsigned int b = 0; b < source.n_blocks(); ++b)
          for (unsigned int n = 0;
               n < source.block(b).locally_owned_size();
               ++n)
            {
              double &value = destination.block(b).local_element(n);
              value *= inverse_dt;
              value += inverse_mass.block(b).local_element(n) *
                       source.block(b).local_element(n);
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
        for (unsigned int i = 0; i < nodes.size(); ++i)
          nodal(inverse_mass).local_element(nodes[i]) += measures[i] / mu;
        const int cut = parts->phase.cut_index(cell);
        if (cut < 0 || !parts->phase.cut_cells()[cut].enriched)
          return;
        const CutCell<dim> &enriched = parts->phase.cut_cells()[cut];
        const double        tau      = parts->stabilization_times[cell];
        for (unsigned int i = 0; i < nodes.size(); ++i)
          if (enriched.star_mass[i] > 0.)
            star(inverse_mass).local_element(nodes[i]) +=
              enriched.star_mass[i] / mu +
              tau * enriched.laplace_star_star[i][i];
      }

      std::unique_ptr<Parts> parts;
      Q1Integrals<dim>       integrals;
      double                 inverse_dt = 0.;
      EnrichedPressure       inverse_mass;
    };



    /// Only the Laplacian.
    template <int dim>
    class LaplaceSchurBlock : public CahouetChabard<dim>
    {
    public:
      void
      update(const double inverse_dt, const double) override
      {
        this->inverse_dt   = inverse_dt;
        this->inverse_mass = 0.;
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
