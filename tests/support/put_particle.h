// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_support_put_particle_h
#define tests_support_put_particle_h

#include <thalweg/fields/q1_cell.h>
#include <thalweg/particles/population.h>

/// Adds a particle with all properties @p value at a point of an owned cell.
template <int dim>
void
put_particle(Thalweg::Population<dim> &population,
             const unsigned int        cell,
             const dealii::Point<dim> &reference,
             const double              value = 0.)
{
  Thalweg::ParticleRows<dim> rows(population.row_length());
  const auto &vertices = population.mesh().graph().cell(cell).vertices;
  const std::vector<double> row(population.row_length(), value);
  rows.append(population.next_id(),
              {Thalweg::Q1::position<dim>(vertices, reference), reference},
              row.data());
  population.insert(rows, {cell});
}

#endif
