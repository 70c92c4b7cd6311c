// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/compat.h>
#include <thalweg/fluid/flow_operators.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <map>

namespace Thalweg
{
  namespace
  {
    /// Whether a cell is the box between its corners for the mapping too.
    template <int dim>
    bool
    is_box(const typename CellGraph<dim>::Cell   &cell,
           const dealii::FEValues<dim>           &values,
           const std::vector<dealii::Point<dim>> &unit_points)
    {
      if (!cell.axis_parallel)
        return false;
      for (unsigned int q = 0; q < unit_points.size(); ++q)
        for (unsigned int d = 0; d < dim; ++d)
          if (std::abs(values.quadrature_point(q)[d] - cell.vertices[0][d] -
                       unit_points[q][d] * cell.extent[d]) >
              1e-10 * cell.extent[d] + coordinate_round_off(cell.vertices[0]))
            return false;
      return true;
    }
  } // namespace



  template <int dim>
  FlowOperators<dim>::FlowOperators(const LagrangeSpace<dim> &velocity_space,
                                    const LagrangeSpace<dim> &pressure_space,
                                    const FlowBoundary<dim>  &boundary,
                                    const bool                lumped_mass)
    : mass(velocity_space)
    , stiffness(velocity_space)
    , pressure_stiffness(pressure_space)
    , pressure_mass(pressure_space)
    , velocity_space(velocity_space)
    , pressure_space(pressure_space)
  {
    const std::vector<unsigned int> examples = find_shapes();
    const unsigned int              n_nodes = velocity_space.n_nodes_per_cell();
    const unsigned int n_pressures          = pressure_space.n_nodes_per_cell();
    gradient.assign(examples.size() * n_nodes * n_pressures * dim, 0.);
    divergence = gradient;
    for (unsigned int s = 0; s < examples.size(); ++s)
      integrate_cell(examples[s], s, lumped_mass);
    integrate_boundary(boundary);
  }



  template <int dim>
  std::vector<unsigned int>
  FlowOperators<dim>::find_shapes()
  {
    const CellGraph<dim>     &graph = velocity_space.mesh().graph();
    const dealii::QGauss<dim> gauss(2);
    dealii::FEValues<dim>     values(velocity_space.mapping(),
                                 velocity_space.scalar().get_fe(),
                                 gauss,
                                 dealii::update_quadrature_points);
    std::map<std::array<long, dim>, unsigned int> boxes;
    std::vector<unsigned int>                     examples;
    std::vector<unsigned int>                     shapes;
    lengths.resize(graph.n_owned_cells());
    double unit = 1e-9 * graph.minimal_extent();
    if (graph.n_owned_cells() > 0)
      unit += coordinate_round_off(graph.cell(0).vertices[0]);
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        lengths[c] = graph.iterator(c)->minimum_vertex_distance();
        values.reinit(
          Compat::on_dof_handler(graph.iterator(c), velocity_space.scalar()));
        unsigned int shape = examples.size();
        if (is_box<dim>(graph.cell(c), values, gauss.get_points()))
          {
            std::array<long, dim> key;
            for (unsigned int d = 0; d < dim; ++d)
              key[d] = std::lround(graph.cell(c).extent[d] / unit);
            shape = boxes.emplace(key, shape).first->second;
          }
        if (shape == examples.size())
          examples.push_back(c);
        shapes.push_back(shape);
      }
    for (CellOperator<dim> *matrix :
         {&mass, &stiffness, &pressure_stiffness, &pressure_mass})
      {
        matrix->reinit(examples.size());
        for (unsigned int c = 0; c < shapes.size(); ++c)
          matrix->set_shape(c, shapes[c]);
      }
    return examples;
  }



  template <int dim>
  void
  FlowOperators<dim>::integrate_cell(const unsigned int cell,
                                     const unsigned int shape,
                                     const bool         lumped_mass)
  {
    using namespace dealii;
    const auto        &graph = velocity_space.mesh().graph();
    const unsigned int points =
      velocity_space.degree() + (graph.cell(cell).axis_parallel ? 1 : 2);
    const QGauss<dim>        gauss(points);
    const QGaussLobatto<dim> at_nodes(velocity_space.degree() + 1);
    const auto    flags = update_values | update_gradients | update_JxW_values;
    FEValues<dim> velocity(velocity_space.mapping(),
                           velocity_space.scalar().get_fe(),
                           gauss,
                           flags);
    FEValues<dim> pressure(pressure_space.mapping(),
                           pressure_space.scalar().get_fe(),
                           gauss,
                           flags);
    FEValues<dim> nodal(velocity_space.mapping(),
                        velocity_space.scalar().get_fe(),
                        at_nodes,
                        flags);
    velocity.reinit(
      Compat::on_dof_handler(graph.iterator(cell), velocity_space.scalar()));
    pressure.reinit(
      Compat::on_dof_handler(graph.iterator(cell), pressure_space.scalar()));
    nodal.reinit(
      Compat::on_dof_handler(graph.iterator(cell), velocity_space.scalar()));

    const auto          &row   = velocity_space.lexicographic();
    const auto          &place = pressure_space.lexicographic();
    const unsigned int   n = row.size(), m = place.size();
    const FEValues<dim> &for_mass = lumped_mass ? nodal : velocity;
    for (unsigned int q = 0; q < for_mass.n_quadrature_points; ++q)
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          mass.matrix(shape)[row[i] * n + row[j]] +=
            for_mass.shape_value(i, q) * for_mass.shape_value(j, q) *
            for_mass.JxW(q);
    for (unsigned int q = 0; q < velocity.n_quadrature_points; ++q)
      {
        const double w = velocity.JxW(q);
        for (unsigned int i = 0; i < n; ++i)
          {
            for (unsigned int j = 0; j < n; ++j)
              stiffness.matrix(shape)[row[i] * n + row[j]] +=
                velocity.shape_grad(i, q) * velocity.shape_grad(j, q) * w;
            for (unsigned int j = 0; j < m; ++j)
              for (unsigned int d = 0; d < dim; ++d)
                {
                  const unsigned int entry =
                    ((shape * n + row[i]) * m + place[j]) * dim + d;
                  gradient[entry] += velocity.shape_value(i, q) *
                                     pressure.shape_grad(j, q)[d] * w;
                  divergence[entry] += velocity.shape_grad(i, q)[d] *
                                       pressure.shape_value(j, q) * w;
                }
          }
        for (unsigned int i = 0; i < m; ++i)
          for (unsigned int j = 0; j < m; ++j)
            {
              pressure_stiffness.matrix(shape)[place[i] * m + place[j]] +=
                pressure.shape_grad(i, q) * pressure.shape_grad(j, q) * w;
              pressure_mass.matrix(shape)[place[i] * m + place[j]] +=
                pressure.shape_value(i, q) * pressure.shape_value(j, q) * w;
            }
      }
  }



  template <int dim>
  void
  FlowOperators<dim>::integrate_boundary(const FlowBoundary<dim> &boundary)
  {
    using namespace dealii;
    const auto           &graph = velocity_space.mesh().graph();
    const auto           &row   = velocity_space.lexicographic();
    const unsigned int    n     = row.size();
    const QGauss<dim - 1> gauss(velocity_space.degree() + 1);
    FEFaceValues<dim>     values(velocity_space.mapping(),
                             velocity_space.scalar().get_fe(),
                             gauss,
                             update_values | update_gradients |
                               update_normal_vectors | update_JxW_values);
    for_each_sticking_face(
      graph,
      boundary.conditions(),
      [&](const unsigned int c, const unsigned int f) {
        values.reinit(Compat::on_dof_handler(graph.iterator(c),
                                             velocity_space.scalar()),
                      f);
        BoundaryFace face{c, std::vector<double>(n * n, 0.)};
        for (unsigned int q = 0; q < gauss.size(); ++q)
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              face.matrix[row[i] * n + row[j]] +=
                values.shape_value(i, q) *
                (values.shape_grad(j, q) * values.normal_vector(q)) *
                values.JxW(q);
        faces.push_back(std::move(face));
      });
  }



  template <int dim>
  void
  FlowOperators<dim>::add_boundary_gradient(const Vector &velocity,
                                            Vector       &force,
                                            const double  factor) const
  {
    const unsigned int n = velocity_space.n_nodes_per_cell();
    for (const BoundaryFace &face : faces)
      {
        const unsigned int *const nodes = velocity_space.nodes(face.cell);
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            for (unsigned int d = 0; d < dim; ++d)
              force.local_element(dim * nodes[i] + d) +=
                factor * face.matrix[i * n + j] *
                velocity.local_element(dim * nodes[j] + d);
      }
  }



  namespace
  {
    /// force_i += factor sum_j table[i][j] p_j, cell by cell.
    template <int dim>
    void
    apply_columns(const FlowOperators<dim>  &operators,
                  const std::vector<double> &table,
                  const Vector              &pressure,
                  Vector                    &force,
                  const double               factor)
    {
      const auto        &V = operators.velocity_space;
      const auto        &P = operators.pressure_space;
      const unsigned int n = V.n_nodes_per_cell(), m = P.n_nodes_per_cell();
      for (unsigned int c = 0; c < V.mesh().graph().n_owned_cells(); ++c)
        {
          const double *entry = &table[operators.mass.shape(c) * n * m * dim];
          for (unsigned int i = 0; i < n; ++i)
            {
              double sum[dim] = {};
              for (unsigned int j = 0; j < m; ++j)
                {
                  const double p = pressure.local_element(P.nodes(c)[j]);
                  for (unsigned int d = 0; d < dim; ++d)
                    sum[d] += *entry++ * p;
                }
              for (unsigned int d = 0; d < dim; ++d)
                force.local_element(dim * V.nodes(c)[i] + d) += factor * sum[d];
            }
        }
    }



    /// result_j += factor sum_i table[i][j] . V_i, cell by cell.
    template <int dim>
    void
    apply_rows(const FlowOperators<dim>  &operators,
               const std::vector<double> &table,
               const Vector              &velocity,
               Vector                    &result,
               const double               factor,
               const double *const        cell_factors)
    {
      const auto        &V = operators.velocity_space;
      const auto        &P = operators.pressure_space;
      const unsigned int n = V.n_nodes_per_cell(), m = P.n_nodes_per_cell();
      std::array<double, (dim == 2 ? 9 : 27)> sum;
      for (unsigned int c = 0; c < V.mesh().graph().n_owned_cells(); ++c)
        {
          const double *entry = &table[operators.mass.shape(c) * n * m * dim];
          sum.fill(0.);
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < m; ++j)
              for (unsigned int d = 0; d < dim; ++d)
                sum[j] +=
                  *entry++ * velocity.local_element(dim * V.nodes(c)[i] + d);
          const double f = cell_factors ? factor * cell_factors[c] : factor;
          for (unsigned int j = 0; j < m; ++j)
            result.local_element(P.nodes(c)[j]) += f * sum[j];
        }
    }
  } // namespace



  template <int dim>
  void
  FlowOperators<dim>::add_gradient(const Vector &pressure,
                                   Vector       &force,
                                   const double  factor) const
  {
    apply_columns(*this, gradient, pressure, force, factor);
  }



  template <int dim>
  void
  FlowOperators<dim>::add_pressure_force(const Vector &pressure,
                                         Vector       &force,
                                         const double  factor) const
  {
    apply_columns(*this, divergence, pressure, force, -factor);
  }



  template <int dim>
  void
  FlowOperators<dim>::add_weak_gradient(const Vector       &velocity,
                                        Vector             &result,
                                        const double        factor,
                                        const double *const cell_factors) const
  {
    apply_rows(*this, gradient, velocity, result, factor, cell_factors);
  }



  template <int dim>
  void
  FlowOperators<dim>::add_divergence(const Vector &velocity,
                                     Vector       &result,
                                     const double  factor) const
  {
    apply_rows(*this, divergence, velocity, result, -factor, nullptr);
  }



  THALWEG_INSTANTIATE(FlowOperators)
} // namespace Thalweg
