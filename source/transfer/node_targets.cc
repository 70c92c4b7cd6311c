// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/transfer/node_targets.h>

namespace Thalweg
{
  namespace
  {
    /// Two images of a node are the same if they are no farther apart than
    /// this part of the cell.
    constexpr double same_place = 1e-6;



    /// The image of a node that is nearest to @p vertex.
    template <int dim>
    dealii::Point<dim>
    nearest_image(const NodeSpace<dim>     &space,
                  const unsigned int        node,
                  const dealii::Point<dim> &vertex)
    {
      auto position = space.position(node);
      for (const auto &offset : space.mesh().graph().periodic_offsets())
        if ((position + offset).distance(vertex) < position.distance(vertex))
          position += offset;
      return position;
    }
  } // namespace



  template <int dim>
  void
  find_node_targets(const NodeSpace<dim>         &space,
                    const unsigned int            cell,
                    std::vector<NodeTarget<dim>> &targets)
  {
    const auto &geometry = space.mesh().graph().cell(cell);
    const auto &nodes    = space.nodes(cell);
    const auto  add      = [&](const unsigned int        node,
                         const dealii::Point<dim> &position,
                         const unsigned int        vertex,
                         const double              weight) {
      for (NodeTarget<dim> &target : targets)
        if (target.node == node && (target.position - position).norm() <=
                                     same_place * geometry.extent.norm())
          {
            target.coefficients[vertex] += weight;
            return;
          }
      NodeTarget<dim> target{node, position, {}};
      target.coefficients[vertex] = weight;
      targets.push_back(target);
    };
    targets.clear();
    for (unsigned int v = 0; v < nodes.size(); ++v)
      {
        const auto hanging = space.hanging_masters(nodes[v]);
        if (hanging.first == hanging.second)
          add(nodes[v], geometry.vertices[v], v, 1.);
        for (unsigned int k = hanging.first; k < hanging.second; ++k)
          {
            const auto &entry = space.dependences().all()[k];
            add(entry.master,
                nearest_image(space, entry.master, geometry.vertices[v]),
                v,
                entry.weight);
          }
      }
  }



  template void
  find_node_targets<2>(const NodeSpace<2> &,
                       const unsigned int,
                       std::vector<NodeTarget<2>> &);
  template void
  find_node_targets<3>(const NodeSpace<3> &,
                       const unsigned int,
                       std::vector<NodeTarget<3>> &);
} // namespace Thalweg
