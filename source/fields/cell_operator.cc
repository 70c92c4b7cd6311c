// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/cell_operator.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    /// The product for cells with n nodes, known to the compiler.
    template <int dim, unsigned int n, unsigned int n_components>
    void
    add_products(const CellOperator<dim> &A,
                 const Vector            &source,
                 Vector                  &destination,
                 const double             factor,
                 const double *const      cell_factors)
    {
      const auto        &space   = A.space();
      const unsigned int n_cells = space.mesh().graph().n_owned_cells();
      for (unsigned int c = 0; c < n_cells; ++c)
        {
          const unsigned int *const nodes  = space.nodes(c);
          const double *const       matrix = A.matrix(A.shape(c));
          const double f = cell_factors ? factor * cell_factors[c] : factor;
          double       x[n * n_components];
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int d = 0; d < n_components; ++d)
              x[i * n_components + d] =
                f * source.local_element(nodes[i] * n_components + d);
          for (unsigned int i = 0; i < n; ++i)
            {
              double y[n_components] = {};
              for (unsigned int j = 0; j < n; ++j)
                for (unsigned int d = 0; d < n_components; ++d)
                  y[d] += matrix[i * n + j] * x[j * n_components + d];
              for (unsigned int d = 0; d < n_components; ++d)
                destination.local_element(nodes[i] * n_components + d) += y[d];
            }
        }
    }



    template <int dim, unsigned int n>
    void
    add_products(const CellOperator<dim> &A,
                 const Vector            &source,
                 Vector                  &destination,
                 const unsigned int       n_components,
                 const double             factor,
                 const double *const      cell_factors)
    {
      if (n_components == 1)
        add_products<dim, n, 1>(A, source, destination, factor, cell_factors);
      else
        add_products<dim, n, dim>(A, source, destination, factor, cell_factors);
    }
  } // namespace



  template <int dim>
  CellOperator<dim>::CellOperator(const LagrangeSpace<dim> &space)
    : space_(&space)
    , n(space.n_nodes_per_cell())
  {}



  template <int dim>
  void
  CellOperator<dim>::reinit(const unsigned int n_shapes)
  {
    entries.assign(n_shapes * n * n, 0.);
    shape_of_cell.assign(space_->mesh().graph().n_owned_cells(), 0);
  }



  template <int dim>
  void
  CellOperator<dim>::combine(const double             a,
                             const CellOperator<dim> &A,
                             const double             b,
                             const CellOperator<dim> &B)
  {
    AssertDimension(A.entries.size(), B.entries.size());
    space_        = A.space_;
    n             = A.n;
    shape_of_cell = A.shape_of_cell;
    entries.resize(A.entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i)
      entries[i] = a * A.entries[i] + b * B.entries[i];
  }



  template <int dim>
  void
  CellOperator<dim>::add_product(const Vector       &source,
                                 Vector             &destination,
                                 const unsigned int  n_components,
                                 const double        factor,
                                 const double *const cell_factors) const
  {
    Assert(n_components == 1 || n_components == dim,
           dealii::ExcNotImplemented());
    if (space_->degree() == 1)
      add_products<dim, (1 << dim)>(
        *this, source, destination, n_components, factor, cell_factors);
    else
      add_products<dim, (dim == 2 ? 9 : 27)>(
        *this, source, destination, n_components, factor, cell_factors);
  }



  template <int dim>
  void
  CellOperator<dim>::add_diagonal(Vector             &destination,
                                  const unsigned int  n_components,
                                  const double *const cell_factors) const
  {
    for (unsigned int c = 0; c < shape_of_cell.size(); ++c)
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int d = 0; d < n_components; ++d)
          destination.local_element(space_->nodes(c)[i] * n_components + d) +=
            (cell_factors ? cell_factors[c] : 1.) * matrix(shape(c))[i * n + i];
  }



  THALWEG_INSTANTIATE(CellOperator)
} // namespace Thalweg
