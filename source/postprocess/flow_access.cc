// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/compat.h>
#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/flow_access.h>

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_values.h>

namespace Thalweg
{
  template <int dim>
  FlowFields<dim>
  flow_of(const FlowView<dim> &solution)
  {
    if (solution.flow != nullptr)
      return *solution.flow;
    return {solution.mesh.mapping(),
            solution.space.velocity(),
            solution.space.scalar(),
            solution.velocity,
            solution.pressure,
            nullptr,
            nullptr,
            solution.fluids[0].density,
            solution.fluids[0].viscosity,
            solution.time};
  }


  namespace
  {
    /// In reference coordinates.
    constexpr double curved_tolerance = .05;


    template <int dim>
    PointValue<dim>
    evaluate(const FlowFields<dim>                                    &flow,
             const typename dealii::Triangulation<dim>::cell_iterator &cell,
             const dealii::Point<dim>                                 &xi)
    {
      const dealii::Quadrature<dim> point(xi);
      dealii::FEValues<dim>         velocity(flow.mapping,
                                     flow.velocity_dofs.get_fe(),
                                     point,
                                     dealii::update_values);
      dealii::FEValues<dim>         pressure(flow.mapping,
                                     flow.pressure_dofs.get_fe(),
                                     point,
                                     dealii::update_values);
      velocity.reinit(Compat::on_dof_handler(cell, flow.velocity_dofs));
      pressure.reinit(Compat::on_dof_handler(cell, flow.pressure_dofs));
      std::vector<dealii::Tensor<1, dim>> v(1);
      std::vector<double>                 p(1);
      velocity[dealii::FEValuesExtractors::Vector(0)].get_function_values(
        flow.velocity, v);
      pressure.get_function_values(flow.pressure, p);
      return {p[0], v[0]};
    }
  } // namespace


  template <int dim>
  std::vector<PointValue<dim>>
  evaluate_at(const FlowView<dim>                   &solution,
              const std::vector<dealii::Point<dim>> &points,
              const std::string                     &what)
  {
    const FlowFields<dim> flow = flow_of(solution);
    // Located anew each time, since the mesh may have changed.
    const auto located =
      solution.flow == nullptr
        ? locate(solution.mesh, points, what)
        : locate(solution.mesh, flow.mapping, points, what, curved_tolerance);
    std::vector<double> numbers(points.size() * (dim + 1), 0.);
    for (std::size_t p = 0; p < points.size(); ++p)
      if (located[p].is_here)
        {
          const auto value =
            evaluate<dim>(flow,
                          solution.mesh.graph().iterator(located[p].cell),
                          located[p].xi);
          numbers[p * (dim + 1)] = value.pressure;
          for (unsigned int d = 0; d < dim; ++d)
            numbers[p * (dim + 1) + 1 + d] = value.velocity[d];
        }
    dealii::Utilities::MPI::sum(
      numbers, solution.mesh.triangulation().get_communicator(), numbers);
    std::vector<PointValue<dim>> values(points.size());
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        values[p].pressure = numbers[p * (dim + 1)];
        for (unsigned int d = 0; d < dim; ++d)
          values[p].velocity[d] = numbers[p * (dim + 1) + 1 + d];
      }
    return values;
  }


  template <int dim>
  void
  check_points(const Mesh<dim>                       &mesh,
               const std::vector<dealii::Point<dim>> &points,
               const std::string                     &what)
  {
    locate(mesh,
           mesh.mapping(),
           points,
           what,
           mesh.graph().all_axis_parallel() ? 1e-9 : curved_tolerance);
  }


#define THALWEG_INSTANTIATE_FLOW_ACCESS(dim)                            \
  template FlowFields<dim>              flow_of(const FlowView<dim> &); \
  template std::vector<PointValue<dim>> evaluate_at(                    \
    const FlowView<dim> &,                                              \
    const std::vector<dealii::Point<dim>> &,                            \
    const std::string &);                                               \
  template void check_points(const Mesh<dim> &,                         \
                             const std::vector<dealii::Point<dim>> &,   \
                             const std::string &);
  THALWEG_INSTANTIATE_FLOW_ACCESS(2)
  THALWEG_INSTANTIATE_FLOW_ACCESS(3)
#undef THALWEG_INSTANTIATE_FLOW_ACCESS
} // namespace Thalweg
