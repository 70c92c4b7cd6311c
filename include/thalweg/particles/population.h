// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_population_h
#define thalweg_particles_population_h

#include <thalweg/core/archive.h>
#include <thalweg/mesh/mesh.h>
#include <thalweg/particles/particle_rows.h>

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief What a particle that comes in through a boundary has of an added
   * property: of the boundary, the place where it does, and how long before
   * the end of the step, s. Empty, or Population::unknown: it is not known.
   */
  template <int dim>
  using InflowValue = std::function<double(const dealii::types::boundary_id,
                                           const dealii::Point<dim> &,
                                           const double)>;

  /**
   * @brief The particles of this rank's cells, and what each of them carries:
   * flat memory in the order of the owned cells of the CellGraph.
   *
   * Properties of a particle, in this order: its velocity (dim components,
   * m/s), its level set value, negative in the denser fluid (dimension of
   * length, or just a sign, as the chosen interface representation says), the
   * volume of fluid that it carries (m^dim; zero is allowed: such a particle
   * only marks the fluid), the number of that fluid, and what was added with
   * add_property(). It keeps its fluid, whatever becomes of the level set.
   * Reference coordinates are always those in the particle's cell.
   */
  template <int dim>
  class Population
  {
  public:
    static constexpr unsigned int velocity_offset  = 0;
    static constexpr unsigned int level_set_offset = dim;
    static constexpr unsigned int volume_offset    = dim + 1;
    static constexpr unsigned int fluid_offset     = dim + 2;
    /// Those that every particle has.
    static constexpr unsigned int n_properties = dim + 3;
    /// What new particles have of added properties, until they are given some.
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    using Particle      = ParticleReference<dim, false>;
    using ConstParticle = ParticleReference<dim, true>;
    using Range         = ParticleRange<dim, false>;
    using ConstRange    = ParticleRange<dim, true>;

    explicit Population(const Mesh<dim> &mesh);

    /**
     * @brief Lets particles carry one value more, before there are any.
     * @param inflow what comes in has of it
     * @return its place in the row of a particle's properties
     * @throws dealii::ExcMessage if there is one of that name
     */
    unsigned int
    add_property(const std::string &name, const InflowValue<dim> &inflow = {});

    /// Gives the row of a particle that comes in through a boundary, see
    /// InflowValue, what it has of added properties.
    template <typename Properties>
    void
    set_inflow(Properties                     &&properties,
               const dealii::types::boundary_id boundary,
               const dealii::Point<dim>        &place,
               const double                     before_end) const
    {
      for (unsigned int k = 0; k < inflow_values.size(); ++k)
        if (inflow_values[k])
          properties[n_properties + k] =
            inflow_values[k](boundary, place, before_end);
    }

    /// The names of those that were added.
    const std::vector<std::string> &
    added_properties() const
    {
      return names;
    }

    /// All that a particle of this population has.
    unsigned int
    row_length() const
    {
      return rows.n_properties();
    }

    /// The number of the fluid that a particle belongs to.
    template <typename Properties>
    static unsigned int
    fluid_of(const Properties &properties)
    {
      return properties[fluid_offset] == 0. ? 0 : 1;
    }

    template <typename Properties>
    static std::array<double, dim>
    velocity_of(const Properties &properties)
    {
      std::array<double, dim> velocity;
      for (unsigned int d = 0; d < dim; ++d)
        velocity[d] = properties[velocity_offset + d];
      return velocity;
    }

    /// Gives a particle a level set value and the fluid that this says.
    template <typename Properties>
    static void
    set_level_set(Properties &&properties, const double value)
    {
      properties[level_set_offset] = value;
      properties[fluid_offset]     = value < 0 ? 0. : 1.;
    }

    const Mesh<dim> &
    mesh() const
    {
      return mesh_;
    }

    /// All of this rank, in the order of its cells.
    Range
    particles()
    {
      return rows.range(0, rows.size());
    }

    ConstRange
    particles() const
    {
      return rows.range(0, rows.size());
    }

    /// Those in an owned cell of the graph.
    Range
    in_cell(const unsigned int cell)
    {
      return rows.range(first_in(cell), first_in(cell + 1));
    }

    ConstRange
    in_cell(const unsigned int cell) const
    {
      return rows.range(first_in(cell), first_in(cell + 1));
    }

    unsigned int
    n_in_cell(const unsigned int cell) const
    {
      return first_in(cell + 1) - first_in(cell);
    }

    /// Those of this rank in their order.
    const ParticleRows<dim> &
    all() const
    {
      return rows;
    }

    /// Where those of each owned cell begin in all(), and the end; empty if
    /// there have never been any.
    const std::vector<unsigned int> &
    beginnings() const
    {
      return begin;
    }

    /// Removes all.
    void
    clear();

    /**
     * @brief Makes @p new_rows all that there are.
     * @param beginnings where those of each owned cell begin, and the end
     */
    void
    exchange(ParticleRows<dim>         &&new_rows,
             std::vector<unsigned int> &&beginnings);

    /// Empty rows to be filled for exchange(), in the memory of those that
    /// were exchanged last.
    ParticleRows<dim>
    take_spare();

    /// The same in any order, with the cell of each.
    void
    replace(const ParticleRows<dim>         &new_rows,
            const std::vector<unsigned int> &cells);

    /**
     * @brief Adds particles behind those that are in their cells.
     * @param new_rows in any order
     * @param cells of each of them, owned ones of the graph
     */
    void
    insert(const ParticleRows<dim>         &new_rows,
           const std::vector<unsigned int> &cells);

    /// Removes some, given by their places in all(); each place is taken by
    /// the last in the cell.
    void
    remove(std::vector<unsigned int> places);

    /**
     * @brief The next free particle id of this rank.
     *
     * Ids are unique over all ranks and do not depend on what other ranks
     * do: each rank has every n-th number for itself.
     */
    ParticleId
    next_id();

    /// From now on next_id() uses numbers from @p first_free on; to be called
    /// with the same number on all ranks, when particles with other ids were
    /// inserted.
    void
    reserve_ids_below(const ParticleId first_free);

    /// Names which ids were given so far. Collective.
    void
    keep(const Archive &archive);

    /// On this rank.
    std::size_t
    n_particles() const
    {
      return rows.size();
    }

    /// The number of particles on all ranks. Collective.
    std::uint64_t
    n_global_particles() const;

    /// What the particles of each owned cell of the graph carry of both
    /// fluids, m^dim.
    std::vector<std::array<double, 2>>
    volumes_of_cells() const;

  private:
    unsigned int
    first_in(const unsigned int cell) const
    {
      return cell < begin.size() ? begin[cell] : rows.size();
    }

    const Mesh<dim>              &mesh_;
    std::vector<std::string>      names;
    std::vector<InflowValue<dim>> inflow_values;
    ParticleRows<dim>             rows, spare;
    std::vector<unsigned int>     begin;
    ParticleId                    first_id  = 0;
    ParticleId                    n_created = 0;
  };
} // namespace Thalweg

#endif
