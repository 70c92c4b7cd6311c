#include <thalweg/particles/seeding.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>
#include <deal.II/grid/cell_id.h>
#include <deal.II/lac/vector.h>

#include <cstdint>
#include <limits>

namespace Thalweg
{
  namespace
  {
    /// Mixes the bits of a number (SplitMix64's finalizer by S. Vigna).
    std::uint64_t
    mix(std::uint64_t x)
    {
      x += 0x9e3779b97f4a7c15ull;
      x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
      x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
      return x ^ (x >> 31);
    }

    /// A number that the cell's place in the forest of trees determines.
    template <int dim>
    std::uint64_t
    hash(const dealii::CellId &cell)
    {
      std::uint64_t value = 0;
      for (const unsigned int word : cell.template to_binary<dim>())
        value = mix(value ^ word);
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
            jitter > 0 ? jitter * symmetric_unit(mix(cell_hash + dim * k + d))
                       : 0.;
          reference[d] = (rest % n + 0.5 + 0.5 * displacement) / n;
          rest /= n;
        }
      return reference;
    }
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
       const dealii::Function<dim> &level_set)
  {
    AssertThrow(velocity.n_components == dim && level_set.n_components == 1,
                dealii::ExcMessage(
                  "The initial velocity needs one component a dimension, the "
                  "initial level set exactly one."));
    const auto         &mesh       = population.mesh();
    const unsigned int  n          = parameters.particles_per_direction;
    const unsigned int  n_per_cell = dealii::Utilities::pow(n, dim);
    const std::uint64_t n_ids =
      std::uint64_t(mesh.triangulation().n_global_active_cells()) * n_per_cell;
    AssertThrow(
      n_ids < std::numeric_limits<dealii::types::particle_index>::max(),
      dealii::ExcMessage("These are " + std::to_string(n_ids) +
                         " particles, more than this deal.II has numbers "
                         "for. Ask for fewer 'Particles per direction' or a "
                         "coarser mesh, or use a deal.II with 64-bit "
                         "indices."));

    auto &handler = population.handler();
    handler.reserve(std::size_t(mesh.graph().n_owned_cells()) * n_per_cell);
    dealii::Vector<double>                            value(dim);
    std::array<double, Population<dim>::n_properties> properties;
    for (unsigned int i = 0; i < mesh.graph().n_owned_cells(); ++i)
      {
        const auto         &cell = mesh.graph().iterator(i);
        const std::uint64_t cell_hash =
          parameters.jitter > 0 ? hash<dim>(cell->id()) : 0;
        for (unsigned int k = 0; k < n_per_cell; ++k)
          {
            const auto reference =
              place<dim>(k, n, parameters.jitter, cell_hash);
            const auto position =
              mesh.mapping().transform_unit_to_real_cell(cell, reference);
            velocity.vector_value(position, value);
            for (unsigned int d = 0; d < dim; ++d)
              properties[Population<dim>::velocity_offset + d] = value[d];
            properties[Population<dim>::level_set_offset] =
              level_set.value(position);
            handler.insert_particle(
              position,
              reference,
              mesh.graph().cell(i).global_index * n_per_cell + k,
              cell,
              dealii::ArrayView<const double>(properties.data(),
                                              properties.size()));
          }
      }
    handler.update_cached_numbers();
    population.reserve_ids_below(n_ids);
  }


  template void
  seed(Population<2> &,
       const SeedingParameters &,
       const dealii::Function<2> &,
       const dealii::Function<2> &);
  template void
  seed(Population<3> &,
       const SeedingParameters &,
       const dealii::Function<3> &,
       const dealii::Function<3> &);
} // namespace Thalweg
