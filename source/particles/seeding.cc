// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/mixed_bits.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/mesh/round_off.h>
#include <thalweg/particles/seeding.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>
#include <deal.II/grid/cell_id.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace Thalweg
{
  namespace
  {
    /// A number that the cell's place in the forest of trees determines.
    template <int dim>
    std::uint64_t
    hash(const dealii::CellId &cell)
    {
      std::uint64_t value = 0;
      for (const unsigned int word : cell.template to_binary<dim>())
        value = mixed_bits(value ^ word);
      return value;
    }

    /// A number in [-1,1).
    double
    symmetric_unit(const std::uint64_t bits)
    {
      return static_cast<double>(bits >> 11) / static_cast<double>(1ull << 52) -
             1.;
    }

    /// The place of the k-th particle of a cell in the cell's coordinates.
    template <int dim>
    dealii::Point<dim>
    place(const unsigned int  k,
          const unsigned int  n,
          const double        jitter,
          const std::uint64_t cell_hash)
    {
      dealii::Point<dim> reference;
      unsigned int       rest = k;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double displacement =
            jitter > 0
              ? jitter * symmetric_unit(mixed_bits(cell_hash + dim * k + d))
              : 0.;
          reference[d] = (rest % n + 0.5 + 0.5 * displacement) / n;
          rest /= n;
        }
      return reference;
    }

    /// A place in the part of a cell where the level set has the sign of
    /// @p fluid: the centre of that part if it is one, else the point that is
    /// deepest in it.
    template <int dim>
    dealii::Point<dim>
    place_of_fluid(const typename CellGraph<dim>::Cell &cell,
                   const dealii::Function<dim>         &level_set,
                   const unsigned int                   fluid)
    {
      constexpr unsigned int n = 11;
      const double           least =
        negligible_distance(cell.edges().first, cell.vertices[0]);
      const double       sign = fluid == 0 ? -1. : 1.;
      dealii::Point<dim> center, deepest;
      unsigned int       n_inside = 0;
      double             depth    = std::numeric_limits<double>::lowest();
      for (unsigned int i = 0; i < dealii::Utilities::pow(n, dim); ++i)
        {
          dealii::Point<dim> xi;
          for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= n)
            xi[d] = static_cast<double>(rest % n) / (n - 1);
          const double value =
            sign * level_set.value(Q1::position<dim>(cell.vertices, xi));
          if (value > depth + least)
            {
              depth   = value;
              deepest = xi;
            }
          if (value > least)
            {
              center += dealii::Tensor<1, dim>(xi);
              ++n_inside;
            }
        }
      if (n_inside == 0)
        return deepest;
      center /= n_inside;
      return sign * level_set.value(Q1::position<dim>(cell.vertices, center)) >
                 least
               ? center
               : deepest;
    }

    /// Makes the particles of one cell after the other.
    template <int dim>
    class CellSeeds
    {
    public:
      CellSeeds(const Population<dim>       &population,
                const dealii::Function<dim> &velocity,
                const dealii::Function<dim> &level_set)
        : rows(population.row_length())
        , graph(population.mesh().graph())
        , velocity(velocity)
        , level_set(level_set)
        , value(dim)
        , row(population.row_length(), Population<dim>::unknown)
      {}

      /// Those of the next cells belong to @p cell.
      void
      begin(const unsigned int cell)
      {
        this->cell = cell;
        first      = rows.size();
      }

      void
      add(const ParticleId id, const dealii::Point<dim> &reference)
      {
        const auto              &geometry = graph.cell(cell);
        const dealii::Point<dim> position =
          Q1::position<dim>(geometry.vertices, reference);
        velocity.vector_value(position, value);
        for (unsigned int d = 0; d < dim; ++d)
          row[Population<dim>::velocity_offset + d] = value[d];
        Population<dim>::set_level_set(row,
                                       without_round_off(level_set.value(
                                                           position),
                                                         geometry.edges().first,
                                                         position));
        row[Population<dim>::volume_offset] = 0.;
        rows.append(id, {position, reference}, row.data());
        cells.push_back(cell);
      }

      /// Particles of the cell get its volumes of both fluids, where needed
      /// one more for each fluid, with ids from @p first_id on.
      void
      carry(const double negative_volume, const ParticleId first_id)
      {
        const auto           &geometry = graph.cell(cell);
        std::array<double, 2> volumes  = {
           {negative_volume, geometry.measure - negative_volume}};
        const double negligible = 1e-12 * geometry.measure;
        for (unsigned int fluid = 0; fluid < 2; ++fluid)
          if (volumes[fluid] <= negligible)
            {
              volumes[1 - fluid] += volumes[fluid];
              volumes[fluid] = 0.;
            }
          else if (numbers()[fluid] == 0)
            {
              add(first_id + fluid,
                  place_of_fluid<dim>(geometry, level_set, fluid));
              // The cut may see a part that the function just touches.
              const auto last = rows[rows.size() - 1].properties();
              if (Population<dim>::fluid_of(last) != fluid)
                Population<dim>::set_level_set(
                  last, fluid == 0 ? -std::numeric_limits<double>::min() : 0.);
            }
        const auto n = numbers();
        for (const auto &particle : rows.range(first, rows.size()))
          {
            const auto         properties = particle.properties();
            const unsigned int fluid = Population<dim>::fluid_of(properties);
            properties[Population<dim>::volume_offset] =
              volumes[fluid] / n[fluid];
          }
      }

      ParticleRows<dim>         rows;
      std::vector<unsigned int> cells; ///< of each

    private:
      /// How many particles of each fluid the cell has.
      std::array<unsigned int, 2>
      numbers() const
      {
        std::array<unsigned int, 2> n{};
        for (const auto &particle : rows.range(first, rows.size()))
          ++n[Population<dim>::fluid_of(particle.properties())];
        return n;
      }

      const CellGraph<dim>        &graph;
      const dealii::Function<dim> &velocity;
      const dealii::Function<dim> &level_set;
      dealii::Vector<double>       value;
      std::vector<double>          row;
      unsigned int                 cell  = 0;
      std::size_t                  first = 0; ///< of the cell
    };
  } // namespace


  void
  SeedingParameters::declare_parameters(const Section &section)
  {
    section.add("Particles per direction",
                particles_per_direction,
                "",
                "Each cell is divided into this number of sub-cells in each "
                "direction and gets one particle in each sub-cell.",
                dealii::Patterns::Integer(1, 100));
    section.add("Jitter",
                jitter,
                "",
                "How far particles may stand from the centre of their "
                "sub-cell, in parts of half the sub-cell: 0 is a regular "
                "lattice, with 1 they stand anywhere in the sub-cell. The "
                "displacements are the same in each run and on any number of "
                "processes.",
                dealii::Patterns::Double(0., 1.));
  }


  template <int dim>
  void
  seed(Population<dim>             &population,
       const SeedingParameters     &parameters,
       const dealii::Function<dim> &velocity,
       const dealii::Function<dim> &level_set,
       const std::function<double(const typename CellGraph<dim>::Cell &)>
         &negative_volume)
  {
    AssertThrow(velocity.n_components == dim && level_set.n_components == 1,
                dealii::ExcMessage(
                  "The initial velocity needs one component a dimension, the "
                  "initial level set exactly one."));
    const auto         &mesh       = population.mesh();
    const unsigned int  n          = parameters.particles_per_direction;
    const unsigned int  n_per_cell = dealii::Utilities::pow(n, dim);
    const std::uint64_t n_cells = mesh.triangulation().n_global_active_cells();

    CellSeeds<dim> seeds(population, velocity, level_set);
    seeds.rows.reserve(std::size_t(mesh.graph().n_owned_cells()) * n_per_cell);
    for (unsigned int i = 0; i < mesh.graph().n_owned_cells(); ++i)
      {
        const ParticleId    number = mesh.graph().cell(i).global_index;
        const std::uint64_t cell_hash =
          parameters.jitter > 0 ? hash<dim>(mesh.graph().iterator(i)->id()) : 0;
        seeds.begin(i);
        for (unsigned int k = 0; k < n_per_cell; ++k)
          seeds.add(number * n_per_cell + k,
                    place<dim>(k, n, parameters.jitter, cell_hash));
        if (negative_volume)
          seeds.carry(negative_volume(mesh.graph().cell(i)),
                      n_cells * n_per_cell + 2 * number);
      }
    population.replace(seeds.rows, seeds.cells);
    // One more for each fluid, where it needs it.
    population.reserve_ids_below(n_cells * (n_per_cell + 2));
  }


  template void
  seed(Population<2> &,
       const SeedingParameters &,
       const dealii::Function<2> &,
       const dealii::Function<2> &,
       const std::function<double(const CellGraph<2>::Cell &)> &);
  template void
  seed(Population<3> &,
       const SeedingParameters &,
       const dealii::Function<3> &,
       const dealii::Function<3> &,
       const std::function<double(const CellGraph<3>::Cell &)> &);
} // namespace Thalweg
