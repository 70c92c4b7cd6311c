// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/compat.h>
#include <thalweg/simulation/finite_state.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    /// @param what is no finite number, with its place
    template <int dim>
    [[noreturn]] void
    refuse(const FlowView<dim> &solution, const std::string &what)
    {
      std::ostringstream message;
      message.precision(10);
      message << (solution.step == 0 ? "At the start (t = " : "After step ")
              << (solution.step == 0 ? "" : std::to_string(solution.step))
              << (solution.step == 0 ? "" : " (t = ") << solution.time << " s) "
              << what
              << ". The run stops, since nothing that follows would mean "
                 "anything. Look at the input near this place, at units and at "
                 "boundary conditions, and try a smaller 'Time/Courant "
                 "number'.";
      throw dealii::ExcMessage(message.str());
    }



    bool
    is_finite(const Vector &vector)
    {
      return std::all_of(vector.begin(), vector.end(), [](const double value) {
        return std::isfinite(value);
      });
    }



    /// A field at the vertices, of one or of dim components.
    template <int dim>
    void
    check_nodes(const FlowView<dim> &solution,
                const Vector        &field,
                const std::string   &name)
    {
      if (is_finite(field))
        return;
      const auto        &layout = solution.space.scalar_layout();
      const unsigned int n_components =
        field.locally_owned_size() / layout.locally_owned_size();
      for (unsigned int i = 0; i < field.locally_owned_size(); ++i)
        if (!std::isfinite(field.local_element(i)))
          {
            std::ostringstream what;
            what.precision(10);
            what << "the " << name << " at ("
                 << solution.space.position(i / n_components) << ") is "
                 << field.local_element(i);
            refuse(solution, what.str());
          }
    }



    /// A field in a space of the flow's own.
    template <int dim>
    void
    check_dofs(const FlowView<dim>           &solution,
               const dealii::DoFHandler<dim> &dofs,
               const Vector                  &field,
               const std::string             &name)
    {
      if (is_finite(field))
        return;
      dealii::Vector<double> values(dofs.get_fe().dofs_per_cell);
      const auto            &graph = solution.mesh.graph();
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        {
          Compat::on_dof_handler(graph.iterator(c), dofs)
            ->get_dof_values(field, values);
          for (const double value : values)
            if (!std::isfinite(value))
              {
                std::ostringstream what;
                what.precision(10);
                what << "the " << name << " in the cell around ("
                     << graph.iterator(c)->center() << ") is " << value;
                refuse(solution, what.str());
              }
        }
    }



    std::string
    property_name(const unsigned int              property,
                  const unsigned int              dim,
                  const std::vector<std::string> &added)
    {
      if (property >= dim + 3)
        return added[property - dim - 3];
      if (property < dim)
        return std::string("velocity in ") + "xyz"[property];
      return property == dim       ? "level set"
             : property == dim + 1 ? "volume"
                                   : "fluid";
    }



    template <int dim>
    void
    check_particles(const FlowView<dim>   &solution,
                    const Population<dim> &population)
    {
      for (const auto &particle : population.particles())
        {
          const auto    properties = particle.properties();
          const double *bad        = std::find_if(properties.begin(),
                                           properties.end(),
                                           [](const double value) {
                                             return !std::isfinite(value);
                                           });
          if (bad == properties.end())
            continue;
          std::ostringstream what;
          what.precision(10);
          what << "particle " << particle.id() << " at (" << particle.position()
               << ") carries a "
               << property_name(bad - properties.begin(),
                                dim,
                                population.added_properties())
               << " that is " << *bad;
          refuse(solution, what.str());
        }
    }



    template <int dim>
    void
    check_flow(const FlowView<dim> &solution)
    {
      check_nodes(solution, solution.velocity, "velocity");
      check_nodes(solution, solution.pressure, "pressure");
      if (solution.fluids.size() == 2)
        check_nodes(solution, solution.level_set, "level set");
      if (solution.flow != nullptr)
        {
          check_dofs(solution,
                     solution.flow->velocity_dofs,
                     solution.flow->velocity,
                     "velocity");
          check_dofs(solution,
                     solution.flow->pressure_dofs,
                     solution.flow->pressure,
                     "pressure");
        }
      check_particles(solution, solution.population);
      if (solution.dispersed != nullptr)
        check_particles(solution, *solution.dispersed);
    }
  } // namespace



  template <int dim>
  void
  check_finite(const SolutionView<dim> &solution)
  {
    for (const auto &[name, flow] : solution.flows)
      check_flow(flow);
  }



  template void
  check_finite(const SolutionView<2> &);
  template void
  check_finite(const SolutionView<3> &);
} // namespace Thalweg
