// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_interface_fluid_bodies_h
#define thalweg_interface_fluid_bodies_h

#include <thalweg/fields/boundary_nodes.h>
#include <thalweg/fields/node_space.h>

#include <array>
#include <vector>

namespace Thalweg
{
  /**
   * @brief The connected bodies of both fluids: nodes of one sign that share
   * a cell belong to one body, on whichever ranks they are and across
   * hanging faces and periodic boundaries.
   *
   * Bodies are numbered from zero on, the same on all ranks.
   */
  template <int dim>
  class FluidBodies
  {
  public:
    static constexpr int none = -1;

    /// @param phi level set, ghosted, consistent with the constraints
    /// Collective.
    FluidBodies(const NodeSpace<dim> &space, const Vector &phi);

    unsigned int
    size() const
    {
      return fluids.size();
    }

    /// The fluid of a body.
    unsigned int
    fluid(const unsigned int body) const
    {
      return fluids[body];
    }

    /// The body of a local node.
    unsigned int
    of_node(const unsigned int node) const
    {
      return bodies[node];
    }

    /// The body of @p fluid in an owned or ghost cell, or none.
    int
    in_cell(const unsigned int cell, const unsigned int fluid) const;

    /// The same, or else one in a cell that shares a node with it.
    int
    near_cell(const unsigned int cell, const unsigned int fluid) const;

    /// A body of @p fluid in the cells around an owned node, or none.
    int
    near_node(const unsigned int node, const unsigned int fluid) const
    {
      return near[fluid][node];
    }

    /// Which bodies fluid can join or leave through faces. Collective.
    std::vector<bool>
    open(const BoundaryNodes<dim> &boundary) const;

  private:
    /// Gives each node the lowest label of its body. Collective.
    std::vector<double>
    find_labels() const;

    void
    number(const std::vector<double> &labels);

    void
    find_neighbors();

    const NodeSpace<dim>           &space;
    std::vector<unsigned char>      fluid_of_node;
    std::vector<unsigned int>       bodies;
    std::vector<unsigned int>       fluids;
    std::array<std::vector<int>, 2> near;
  };
} // namespace Thalweg

#endif
