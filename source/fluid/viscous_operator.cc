// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/gather.h>
#include <thalweg/fluid/viscous_operator.h>
#include <thalweg/materials/laminate.h>

namespace Thalweg
{
  template <int dim>
  ViscousOperator<dim>::ViscousOperator(
    const NodeSpace<dim>        &space,
    const BoundaryNodes<dim>    &boundary,
    const PhaseField<dim>       &phase,
    const FluidViscosities<dim> *viscosities)
    : space(space)
    , boundary(boundary)
    , phase(phase)
    , viscosities(viscosities)
    , at_wall(boundary.cells_with_given_nodes())
  {
    space.initialize_velocity(work);
    space.initialize_velocity(diagonal.inverse_diagonal);
  }



  template <int dim>
  dealii::Tensor<2, dim>
  ViscousOperator<dim>::CellViscosity::laminate_stress(
    const dealii::Tensor<2, dim> &twice_rate) const
  {
    const dealii::Tensor<1, dim> traction = twice_rate * cut->normal;
    const dealii::Tensor<1, dim> shear =
      traction - (traction * cut->normal) * cut->normal;
    return viscosity * twice_rate +
           (harmonic - viscosity) * (outer_product(shear, cut->normal) +
                                     outer_product(cut->normal, shear));
  }



  template <int dim>
  double
  ViscousOperator<dim>::CellViscosity::diagonal(
    const dealii::Tensor<1, dim> &gradient,
    const unsigned int            component) const
  {
    if (!cut)
      return viscosity *
             (gradient * gradient + gradient[component] * gradient[component]);
    dealii::Tensor<2, dim> velocity_gradient;
    velocity_gradient[component] = gradient;
    return stress(velocity_gradient)[component] * gradient;
  }



  template <int dim>
  double
  ViscousOperator<dim>::fluid_viscosity(const unsigned int fluid,
                                        const unsigned int cell) const
  {
    return viscosities != nullptr && viscosities->are_set()
             ? (*viscosities)(fluid, cell)
             : phase.both_fluids()[fluid].viscosity;
  }



  template <int dim>
  double
  ViscousOperator<dim>::largest_kinematic_viscosity(
    const unsigned int cell) const
  {
    const auto of_fluid = [&](const unsigned int fluid) {
      return fluid_viscosity(fluid, cell) / phase.both_fluids()[fluid].density;
    };
    return phase.cut_index(cell) < 0 ? of_fluid(phase.fluid_number(cell))
                                     : std::max(of_fluid(0), of_fluid(1));
  }



  template <int dim>
  double
  ViscousOperator<dim>::kinematic_viscosity_of_lightest(
    const unsigned int cell) const
  {
    const Fluids &fluids = phase.both_fluids();
    return cell_viscosity(cell).viscosity /
           (phase.cut_index(cell) < 0
              ? phase.fluid(cell).density
              : std::min(fluids[0].density, fluids[1].density));
  }



  template <int dim>
  typename ViscousOperator<dim>::CellViscosity
  ViscousOperator<dim>::cell_viscosity(const unsigned int cell) const
  {
    const int cut_index = phase.cut_index(cell);
    if (cut_index < 0)
      return {fluid_viscosity(phase.fluid_number(cell), cell), 0., nullptr};
    const CutCell<dim>         &cut = phase.cut_cells()[cut_index];
    const std::array<double, 2> both{
      {fluid_viscosity(0, cell), fluid_viscosity(1, cell)}};
    return {arithmetic_mean(cut.negative_fraction, both),
            harmonic_mean(cut.negative_fraction, both),
            at_wall[cell] ? nullptr : &cut};
  }



  template <int dim>
  const CutCell<dim> *
  ViscousOperator<dim>::cell_with_jumps(const unsigned int cell) const
  {
    const int index = phase.cut_index(cell);
    return index >= 0 && !phase.cut_cells()[index].second_gradients.empty()
             ? &phase.cut_cells()[index]
             : nullptr;
  }



  template <int dim>
  typename ViscousOperator<dim>::CellMatrix
  ViscousOperator<dim>::matrix_of_sides(const unsigned int  cell,
                                        const CutCell<dim> &cut) const
  {
    constexpr unsigned int n_vertices = 1 << dim;
    using Tensor                      = dealii::Tensor<2, dim>;
    const double harmonic             = cell_viscosity(cell).harmonic;
    const auto  &normal               = cut.normal;
    std::array<Tensor, n_vertices * n_vertices> whole;
    for (unsigned int q = 0; q < gauss.n_points; ++q)
      {
        const auto point = gauss.evaluate(space.mesh().graph().cell(cell), q);
        for (unsigned int i = 0; i < n_vertices; ++i)
          for (unsigned int j = 0; j < n_vertices; ++j)
            whole[n_vertices * i + j] +=
              outer_product(gauss.weight * point.determinant *
                              point.gradients[i],
                            point.gradients[j]);
      }
    CellMatrix matrix{};
    const auto add_side = [&](const unsigned int i,
                              const unsigned int j,
                              const Tensor      &T,
                              const double       viscosity) {
      const double trace = dealii::trace(T);
      Tensor sum = viscosity * (trace * dealii::unit_symmetric_tensor<dim>() +
                                transpose(T));
      if (!at_wall[cell])
        {
          const auto   T_n = T * normal, n_T = normal * T;
          const double both = normal * T_n;
          sum += (harmonic - viscosity) *
                 (both * dealii::unit_symmetric_tensor<dim>() +
                  outer_product(n_T, normal) + outer_product(normal, T_n) +
                  (trace - 4. * both) * outer_product(normal, normal));
        }
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int e = 0; e < dim; ++e)
          matrix[dim * i + d][dim * j + e] += sum[d][e];
    };
    for (unsigned int i = 0; i < n_vertices; ++i)
      for (unsigned int j = 0; j < n_vertices; ++j)
        {
          const Tensor &T = cut.second_gradients[n_vertices * i + j];
          add_side(i, j, T, fluid_viscosity(1, cell));
          add_side(i,
                   j,
                   whole[n_vertices * i + j] - T,
                   fluid_viscosity(0, cell));
        }
    return matrix;
  }



  template <int dim>
  typename ViscousOperator<dim>::CellMatrix
  ViscousOperator<dim>::cell_matrix(const unsigned int cell) const
  {
    if (const CutCell<dim> *cut = cell_with_jumps(cell))
      return matrix_of_sides(cell, *cut);
    const CellViscosity viscosity = cell_viscosity(cell);
    CellMatrix          matrix{};
    for (unsigned int q = 0; q < gauss.n_points; ++q)
      {
        const auto   point = gauss.evaluate(space.mesh().graph().cell(cell), q);
        const double weight = gauss.weight * point.determinant;
        for (unsigned int j = 0; j < n_cell_values; ++j)
          {
            dealii::Tensor<2, dim> gradient;
            gradient[j % dim] = weight * point.gradients[j / dim];
            const auto sigma  = viscosity.stress(gradient);
            for (unsigned int i = 0; i < n_cell_values; ++i)
              matrix[i][j] += sigma[i % dim] * point.gradients[i / dim];
          }
      }
    return matrix;
  }



  template <int dim>
  void
  ViscousOperator<dim>::subtract_viscous_force(const Vector &velocity,
                                               Vector       &force) const
  {
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto &nodes = space.nodes(c);
        if (cell_with_jumps(c))
          {
            const auto matrix = cell_matrix(c);
            const auto u      = gather_velocity<dim>(velocity, nodes);
            for (unsigned int i = 0; i < n_cell_values; ++i)
              for (unsigned int j = 0; j < n_cell_values; ++j)
                force.local_element(dim * nodes[i / dim] + i % dim) -=
                  matrix[i][j] * u[j];
            continue;
          }
        const CellViscosity viscosity = cell_viscosity(c);
        std::array<dealii::Tensor<1, dim>, (1 << dim)> u, f;
        for (unsigned int v = 0; v < u.size(); ++v)
          for (unsigned int d = 0; d < dim; ++d)
            u[v][d] = velocity.local_element(dim * nodes[v] + d);
        for (unsigned int q = 0; q < gauss.n_points; ++q)
          {
            const auto             point = gauss.evaluate(graph.cell(c), q);
            dealii::Tensor<2, dim> gradient;
            for (unsigned int v = 0; v < u.size(); ++v)
              gradient += outer_product(u[v], point.gradients[v]);
            const dealii::Tensor<2, dim> sigma =
              (gauss.weight * point.determinant) * viscosity.stress(gradient);
            for (unsigned int v = 0; v < u.size(); ++v)
              f[v] -= sigma * point.gradients[v];
          }
        for (unsigned int v = 0; v < u.size(); ++v)
          for (unsigned int d = 0; d < dim; ++d)
            force.local_element(dim * nodes[v] + d) += f[v][d];
      }
  }



  template <int dim>
  void
  ViscousOperator<dim>::update(const Vector &mass_, const double time_step)
  {
    mass = &mass_;
    dt   = time_step;

    Vector &inverse             = diagonal.inverse_diagonal;
    inverse                     = 0.;
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto &nodes = space.nodes(c);
        if (cell_with_jumps(c))
          {
            const auto matrix = cell_matrix(c);
            for (unsigned int i = 0; i < n_cell_values; ++i)
              inverse.local_element(dim * nodes[i / dim] + i % dim) +=
                matrix[i][i];
            continue;
          }
        const CellViscosity viscosity = cell_viscosity(c);
        for (unsigned int q = 0; q < gauss.n_points; ++q)
          {
            const auto   point  = gauss.evaluate(graph.cell(c), q);
            const double weight = gauss.weight * point.determinant;
            for (unsigned int v = 0; v < nodes.size(); ++v)
              for (unsigned int d = 0; d < dim; ++d)
                inverse.local_element(dim * nodes[v] + d) +=
                  weight * viscosity.diagonal(point.gradients[v], d);
          }
      }
    space.fold(inverse, dim);
    for (unsigned int n = 0; n < mass->locally_owned_size(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
        {
          double &entry = inverse.local_element(dim * n + d);
          entry         = space.is_dependent(n)
                            ? 1.
                            : 1. / (entry + mass->local_element(n) / dt);
        }
  }



  template <int dim>
  void
  ViscousOperator<dim>::vmult(Vector &destination, const Vector &source) const
  {
    work.copy_locally_owned_data_from(source);
    boundary.project(work);
    space.interpolate(work, dim);
    destination = 0.;
    subtract_viscous_force(work, destination);
    space.fold(destination, dim);
    for (unsigned int n = 0; n < mass->locally_owned_size(); ++n)
      for (unsigned int d = 0; d < dim; ++d)
        destination.local_element(dim * n + d) =
          space.is_dependent(n)
            ? source.local_element(dim * n + d)
            : mass->local_element(n) / dt * work.local_element(dim * n + d) -
                destination.local_element(dim * n + d);
    boundary.project(destination);
  }



  THALWEG_INSTANTIATE(ViscousOperator)
} // namespace Thalweg
