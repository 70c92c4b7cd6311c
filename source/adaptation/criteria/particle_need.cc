// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/adaptation/refinement_criterion.h>

#include <deal.II/base/mpi.h>

#include <bitset>

namespace Thalweg
{
  namespace
  {
    /// Cells that hold many particles, and cells that hold too few.
    template <int dim>
    class ParticleNeed : public FlowCriterion<dim>
    {
    public:
      void
      declare_for_flow(const Section &section) override
      {
        section.add("Particles per cell",
                    particles_per_cell,
                    "",
                    "The indicator is the number of particles in a cell "
                    "divided by this one. Above 1 the particles know more "
                    "about the flow than the cell can hold.",
                    dealii::Patterns::Double(1e-3));
        section.add("Empty part",
                    empty_part,
                    "",
                    "Cells become coarser, unless a criterion prescribes "
                    "their level, if more than this part of their 2^d "
                    "sub-cells has no particle: there the mesh is finer than "
                    "what its particles carry. 1: never.",
                    dealii::Patterns::Double(0, 1));
      }



      void
      evaluate_for_flow(const FlowView<dim> &solution,
                        const LevelRange &,
                        const double,
                        CellWishes &wishes) override
      {
        // Before the particles are there, nothing follows from their absence.
        if (solution.population.n_global_particles() == 0)
          return;
        const CellGraph<dim> &graph = solution.mesh.graph();
        for (unsigned int c = 0; c < wishes.indicator.size(); ++c)
          {
            const auto             &cell = graph.iterator(c);
            std::bitset<(1 << dim)> filled;
            unsigned int            n = 0;
            for (const auto &particle : solution.population.in_cell(c))
              {
                const auto   xi       = particle.reference();
                unsigned int sub_cell = 0;
                for (unsigned int d = 0; d < dim; ++d)
                  sub_cell += (xi[d] < .5 ? 0u : 1u) << d;
                filled.set(sub_cell);
                ++n;
              }
            wishes.indicator[c] = n / particles_per_cell;
            if (cell->level() > 0 &&
                filled.size() - filled.count() > empty_part * filled.size())
              wishes.at_most[c] = cell->level() - 1;
          }
      }

    private:
      double particles_per_cell = dim == 2 ? 18. : 54.;
      double empty_part         = .5;
    };
  } // namespace

  THALWEG_REGISTER(RefinementCriterion,
                   ParticleNeed,
                   "particle need",
                   "the number of particles in a cell; cells that are mostly "
                   "empty become coarser.")
} // namespace Thalweg
