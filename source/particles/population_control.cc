// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/particles/population_control.h>
#include <thalweg/particles/sub_cell.h>
#include <thalweg/particles/volume_sharing.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace Thalweg
{
  namespace
  {
    template <int dim>
    dealii::Point<dim>
    sub_cell_center(const unsigned int index)
    {
      dealii::Point<dim> center;
      for (unsigned int d = 0; d < dim; ++d)
        center[d] = (index >> d) & 1 ? 0.75 : 0.25;
      return center;
    }

    /// The centres of empty sub-cells, and their cells in the graph.
    template <int dim>
    struct Holes
    {
      std::vector<unsigned int>       cells;
      std::vector<dealii::Point<dim>> reference_points;
    };

    template <int dim>
    Holes<dim>
    find_holes(const Population<dim> &population, const unsigned int minimum)
    {
      const auto &graph = population.mesh().graph();
      Holes<dim>  holes;
      for (unsigned int i = 0; i < graph.n_owned_cells(); ++i)
        {
          if (population.n_in_cell(i) >= minimum)
            continue;
          std::array<bool, 1u << dim> occupied{};
          for (const auto &particle : population.in_cell(i))
            occupied[sub_cell(particle.reference())] = true;
          for (unsigned int s = 0; s < occupied.size(); ++s)
            if (!occupied[s])
              {
                holes.cells.push_back(i);
                holes.reference_points.push_back(sub_cell_center<dim>(s));
              }
        }
      return holes;
    }

    /// Those of @p fluid in a cell, but for the last @p n_left_out of all.
    template <int dim>
    void
    find_sharing(Population<dim>                                 &population,
                 const unsigned int                               cell,
                 const unsigned int                               fluid,
                 const unsigned int                               n_left_out,
                 std::vector<typename Population<dim>::Particle> &sharing)
    {
      const unsigned int n = population.n_in_cell(cell) - n_left_out;
      unsigned int       k = 0;
      sharing.clear();
      for (const auto &particle : population.in_cell(cell))
        if (k++ < n &&
            Population<dim>::fluid_of(particle.properties()) == fluid)
          sharing.push_back(particle);
    }

    /// The particles of one fluid in one cell.
    template <int dim>
    struct Group
    {
      std::vector<typename Population<dim>::Particle> particles;
      std::vector<dealii::Point<dim>>                 points;
      std::vector<bool>                               is_removed;

      void
      clear()
      {
        particles.clear();
        points.clear();
        is_removed.clear();
      }

      void
      add(const typename Population<dim>::Particle &particle)
      {
        particles.push_back(particle);
        points.push_back(particle.reference());
        is_removed.push_back(false);
      }

      /// Of the two that are nearest to each other marks one, and gives the
      /// other what it carries if @p carry says so.
      void
      remove_one(const bool carry)
      {
        double       nearest = std::numeric_limits<double>::max();
        unsigned int removed = 0, kept = 0;
        const auto   choose = [&](const unsigned int i, const unsigned int j) {
          const double distance = points[i].distance(points[j]);
          if (distance > nearest + reference_round_off)
            return;
          const bool         is_first = stands_before(points[i], points[j]);
          const unsigned int later    = is_first ? j : i;
          if (distance < nearest - reference_round_off ||
              stands_before(points[removed], points[later]))
            {
              removed = later;
              kept    = is_first ? i : j;
            }
          nearest = std::min(nearest, distance);
        };
        for (unsigned int i = 0; i < points.size(); ++i)
          for (unsigned int j = 0; j < i; ++j)
            if (!is_removed[i] && !is_removed[j])
              choose(i, j);
        is_removed[removed] = true;
        if (carry && kept != removed)
          merge(particles[removed], particles[kept]);
      }
    };

    /// How many of @p n_negative particles to keep if @p maximum of
    /// @p n particles may stay: their share, but neither none of them nor
    /// none of the others.
    unsigned int
    share(const unsigned int n_negative,
          const unsigned int n,
          const unsigned int maximum)
    {
      if (n_negative == 0 || n_negative == n)
        return n_negative == 0 ? 0 : maximum;
      const double exact = static_cast<double>(maximum) * n_negative / n;
      return std::clamp<unsigned int>(std::lround(exact), 1, maximum - 1);
    }
  } // namespace


  template <int dim>
  void
  PopulationParameters<dim>::declare_parameters(const Section &section)
  {
    section.add("Minimum per cell",
                minimum_per_cell,
                "",
                "In a cell with fewer particles, each quarter (in 3D: eighth) "
                "of the cell without a particle gets one. 0 switches this "
                "off.",
                dealii::Patterns::Integer(0));
    section.add("Maximum per cell",
                maximum_per_cell,
                "",
                "In a cell with more particles, those that are nearest to "
                "another one are removed.",
                dealii::Patterns::Integer(1));
  }


  template <int dim>
  void
  PopulationParameters<dim>::check() const
  {
    AssertThrow(maximum_per_cell > minimum_per_cell &&
                  maximum_per_cell >= (1u << dim),
                dealii::ExcMessage(
                  "'Particles/Maximum per cell' is " +
                  std::to_string(maximum_per_cell) +
                  ", but it must be above 'Particles/Minimum per cell', which "
                  "is " +
                  std::to_string(minimum_per_cell) + ", and at least " +
                  std::to_string(1u << dim) + "."));
  }



  template <int dim>
  PopulationControl<dim>::PopulationControl(
    const PopulationParameters<dim> &parameters,
    const StreamlineConvection<dim> &convection,
    const InflowLevelSet<dim>       &inflow_level_set)
    : parameters(parameters)
    , convection(&convection)
    , inflow_level_set(inflow_level_set)
  {
    parameters.check();
  }


  template <int dim>
  PopulationControl<dim>::PopulationControl(
    const PopulationParameters<dim> &parameters,
    const InflowLevelSet<dim>       &inflow_level_set)
    : parameters(parameters)
    , convection(nullptr)
    , inflow_level_set(inflow_level_set)
  {
    parameters.check();
  }


  template <int dim>
  double
  PopulationControl<dim>::level_set_value(const Foot<dim> &foot) const
  {
    const auto inflow = inflow_level_set.find(foot.boundary);
    // Where the same fluid is inside already the distance goes on.
    double value = foot.level_set;
    if (inflow != inflow_level_set.end())
      {
        const double outside = inflow->second(foot.position);
        if ((outside < 0) != (value < 0))
          value = outside;
      }
    if (!parameters.level_set_is_sign)
      return value;
    return value < 0 ? -1. : 1.;
  }


  template <int dim>
  unsigned int
  PopulationControl<dim>::fill_empty_cells(Population<dim>         &population,
                                           const CellVelocity<dim> &velocity,
                                           const CellField<dim, 1> &level_set,
                                           const double             dt) const
  {
    Assert(convection != nullptr,
           dealii::ExcMessage("This object was made without a convection: "
                              "call fill_empty_cells() with a tracer."));
    return fill_empty_cells(
      population,
      [&](const std::vector<unsigned int>       &cells,
          const std::vector<dealii::Point<dim>> &reference_points) {
        return convection->trace_back(
          cells, reference_points, velocity, level_set, dt);
      });
  }


  template <int dim>
  unsigned int
  PopulationControl<dim>::fill_empty_cells(Population<dim> &population,
                                           const Tracer    &tracer) const
  {
    const Holes<dim> holes =
      find_holes(population, parameters.minimum_per_cell);
    const auto feet = tracer(holes.cells, holes.reference_points);
    AssertDimension(feet.size(), holes.cells.size());

    const auto         &graph = population.mesh().graph();
    ParticleRows<dim>   filling(population.row_length());
    std::vector<double> row(population.row_length(), Population<dim>::unknown);
    for (unsigned int i = 0; i < feet.size(); ++i)
      {
        const auto &reference = holes.reference_points[i];
        std::copy(feet[i].velocity.begin(),
                  feet[i].velocity.end(),
                  row.begin() + Population<dim>::velocity_offset);
        Population<dim>::set_level_set(row, level_set_value(feet[i]));
        row[Population<dim>::volume_offset] = 0.;
        std::fill(row.begin() + Population<dim>::n_properties,
                  row.end(),
                  Population<dim>::unknown);
        if (feet[i].boundary != dealii::numbers::invalid_boundary_id)
          population.set_inflow(row,
                                feet[i].boundary,
                                feet[i].position,
                                feet[i].way);
        filling.append(population.next_id(),
                       {Q1::position<dim>(graph.cell(holes.cells[i]).vertices,
                                          reference),
                        reference},
                       row.data());
      }
    population.insert(filling, holes.cells);
    if (parameters.carry_volume)
      {
        std::vector<typename Population<dim>::Particle> sharing;
        for (unsigned int i = 0; i < feet.size(); ++i)
          {
            // One after the other.
            unsigned int n_later = 0;
            while (i + n_later + 1 < feet.size() &&
                   holes.cells[i + n_later + 1] == holes.cells[i])
              ++n_later;
            find_sharing(population,
                         holes.cells[i],
                         Population<dim>::fluid_of(filling[i].properties()),
                         n_later,
                         sharing);
            share_volume(sharing);
          }
      }
    return feet.size();
  }


  template <int dim>
  unsigned int
  PopulationControl<dim>::limit(Population<dim> &population) const
  {
    const auto        &graph   = population.mesh().graph();
    const unsigned int maximum = parameters.maximum_per_cell;

    std::vector<unsigned int> to_remove;
    std::array<Group<dim>, 2> groups;
    for (unsigned int i = 0; i < graph.n_owned_cells(); ++i)
      {
        if (population.n_in_cell(i) <= maximum)
          continue;
        for (auto &group : groups)
          group.clear();
        for (const auto &particle : population.in_cell(i))
          groups[Population<dim>::fluid_of(particle.properties())].add(
            particle);

        const unsigned int n =
          groups[0].particles.size() + groups[1].particles.size();
        const unsigned int n_negative =
          share(groups[0].particles.size(), n, maximum);
        const unsigned int n_kept[] = {n_negative, maximum - n_negative};
        for (unsigned int g = 0; g < 2; ++g)
          {
            for (unsigned int k = groups[g].particles.size(); k > n_kept[g];
                 --k)
              groups[g].remove_one(parameters.carry_volume);
            for (unsigned int p = 0; p < groups[g].particles.size(); ++p)
              if (groups[g].is_removed[p])
                to_remove.push_back(
                  groups[g].particles[p].index_in(population.all()));
          }
      }
    population.remove(to_remove);
    return to_remove.size();
  }


  template struct PopulationParameters<2>;
  template struct PopulationParameters<3>;
  THALWEG_INSTANTIATE(PopulationControl)
} // namespace Thalweg
