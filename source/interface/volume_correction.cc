#include <thalweg/core/registry.h>
#include <thalweg/interface/cut_cell.h>
#include <thalweg/interface/volume_correction.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    template <int dim>
    std::array<double, (1 << dim)>
    in_cell(const NodeSpace<dim> &space,
            const unsigned int    cell,
            const Vector         &phi)
    {
      std::array<double, (1 << dim)> values;
      for (unsigned int v = 0; v < values.size(); ++v)
        values[v] = phi.local_element(space.nodes(cell)[v]);
      return values;
    }
  } // namespace



  template <int dim>
  VolumeCorrection<dim>::VolumeCorrection(const NodeSpace<dim>     &space,
                                          const BoundaryNodes<dim> &boundary)
    : space(space)
    , boundary(boundary)
  {
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      tolerance += 1e-13 * graph.cell(c).measure;
    tolerance = dealii::Utilities::MPI::sum(
      tolerance, space.mesh().triangulation().get_communicator());
    space.initialize_scalar(field);
  }



  template <int dim>
  void
  VolumeCorrection<dim>::find_targets(const FluidBodies<dim> &bodies,
                                      const Carried          &carried)
  {
    // Behind the bodies' volumes those of both fluids that no body is near.
    targets.assign(bodies.size() + 2, 0.);
    for (unsigned int c = 0; c < carried.size(); ++c)
      for (unsigned int fluid = 0; fluid < 2; ++fluid)
        if (carried[c][fluid] != 0)
          {
            const int body = bodies.near_cell(c, fluid);
            targets[body == FluidBodies<dim>::none ? bodies.size() + fluid
                                                   : body] += carried[c][fluid];
          }
    dealii::Utilities::MPI::sum(targets,
                                space.mesh().triangulation().get_communicator(),
                                targets);
    for (unsigned int fluid = 0; fluid < 2; ++fluid)
      debts[fluid] = targets[bodies.size() + fluid];
    targets.resize(bodies.size());
  }



  template <int dim>
  void
  VolumeCorrection<dim>::assign_nodes(const FluidBodies<dim> &bodies)
  {
    const unsigned int n_owned = space.scalar_layout().locally_owned_size();
    body_of_node.assign(n_owned, FluidBodies<dim>::none);
    // Two rings of nodes around each body: the interface may come into the
    // second cell.
    Vector second;
    space.initialize_scalar(second);
    second = -1.;
    for (unsigned int n = 0; n < n_owned; ++n)
      {
        const int water = bodies.near_node(n, 0), air = bodies.near_node(n, 1);
        body_of_node[n] =
          air != FluidBodies<dim>::none && is_pocket[air] ? air : water;
        second.local_element(n) = body_of_node[n];
      }
    second.update_ghost_values();
    for (unsigned int c = 0; c < space.mesh().graph().n_cells(); ++c)
      {
        double nearest = -1.;
        for (const unsigned int node : space.nodes(c))
          nearest = std::max(nearest, second.local_element(node));
        for (const unsigned int node : space.nodes(c))
          if (node < n_owned && body_of_node[node] == FluidBodies<dim>::none)
            body_of_node[node] = static_cast<int>(nearest);
      }
  }



  template <int dim>
  std::vector<typename VolumeCorrection<dim>::Goal>
  VolumeCorrection<dim>::choose(const FluidBodies<dim> &bodies,
                                const bool              pockets) const
  {
    std::vector<Goal> goals;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      if (pockets ? is_pocket[b] : bodies.fluid(b) == 0)
        {
          Goal goal;
          goal.body   = b;
          goal.target = targets[b];
          goals.push_back(goal);
        }
    return goals;
  }



  template <int dim>
  std::vector<double>
  VolumeCorrection<dim>::volumes(const FluidBodies<dim> &bodies,
                                 const Vector           &phi)
  {
    field.zero_out_ghost_values();
    for (unsigned int n = 0; n < body_of_node.size(); ++n)
      field.local_element(n) = body_of_node[n] == FluidBodies<dim>::none
                                 ? 0.
                                 : shifts[body_of_node[n]];
    space.interpolate(field, 1);

    std::vector<double>   sums(bodies.size(), 0.);
    const CellGraph<dim> &graph = space.mesh().graph();
    for (const unsigned int c : active_cells)
      {
        auto       values = in_cell(space, c, phi);
        const auto shift  = in_cell(space, c, field);
        for (unsigned int v = 0; v < values.size(); ++v)
          values[v] += shift[v];
        const double negative = negative_volume<dim>(graph.cell(c), values);
        const int water = bodies.near_cell(c, 0), air = bodies.near_cell(c, 1);
        if (water != FluidBodies<dim>::none)
          sums[water] += negative;
        if (air != FluidBodies<dim>::none)
          sums[air] += graph.cell(c).measure - negative;
      }
    for (unsigned int b = 0; b < sums.size(); ++b)
      sums[b] += passive_volumes[b];
    dealii::Utilities::MPI::sum(sums,
                                space.mesh().triangulation().get_communicator(),
                                sums);
    return sums;
  }



  template <int dim>
  void
  VolumeCorrection<dim>::reach(std::vector<Goal>      &goals,
                               const FluidBodies<dim> &bodies,
                               const Vector           &phi,
                               const double            largest_shift)
  {
    constexpr unsigned int most_iterations = 60;
    // Water becomes less, air more, as the level set rises.
    const auto excess = [&](const Goal &goal, const std::vector<double> &v) {
      const double difference = v[goal.body] - goal.target;
      return bodies.fluid(goal.body) == 0 ? difference : -difference;
    };
    const auto start = volumes(bodies, phi);
    for (Goal &goal : goals)
      {
        const double f = excess(goal, start);
        goal.is_done   = std::abs(f) <= tolerance;
        if (goal.is_done)
          continue;
        goal.shift                            = std::copysign(largest_shift, f);
        (f > 0 ? goal.f_above : goal.f_below) = f;
        shifts[goal.body]                     = goal.shift;
      }
    const auto is_done = [](const Goal &goal) { return goal.is_done; };
    for (unsigned int i = 0; i < most_iterations &&
                             !std::all_of(goals.begin(), goals.end(), is_done);
         ++i)
      {
        const auto now = volumes(bodies, phi);
        for (Goal &goal : goals)
          {
            if (goal.is_done)
              continue;
            const double f = excess(goal, now);
            // The first try is the bound: if it is not enough it remains.
            const bool falls_short = i == 0 && (goal.shift > 0 ? f > 0 : f < 0);
            // A body that fills its cells has no interface to be moved.
            if (falls_short &&
                std::abs(f - goal.f_above - goal.f_below) <= tolerance)
              shifts[goal.body] = 0.;
            if (std::abs(f) <= tolerance || falls_short)
              {
                goal.is_done = true;
                continue;
              }
            double &end     = f > 0 ? goal.above : goal.below;
            double &f_end   = f > 0 ? goal.f_above : goal.f_below;
            double &f_other = f > 0 ? goal.f_below : goal.f_above;
            // Regula falsi with the Illinois modification.
            if (i > 0 && goal.last_was_above == (f > 0))
              f_other *= .5;
            goal.last_was_above = f > 0;
            end                 = goal.shift;
            f_end               = f;
            goal.shift =
              (goal.below * goal.f_above - goal.above * goal.f_below) /
              (goal.f_above - goal.f_below);
            goal.is_done =
              std::abs(goal.above - goal.below) <= 1e-15 * largest_shift;
            shifts[goal.body] = goal.shift;
          }
      }
  }



  template <int dim>
  void
  VolumeCorrection<dim>::apply(Vector        &phi,
                               const Carried &carried,
                               const double   largest_shift)
  {
    const FluidBodies<dim> bodies(space, phi);
    find_targets(bodies, carried);
    shifts.assign(bodies.size(), 0.);
    is_pocket.assign(bodies.size(), false);
    counts = {};
    for (unsigned int b = 0; b < bodies.size(); ++b)
      ++counts[bodies.fluid(b)];
    passive_volumes.assign(bodies.size(), 0.);

    active_cells.clear();
    const CellGraph<dim> &graph = space.mesh().graph();
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const auto values = in_cell(space, c, phi);
        if (std::any_of(values.begin(),
                        values.end(),
                        [&](const double value) {
                          return std::abs(value) <= largest_shift;
                        }) ||
            (bodies.in_cell(c, 0) >= 0 && bodies.in_cell(c, 1) >= 0))
          active_cells.push_back(c);
        else
          for (unsigned int fluid = 0; fluid < 2; ++fluid)
            if (const int body = bodies.in_cell(c, fluid); body >= 0)
              passive_volumes[body] += graph.cell(c).measure;
      }
    body_of_node.assign(space.scalar_layout().locally_owned_size(), -1);
    const auto before = volumes(bodies, phi);
    mark_pockets(bodies, before);
    assign_nodes(bodies);

    for (const bool pockets : {true, false})
      {
        auto goals = choose(bodies, pockets);
        reach(goals, bodies, phi, largest_shift);
      }
    const auto after = volumes(bodies, phi);
    largest          = 0;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        debts[bodies.fluid(b)] += targets[b] - after[b];
        if (std::abs(shifts[b]) > std::abs(largest))
          largest = shifts[b];
      }
    if (largest != 0)
      {
        phi.zero_out_ghost_values();
        for (unsigned int n = 0; n < body_of_node.size(); ++n)
          phi.local_element(n) += field.local_element(n);
        space.interpolate(phi, 1);
      }
  }



  template <int dim>
  void
  VolumeCorrection<dim>::mark_pockets(const FluidBodies<dim>    &bodies,
                                      const std::vector<double> &volumes)
  {
    // Where no air can go out, the largest body of it gives way to the others.
    const auto open   = bodies.open(boundary);
    bool       is_any = false;
    int        most   = FluidBodies<dim>::none;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      if (bodies.fluid(b) == 1)
        {
          is_any = is_any || open[b];
          if (most == FluidBodies<dim>::none || volumes[b] > volumes[most])
            most = b;
        }
    for (unsigned int b = 0; b < bodies.size(); ++b)
      is_pocket[b] = bodies.fluid(b) == 1 && !open[b] &&
                     (is_any || static_cast<int>(b) != most);
  }



  THALWEG_INSTANTIATE(VolumeCorrection)
} // namespace Thalweg
