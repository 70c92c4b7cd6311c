// SPDX-License-Identifier: LGPL-2.1-or-later
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
    // Behind the targets the spray, and in the end all that is carried.
    const unsigned int        n = bodies.size();
    std::vector<double>       sums(2 * n + 2, 0.);
    std::vector<unsigned int> spray;
    for (unsigned int c = 0; c < carried.size(); ++c)
      for (unsigned int fluid = 0; fluid < 2; ++fluid)
        if (carried[c][fluid] != 0)
          {
            const int body = bodies.near_cell(c, fluid);
            sums[2 * n + fluid] += carried[c][fluid];
            if (body != FluidBodies<dim>::none)
              sums[body] += carried[c][fluid];
            else if (fluid == 0)
              spray.push_back(c);
          }
    const auto nearest = nearest_bodies(bodies, spray);
    for (unsigned int i = 0; i < spray.size(); ++i)
      if (nearest[i] != FluidBodies<dim>::none)
        sums[n + nearest[i]] += carried[spray[i]][0];
    dealii::Utilities::MPI::sum(sums,
                                space.mesh().triangulation().get_communicator(),
                                sums);
    // What the mesh shows nowhere is on its way to the nearest body.
    targets.resize(n);
    for (unsigned int b = 0; b < n; ++b)
      targets[b] = sums[b] + sums[n + b];
    debts = {{sums[2 * n], sums[2 * n + 1]}};
  }



  template <int dim>
  std::vector<int>
  VolumeCorrection<dim>::nearest_bodies(
    const FluidBodies<dim>          &bodies,
    const std::vector<unsigned int> &cells) const
  {
    const MPI_Comm communicator =
      space.mesh().triangulation().get_communicator();
    const CellGraph<dim> &graph = space.mesh().graph();
    Vector                nearest;
    space.initialize_scalar(nearest);
    const unsigned int n_owned = nearest.locally_owned_size();
    for (unsigned int n = 0; n < n_owned; ++n)
      nearest.local_element(n) = bodies.near_node(n, 0);
    nearest.update_ghost_values();

    std::vector<int> result(cells.size(), FluidBodies<dim>::none);
    const auto       at_cell = [&](const unsigned int cell) {
      double body = FluidBodies<dim>::none;
      for (const unsigned int node : space.nodes(cell))
        body = std::max(body, nearest.local_element(node));
      return body;
    };
    // One more ring of nodes knows in each turn.
    for (bool goes_on = true; goes_on;)
      {
        bool is_missing = false;
        for (unsigned int i = 0; i < cells.size(); ++i)
          if (result[i] == FluidBodies<dim>::none)
            {
              result[i]  = static_cast<int>(at_cell(cells[i]));
              is_missing = is_missing || result[i] == FluidBodies<dim>::none;
            }
        bool has_grown = false;
        if (dealii::Utilities::MPI::logical_or(is_missing, communicator))
          {
            std::vector<double> next(n_owned, FluidBodies<dim>::none);
            for (unsigned int c = 0; c < graph.n_cells(); ++c)
              if (const double body = at_cell(c); body >= 0)
                for (const unsigned int node : space.nodes(c))
                  if (node < n_owned)
                    next[node] = std::max(next[node], body);
            for (unsigned int n = 0; n < n_owned; ++n)
              if (nearest.local_element(n) < 0 && next[n] >= 0)
                {
                  nearest.local_element(n) = next[n];
                  has_grown                = true;
                }
            nearest.update_ghost_values();
          }
        goes_on = dealii::Utilities::MPI::logical_or(has_grown, communicator);
      }
    return result;
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
        const auto [least, most] =
          std::minmax_element(values.begin(), values.end());
        const double measure  = graph.cell(c).measure;
        double       negative = *most <= 0 ? measure : 0.;
        if (*least < 0 && *most > 0)
          negative = negative_volume<dim>(graph.cell(c), values);
        const int water = bodies.near_cell(c, 0), air = bodies.near_cell(c, 1);
        if (water != FluidBodies<dim>::none)
          sums[water] += negative;
        if (air != FluidBodies<dim>::none)
          sums[air] += measure - negative;
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
  VolumeCorrection<dim>::find_active_cells(const FluidBodies<dim> &bodies,
                                           const Vector           &phi,
                                           const double largest_shift)
  {
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
    find_active_cells(bodies, phi, largest_shift);
    body_of_node.assign(space.scalar_layout().locally_owned_size(), -1);
    auto now = volumes(bodies, phi);
    mark_pockets(bodies, now);
    assign_nodes(bodies);

    for (const bool pockets : {true, false})
      {
        auto goals = choose(bodies, pockets);
        if (goals.empty())
          continue;
        reach(goals, bodies, phi, largest_shift);
        now = volumes(bodies, phi);
      }
    largest = 0;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        debts[bodies.fluid(b)] -= now[b];
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
