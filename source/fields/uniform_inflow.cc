// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/fields/uniform_inflow.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/vector.h>

namespace Thalweg
{
  namespace
  {
    /// Calls @p visit(outward normal times area) for the faces of owned cells
    /// at a boundary.
    template <int dim, typename Visitor>
    void
    for_each_face(const CellGraph<dim>            &graph,
                  const dealii::types::boundary_id boundary,
                  const Visitor                   &visit)
    {
      using Geometry = dealii::GeometryInfo<dim>;
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        for (unsigned int f = 0; f < graph.n_faces; ++f)
          {
            const auto &face = graph.cell(c).faces[f];
            if (face.behind != CellGraph<dim>::Behind::boundary ||
                face.boundary_id != boundary)
              continue;
            // The normal of a bilinear face is linear in each coordinate: its
            // value in the middle is its mean.
            dealii::Point<dim> middle;
            for (unsigned int d = 0; d < dim; ++d)
              middle[d] = d == f / 2 ? f % 2 : .5;
            const auto point =
              Q1::evaluate<dim>(graph.cell(c),
                                Q1::values<dim>(middle),
                                Q1::reference_gradients<dim>(middle));
            visit(point.determinant *
                  (point.covariant * Geometry::unit_normal_vector[f]));
          }
    }
  } // namespace



  template <int dim>
  dealii::Tensor<1, dim>
  vector_area(const Mesh<dim> &mesh, const dealii::types::boundary_id boundary)
  {
    dealii::Tensor<1, dim> sum;
    for_each_face(mesh.graph(),
                  boundary,
                  [&](const dealii::Tensor<1, dim> &area) { sum += area; });
    return dealii::Utilities::MPI::sum(sum,
                                       mesh.triangulation().get_communicator());
  }



  template <int dim>
  double
  scalar_area(const Mesh<dim> &mesh, const dealii::types::boundary_id boundary)
  {
    double sum = 0;
    for_each_face(mesh.graph(),
                  boundary,
                  [&](const dealii::Tensor<1, dim> &area) {
                    sum += area.norm();
                  });
    return dealii::Utilities::MPI::sum(sum,
                                       mesh.triangulation().get_communicator());
  }



  template <int dim>
  UniformInflow<dim>::UniformInflow(
    std::unique_ptr<dealii::FunctionParser<dim>> flow_rate,
    const dealii::Tensor<1, dim>                &area)
    : dealii::Function<dim>(dim)
    , flow_rate(std::move(flow_rate))
    , direction(-area / area.norm_square())
  {}



  template <int dim>
  void
  UniformInflow<dim>::set_time(const double time)
  {
    dealii::Function<dim>::set_time(time);
    flow_rate->set_time(time);
  }



  template <int dim>
  double
  UniformInflow<dim>::value(const dealii::Point<dim> &,
                            const unsigned int component) const
  {
    return flow_rate->value(dealii::Point<dim>()) * direction[component];
  }



  template <int dim>
  void
  UniformInflow<dim>::vector_value(const dealii::Point<dim> &,
                                   dealii::Vector<double> &values) const
  {
    const double rate = flow_rate->value(dealii::Point<dim>());
    for (unsigned int d = 0; d < dim; ++d)
      values[d] = rate * direction[d];
  }



  template double
  scalar_area(const Mesh<2> &, const dealii::types::boundary_id);
  template double
  scalar_area(const Mesh<3> &, const dealii::types::boundary_id);
  template dealii::Tensor<1, 2>
  vector_area(const Mesh<2> &, const dealii::types::boundary_id);
  template dealii::Tensor<1, 3>
  vector_area(const Mesh<3> &, const dealii::types::boundary_id);
  THALWEG_INSTANTIATE(UniformInflow)
} // namespace Thalweg
