// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/fields/expression.h>
#include <thalweg/fields/interpolation.h>
#include <thalweg/materials/fluid_values.h>
#include <thalweg/methods/scalar.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Thalweg
{
  namespace
  {
    const std::string conditions_section = "Boundary conditions";
  }



  template <int dim>
  void
  Scalar<dim>::check_on_mesh(const Mesh<dim>          &coarse,
                             std::vector<std::string> &faults) const
  {
    collect_fault(faults, [&]() {
      ScalarConditions<dim>(parameters.conditions, coarse, conditions_section);
    });
  }



  template <int dim>
  void
  Scalar<dim>::check_on_outline(const RunOutline<dim>    &outline,
                                std::vector<std::string> &faults) const
  {
    const Fluids &fluids = outline.flow(parameters.carrier).fluids;
    collect_fault(faults, [&]() {
      read_fluid_values(parameters.diffusivity, fluids, 0., "Diffusivity");
    });
    collect_fault(faults, [&]() {
      read_fluid_values(parameters.capacity,
                        fluids,
                        std::numeric_limits<double>::min(),
                        "Capacity");
    });
    collect_fault(faults, [&]() {
      const auto values =
        read_fluid_values(parameters.latent_heat, fluids, 0., "Latent heat");
      AssertThrow(fluids.size() == 1 || values[0] == 0. || values[1] == 0.,
                  dealii::ExcMessage(
                    "'Latent heat' lets both fluids melt, but only one can: "
                    "write '" +
                    fluids[0].name + ": " + parameters.latent_heat + ", " +
                    fluids[1].name + ": 0', or the other way round."));
    });
  }



  template <int dim>
  void
  Scalar<dim>::create(const Host<dim> &host_)
  {
    host       = std::make_unique<Host<dim>>(host_);
    conditions = std::make_unique<ScalarConditions<dim>>(parameters.conditions,
                                                         host->mesh,
                                                         conditions_section);
    source.reset();
    if (parameters.source != "0")
      source = parse_expression<dim>(parameters.source, 1, "Source");
    particles = &host->ports.template get<ParticleHost<dim>>(
      parameters.carrier,
      "particles",
      who() + ", in 'Methods/Names' behind a flow,");
    const std::string property = host->name.empty() ? "scalar" : host->name;
    heat                       = ParticleHeat();
    heat.value =
      particles->add_property(property,
                              [this](const dealii::types::boundary_id id,
                                     const dealii::Point<dim>        &place,
                                     const double before_end) {
                                return inflow(id, place, before_end);
                              });
    if (parameters.melts())
      heat.molten =
        particles->add_property(property + " molten",
                                [this](const dealii::types::boundary_id id,
                                       const dealii::Point<dim>        &place,
                                       const double before_end) {
                                  const double value =
                                    inflow(id, place, before_end);
                                  return std::isnan(value)
                                           ? value
                                           : melting_point().molten_at(value);
                                });
    population = &particles->population();
  }



  template <int dim>
  void
  Scalar<dim>::release()
  {
    diffusion.reset();
    molten_projection.reset();
    projection.reset();
    view.reset();
    population = nullptr;
    particles  = nullptr;
  }



  template <int dim>
  void
  Scalar<dim>::attach()
  {
    const Medium<dim>    &medium = this->medium();
    const NodeSpace<dim> &space  = medium.space;
    view = std::make_unique<ScalarView<dim>>(ScalarView<dim>{space});
    space.initialize_scalar(view->field);
    for (const auto &[name, id] : host->mesh.boundary_names())
      if (conditions->at(id).kind == ScalarBoundary::value)
        view->given[id] = name;
    projection   = std::make_unique<ScalarProjection<dim>>(space);
    capacity     = read_fluid_values(parameters.capacity,
                                 medium.fluids,
                                 std::numeric_limits<double>::min(),
                                 "Capacity");
    conductivity = read_fluid_values(parameters.diffusivity,
                                     medium.fluids,
                                     0.,
                                     "Diffusivity");
    for (unsigned int f = 0; f < 2; ++f)
      conductivity[f] *= capacity[f];
    latent_heat = read_fluid_values(parameters.latent_heat,
                                    medium.fluids,
                                    0.,
                                    "Latent heat");
    for (unsigned int f = 0; f < 2; ++f)
      {
        heat.laws[f]        = melting_point();
        heat.laws[f].latent = latent_heat[f] / capacity[f];
      }
    diffusion =
      std::make_unique<ScalarDiffusion<dim>>(space,
                                             *conditions,
                                             source.get(),
                                             parameters.tolerance,
                                             heat.laws[heat.melts(0) ? 0 : 1]);
    if (parameters.melts())
      {
        space.initialize_scalar(view->molten);
        molten_projection = std::make_unique<ScalarProjection<dim>>(space);
      }
    view->fluxes = [this](const double time) {
      return diffusion->fluxes(view->field, time);
    };
  }



  template <int dim>
  void
  Scalar<dim>::initialize()
  {
    attach();
    const auto function =
      parse_expression<dim>(parameters.initial, 1, "Initial value");
    const Melting point = melting_point();
    for (const auto &particle : population->particles())
      {
        const auto   row   = particle.properties();
        const double value = function->value(particle.position());
        row[heat.value]    = value;
        if (parameters.melts())
          row[heat.molten] = heat.melts(Population<dim>::fluid_of(row))
                               ? point.molten_at(value)
                               : 0.;
      }
    interpolate_function(view->space, *function, view->field);
    update_operator();
    if (parameters.melts())
      {
        for (unsigned int n = 0; n < view->space.n_owned_nodes(); ++n)
          view->molten.local_element(n) =
            point.molten_at(view->field.local_element(n));
        divide_heat();
      }
    at_start = content();
    through = supplied = with_flow = correction = 0.;
  }



  template <int dim>
  void
  Scalar<dim>::keep(const State<dim> &state)
  {
    const Archive &values = state.values();
    values.value("at start", at_start);
    values.value("through", through);
    values.value("supplied", supplied);
    values.value("with flow", with_flow);
    state.field("field", view->space, view->field, 1);
    if (parameters.melts())
      state.field("molten", view->space, view->molten, 1);
  }



  template <int dim>
  std::vector<std::string>
  Scalar<dim>::columns() const
  {
    std::vector<std::string> names{"content",
                                   "through boundaries",
                                   "supplied",
                                   "with the flow",
                                   "unaccounted",
                                   "correction",
                                   with_unit("least"),
                                   with_unit("greatest"),
                                   with_unit("least on the mesh"),
                                   with_unit("greatest on the mesh"),
                                   "diffusion iterations"};
    if (parameters.melts())
      names.emplace_back("molten part");
    return names;
  }



  template <int dim>
  std::string
  Scalar<dim>::with_unit(const std::string &column) const
  {
    return parameters.unit.empty() ? column
                                   : column + " [" + parameters.unit + "]";
  }



  template <int dim>
  void
  Scalar<dim>::record(const double)
  {
    using dealii::Utilities::MPI::max;
    using dealii::Utilities::MPI::min;
    const MPI_Comm communicator = host->context.communicator;
    double         least        = std::numeric_limits<double>::max();
    double         greatest     = std::numeric_limits<double>::lowest();
    const auto     include      = [&](const double value) {
      least    = std::min(least, value);
      greatest = std::max(greatest, value);
    };
    auto      &statistics = host->context.statistics;
    const auto set        = [&](const std::string &where) {
      statistics.set(with_unit("least" + where), min(least, communicator));
      statistics.set(with_unit("greatest" + where),
                     max(greatest, communicator));
      least    = std::numeric_limits<double>::max();
      greatest = std::numeric_limits<double>::lowest();
    };
    for (const auto &particle : std::as_const(*population).particles())
      include(particle.properties()[heat.value]);
    set("");
    for (unsigned int n = 0; n < view->space.n_owned_nodes(); ++n)
      if (!view->space.is_dependent(n))
        include(view->field.local_element(n));
    set(" on the mesh");

    const double present = content();
    statistics.set("content", present);
    statistics.set("through boundaries", through);
    statistics.set("supplied", supplied);
    statistics.set("with the flow", with_flow);
    statistics.set("unaccounted",
                   present - at_start - through - supplied - with_flow);
    statistics.set("correction", correction);
    statistics.set("diffusion iterations", iterations);
    if (parameters.melts())
      statistics.set("molten part",
                     diffusion->melting().molten_part(view->molten));
  }



  template <int dim>
  std::string
  Scalar<dim>::size() const
  {
    return std::to_string(view->space.scalar().n_dofs()) + " nodes of a scalar";
  }



  template <int dim>
  std::string
  Scalar<dim>::headline() const
  {
    return "diffusion iterations = " + std::to_string(iterations);
  }



  template class Scalar<2>;
  template class Scalar<3>;
  THALWEG_REGISTER(Method,
                   Scalar,
                   "scalar",
                   "temperature, salt and the like: carried by the particles "
                   "of another method, each its own value, diffused on the "
                   "mesh; one of several in `Methods/Names`")
} // namespace Thalweg
