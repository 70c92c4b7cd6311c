// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/boundary_extension.h>

namespace Thalweg
{
  namespace
  {
    /// Calls @p visit(boundary node, free node) for all pairs in owned cells.
    template <int dim, typename Visitor>
    void
    for_each_pair(const LagrangeSpace<dim> &space,
                  const Vector             &is_free,
                  const Visitor            &visit)
    {
      constexpr double   wholly = 1. - 1e-10;
      const unsigned int n      = space.n_nodes_per_cell();
      for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
        for (unsigned int i = 0; i < n; ++i)
          if (is_free.local_element(space.nodes(c)[i]) < wholly)
            for (unsigned int j = 0; j < n; ++j)
              if (is_free.local_element(space.nodes(c)[j]) >= wholly)
                visit(space.nodes(c)[i], space.nodes(c)[j]);
    }
  } // namespace



  template <int dim>
  BoundaryExtension<dim>::BoundaryExtension(const LagrangeSpace<dim> &space,
                                            const FlowBoundary<dim>  &boundary)
    : space(space)
  {
    space.initialize(work, dim);
    space.initialize(is_free, 1);
    is_free = 1.;
    for (const auto &entry : boundary.fixed().all())
      if (entry.kind != BoundaryKind::slip)
        is_free.local_element(entry.node) = 0.;
    space.interpolate(is_free, 1);
    Vector counts;
    space.initialize(counts, 1);
    for_each_pair(space,
                  is_free,
                  [&](const unsigned int fixed, const unsigned int) {
                    counts.local_element(fixed) += 1.;
                  });
    space.fold(counts, 1);
    for (const auto &entry : boundary.fixed().all())
      if (entry.kind != BoundaryKind::slip &&
          counts.local_element(entry.node) > 0.)
        {
          nodes.push_back(entry.node);
          shares.push_back(1. / counts.local_element(entry.node));
        }
  }



  template <int dim>
  void
  BoundaryExtension<dim>::extend(const Vector &field, Vector &extension) const
  {
    work.zero_out_ghost_values();
    work.copy_locally_owned_data_from(field);
    space.interpolate(work, dim);
    extension.zero_out_ghost_values();
    extension = 0.;
    for_each_pair(space,
                  is_free,
                  [&](const unsigned int fixed, const unsigned int free) {
                    for (unsigned int d = 0; d < dim; ++d)
                      extension.local_element(dim * fixed + d) +=
                        work.local_element(dim * free + d);
                  });
    space.fold(extension, dim);
    work.zero_out_ghost_values();
    work = 0.;
    for (unsigned int i = 0; i < nodes.size(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        work.local_element(dim * nodes[i] + d) =
          shares[i] * extension.local_element(dim * nodes[i] + d);
    extension.copy_locally_owned_data_from(work);
    space.interpolate(extension, dim);
  }



  THALWEG_INSTANTIATE(BoundaryExtension)
} // namespace Thalweg
