// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
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
    const int  cut_index = phase.cut_index(cell);
    const bool are_set   = viscosities != nullptr && viscosities->are_set();
    if (cut_index < 0)
      return {are_set ? (*viscosities)(phase.fluid_number(cell), cell)
                      : phase.fluid(cell).viscosity,
              0.,
              nullptr};
    const CutCell<dim> &cut = phase.cut_cells()[cut_index];
    if (at_wall[cell])
      return {are_set ? arithmetic_mean(cut.negative_fraction,
                                        {{(*viscosities)(0, cell),
                                          (*viscosities)(1, cell)}})
                      : cut.arithmetic_viscosity,
              0.,
              nullptr};
    if (!are_set)
      return {cut.arithmetic_viscosity, cut.harmonic_viscosity, &cut};
    const std::array<double, 2> both{
      {(*viscosities)(0, cell), (*viscosities)(1, cell)}};
    return {arithmetic_mean(cut.negative_fraction, both),
            harmonic_mean(cut.negative_fraction, both),
            &cut};
  }



  template <int dim>
  typename ViscousOperator<dim>::CellMatrix
  ViscousOperator<dim>::cell_matrix(const unsigned int cell) const
  {
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
        const auto         &nodes     = space.nodes(c);
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
        const auto         &nodes     = space.nodes(c);
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
