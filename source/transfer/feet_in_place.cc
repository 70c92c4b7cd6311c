// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/lagrange_shape.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/transfer/feet_in_place.h>

#include <deal.II/base/exceptions.h>

namespace Thalweg
{
  namespace
  {
    /// Sets @p values to those of a field with n_components values a node.
    template <int dim, unsigned int degree, unsigned int n_components>
    void
    evaluate(const Vector                     &vector,
             const unsigned int               *nodes,
             const dealii::Point<dim>         &reference,
             std::array<double, n_components> &values)
    {
      const auto shape = LagrangeShape::values<dim, degree>(reference);
      values.fill(0.);
      for (unsigned int i = 0; i < shape.size(); ++i)
        for (unsigned int d = 0; d < n_components; ++d)
          values[d] +=
            shape[i] * vector.local_element(n_components * nodes[i] + d);
    }
  } // namespace



  template <int dim>
  std::vector<Foot<dim>>
  feet_in_place(const std::vector<unsigned int>       &cells,
                const std::vector<dealii::Point<dim>> &reference_points,
                const LagrangeSpace<dim>              &velocity_space,
                const Vector                          &velocity,
                const NodeSpace<dim>                  &level_set_space,
                const Vector                          &level_set)
  {
    AssertDimension(cells.size(), reference_points.size());
    const Mesh<dim>       &mesh = level_set_space.mesh();
    std::vector<Foot<dim>> feet(cells.size());
    for (std::size_t p = 0; p < cells.size(); ++p)
      {
        const unsigned int  c         = cells[p];
        const auto         &reference = reference_points[p];
        const unsigned int *nodes     = velocity_space.nodes(c);
        if (velocity_space.degree() == 1)
          evaluate<dim, 1, dim>(velocity, nodes, reference, feet[p].velocity);
        else
          evaluate<dim, 2, dim>(velocity, nodes, reference, feet[p].velocity);
        std::array<double, 1> phi;
        evaluate<dim, 1, 1>(level_set,
                            level_set_space.nodes(c).data(),
                            reference,
                            phi);
        feet[p].level_set = phi[0];
        feet[p].position =
          Q1::position<dim>(mesh.graph().cell(c).vertices, reference);
        feet[p].boundary = dealii::numbers::invalid_boundary_id;
        feet[p].found    = true;
      }
    return feet;
  }



  template std::vector<Foot<2>>
  feet_in_place(const std::vector<unsigned int> &,
                const std::vector<dealii::Point<2>> &,
                const LagrangeSpace<2> &,
                const Vector &,
                const NodeSpace<2> &,
                const Vector &);
  template std::vector<Foot<3>>
  feet_in_place(const std::vector<unsigned int> &,
                const std::vector<dealii::Point<3>> &,
                const LagrangeSpace<3> &,
                const Vector &,
                const NodeSpace<3> &,
                const Vector &);
} // namespace Thalweg
