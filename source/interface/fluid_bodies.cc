// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/interface/fluid_bodies.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace Thalweg
{
  namespace
  {
    /// Sets of nodes that can be united.
    class Sets
    {
    public:
      explicit Sets(const unsigned int n)
        : parent(n)
      {
        std::iota(parent.begin(), parent.end(), 0u);
      }

      unsigned int
      root(unsigned int i)
      {
        while (parent[i] != i)
          i = parent[i] = parent[parent[i]];
        return i;
      }

      void
      unite(const unsigned int i, const unsigned int j)
      {
        const unsigned int a = root(i), b = root(j);
        parent[std::max(a, b)] = std::min(a, b);
      }

    private:
      std::vector<unsigned int> parent;
    };

    void
    lower(int &body, const int other)
    {
      if (other >= 0 && (body < 0 || other < body))
        body = other;
    }
  } // namespace



  template <int dim>
  FluidBodies<dim>::FluidBodies(const NodeSpace<dim> &space, const Vector &phi)
    : space(space)
    , fluid_of_node(space.dependences().n_nodes())
  {
    for (unsigned int n = 0; n < fluid_of_node.size(); ++n)
      fluid_of_node[n] = phi.local_element(n) < 0 ? 0 : 1;
    number(find_labels());
    find_neighbors();
  }



  template <int dim>
  std::vector<double>
  FluidBodies<dim>::find_labels() const
  {
    Sets sets(fluid_of_node.size());
    for (unsigned int c = 0; c < space.mesh().graph().n_cells(); ++c)
      {
        int first[2] = {none, none};
        for (const unsigned int node : space.nodes(c))
          if (int &other = first[fluid_of_node[node]]; other == none)
            other = node;
          else
            sets.unite(other, node);
      }
    for (const Dependence &entry : space.dependences().all())
      if (fluid_of_node[entry.node] == fluid_of_node[entry.master])
        sets.unite(entry.node, entry.master);

    // Labels are places on the space-filling curve: the same bodies have the
    // same order on any number of ranks.
    Vector labels;
    space.initialize_scalar(labels);
    std::vector<double> of_node(fluid_of_node.size(),
                                std::numeric_limits<double>::max());
    for (unsigned int c = 0; c < space.mesh().graph().n_cells(); ++c)
      for (const unsigned int node : space.nodes(c))
        of_node[node] =
          std::min<double>(of_node[node],
                           space.mesh().graph().cell(c).global_index);
    const MPI_Comm communicator =
      space.mesh().triangulation().get_communicator();
    for (bool has_changed = true; has_changed;)
      {
        std::vector<double> of_set = of_node;
        for (unsigned int n = 0; n < of_node.size(); ++n)
          {
            double &label = of_set[sets.root(n)];
            label         = std::min(label, of_node[n]);
          }
        labels.zero_out_ghost_values();
        for (unsigned int n = 0; n < of_node.size(); ++n)
          labels.local_element(n) = of_set[sets.root(n)];
        labels.compress(dealii::VectorOperation::min);
        labels.update_ghost_values();
        has_changed = false;
        for (unsigned int n = 0; n < of_node.size(); ++n)
          {
            has_changed =
              has_changed || labels.local_element(n) != of_set[sets.root(n)];
            of_node[n] = labels.local_element(n);
          }
        has_changed =
          dealii::Utilities::MPI::logical_or(has_changed, communicator);
      }
    return of_node;
  }



  template <int dim>
  void
  FluidBodies<dim>::number(const std::vector<double> &labels)
  {
    // The label is that of a node, which has a fluid.
    const unsigned int  n_owned = space.scalar_layout().locally_owned_size();
    std::vector<double> own;
    for (unsigned int n = 0; n < n_owned; ++n)
      own.push_back(2. * labels[n] + fluid_of_node[n]);
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    std::map<double, unsigned int> numbers;
    for (const auto &of_rank : dealii::Utilities::MPI::all_gather(
           space.mesh().triangulation().get_communicator(), own))
      for (const double label : of_rank)
        numbers[label] = 0;
    for (auto &[label, number] : numbers)
      {
        number = fluids.size();
        fluids.push_back(static_cast<std::uint64_t>(label) % 2);
      }
    bodies.resize(labels.size());
    auto found = numbers.begin();
    for (unsigned int n = 0; n < labels.size(); ++n)
      {
        const double label = 2. * labels[n] + fluid_of_node[n];
        // Most nodes have the same as those before them.
        if (found->first != label)
          found = numbers.find(label);
        bodies[n] = found->second;
      }
  }



  template <int dim>
  void
  FluidBodies<dim>::find_neighbors()
  {
    for (unsigned int fluid = 0; fluid < 2; ++fluid)
      {
        auto &of_node = near[fluid];
        of_node.assign(bodies.size(), none);
        for (unsigned int c = 0; c < space.mesh().graph().n_cells(); ++c)
          for (const unsigned int node : space.nodes(c))
            lower(of_node[node], in_cell(c, fluid));
        for (const Dependence &entry : space.dependences().all())
          {
            lower(of_node[entry.master], of_node[entry.node]);
            lower(of_node[entry.node], of_node[entry.master]);
          }
      }
  }



  template <int dim>
  int
  FluidBodies<dim>::in_cell(const unsigned int cell,
                            const unsigned int fluid) const
  {
    for (const unsigned int node : space.nodes(cell))
      if (fluid_of_node[node] == fluid)
        return bodies[node];
    return none;
  }



  template <int dim>
  int
  FluidBodies<dim>::near_cell(const unsigned int cell,
                              const unsigned int fluid) const
  {
    int body = in_cell(cell, fluid);
    if (body == none)
      for (const unsigned int node : space.nodes(cell))
        lower(body, near[fluid][node]);
    return body;
  }



  template <int dim>
  std::vector<bool>
  FluidBodies<dim>::open(const BoundaryNodes<dim> &boundary) const
  {
    std::vector<unsigned int> counts(size(), 0);
    for (const auto &face : boundary.passable_faces())
      for (unsigned int fluid = 0; fluid < 2; ++fluid)
        if (const int body = in_cell(face.cell, fluid); body != none)
          ++counts[body];
    dealii::Utilities::MPI::sum(counts,
                                space.mesh().triangulation().get_communicator(),
                                counts);
    return {counts.begin(), counts.end()};
  }



  THALWEG_INSTANTIATE(FluidBodies)
} // namespace Thalweg
