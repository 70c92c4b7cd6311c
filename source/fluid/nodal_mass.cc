// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/gather.h>
#include <thalweg/fluid/nodal_mass.h>

namespace Thalweg
{
  template <int dim>
  NodalMass<dim>::NodalMass(const NodeSpace<dim>     &space,
                            const BoundaryNodes<dim> &boundary,
                            const PhaseField<dim>    &phase)
    : space(space)
    , boundary(boundary)
    , phase(phase)
  {
    for (unsigned int i = 0; i < n_vertices; ++i)
      for (unsigned int j = 0; j < n_vertices; ++j)
        {
          table[i][j] = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            table[i][j] *= ((i ^ j) >> d) & 1u ? 1. / 6. : 1. / 3.;
        }
    space.initialize_scalar(measure);
    space.initialize_scalar(mass);
    space.initialize_scalar(inverse);
    space.initialize_velocity(difference);
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto local = integrals.node_measures(graph.cell(c));
        for (unsigned int i = 0; i < local.size(); ++i)
          measure.local_element(space.nodes(c)[i]) += local[i];
      }
    space.fold(measure, 1);
  }



  template <int dim>
  void
  NodalMass<dim>::update()
  {
    const CellGraph<dim> &graph = space.mesh().graph();
    mass                        = 0.;
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const int cut_index = phase.cut_index(c);
        auto      local = cut_index < 0 ? integrals.node_measures(graph.cell(c))
                                        : phase.cut_cells()[cut_index].mass;
        if (cut_index < 0)
          for (double &value : local)
            value *= phase.fluid(c).density;
        for (unsigned int i = 0; i < local.size(); ++i)
          mass.local_element(space.nodes(c)[i]) += local[i];
      }
    space.fold(mass, 1);
    for (unsigned int n = 0; n < mass.locally_owned_size(); ++n)
      inverse.local_element(n) =
        space.is_dependent(n) ? 0. : 1. / mass.local_element(n);
  }



  template <int dim>
  void
  NodalMass<dim>::add_difference(const Vector &acceleration,
                                 Vector       &result) const
  {
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto &nodes     = space.nodes(c);
        const auto  a         = gather_velocity<dim>(acceleration, nodes);
        const int   cut_index = phase.cut_index(c);
        const auto &matrix =
          cut_index < 0 ? table : phase.cut_cells()[cut_index].mass_matrix;
        const double factor =
          cut_index < 0 ? graph.cell(c).measure * phase.fluid(c).density : 1.;
        std::array<double, dim * n_vertices> sums{};
        for (unsigned int i = 1; i < n_vertices; ++i)
          for (unsigned int j = 0; j < i; ++j)
            for (unsigned int d = 0; d < dim; ++d)
              {
                const double pair =
                  matrix[i][j] * (a[dim * i + d] - a[dim * j + d]);
                sums[dim * i + d] += pair;
                sums[dim * j + d] -= pair;
              }
        for (unsigned int i = 0; i < n_vertices; ++i)
          for (unsigned int d = 0; d < dim; ++d)
            result.local_element(dim * nodes[i] + d) +=
              factor * sums[dim * i + d];
      }
  }



  template <int dim>
  void
  NodalMass<dim>::divide(Vector &vector) const
  {
    for (unsigned int n = 0; n < mass.locally_owned_size(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
        vector.local_element(dim * n + d) *= inverse.local_element(n);
  }



  template <int dim>
  void
  NodalMass<dim>::accelerate(Vector                       &vector,
                             const dealii::Tensor<1, dim> &uniform,
                             const Vector                 *field) const
  {
    vector.zero_out_ghost_values();
    divide(vector);
    if (uniform.norm_square() > 0)
      for (unsigned int i = 0; i < dim * mass.locally_owned_size(); ++i)
        vector.local_element(i) += uniform[i % dim];
    if (field)
      for (unsigned int i = 0; i < dim * mass.locally_owned_size(); ++i)
        vector.local_element(i) += field->local_element(i);
    boundary.project_slip(vector);
    space.interpolate(vector, dim);
    add_second_term(vector, &BoundaryNodes<dim>::project_slip);
  }



  template <int dim>
  void
  NodalMass<dim>::invert(Vector &vector) const
  {
    vector.zero_out_ghost_values();
    divide(vector);
    boundary.project(vector);
    space.interpolate(vector, dim);
    add_second_term(vector, &BoundaryNodes<dim>::project);
  }



  template <int dim>
  void
  NodalMass<dim>::add_second_term(Vector &vector, const Fixing project) const
  {
    difference = 0.;
    add_difference(vector, difference);
    space.fold(difference, dim);
    difference.zero_out_ghost_values();
    divide(difference);
    (boundary.*project)(difference);
    vector.zero_out_ghost_values();
    vector.add(1., difference);
    space.interpolate(vector, dim);
  }



  THALWEG_INSTANTIATE(NodalMass)
} // namespace Thalweg
