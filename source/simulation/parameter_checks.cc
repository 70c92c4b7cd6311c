// SPDX-License-Identifier: LGPL-2.1-or-later
// What is wrong with parameters before a run.
#include <thalweg/core/errors.h>
#include <thalweg/fields/expression.h>
#include <thalweg/fields/flux_balance.h>
#include <thalweg/mesh/cell_count.h>
#include <thalweg/mesh/touching_boundaries.h>
#include <thalweg/simulation/missing_fluid.h>
#include <thalweg/simulation/simulation_parameters.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace Thalweg
{
  namespace
  {
    /// Whether refinement leaves the domain as it is.
    template <int dim>
    bool
    has_flat_cells(const Mesh<dim> &mesh)
    {
      const auto manifolds = mesh.triangulation().get_manifold_ids();
      return std::all_of(manifolds.begin(), manifolds.end(), [](const auto id) {
        return id == dealii::numbers::flat_manifold_id;
      });
    }


    /// Makes exceptions of tests to faults.
    struct Collector
    {
      std::vector<std::string> &faults;

      template <typename Test>
      void
      operator()(const Test &test) const
      {
        try
          {
            test();
          }
        catch (const std::exception &exception)
          {
            faults.push_back(message_of(exception));
          }
      }
    };



    /// Whether parse_expression() has no objection, which is collected
    /// elsewhere.
    template <int dim>
    bool
    is_understood(const std::string &text, const unsigned int n_components)
    {
      try
        {
          parse_expression<dim>(text, n_components, "");
          return true;
        }
      catch (const dealii::ExceptionBase &)
        {
          return false;
        }
    }



    /// Lets a function refuse what it is at the vertices.
    template <int dim>
    void
    evaluate_at_vertices(const dealii::Function<dim> &function,
                         const Mesh<dim>             &mesh)
    {
      dealii::Vector<double> value(function.n_components);
      for (unsigned int c = 0; c < mesh.graph().n_owned_cells(); ++c)
        for (const auto &vertex : mesh.graph().cell(c).vertices)
          function.vector_value(vertex, value);
    }



    /// Lets the functions of boundaries refuse what they are at vertices there.
    template <int dim>
    void
    evaluate_at_boundaries(const BoundaryConditions<dim> &conditions,
                           const Mesh<dim>               &mesh)
    {
      dealii::Vector<double> value;
      const CellGraph<dim>  &graph = mesh.graph();
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        for (unsigned int f = 0; f < graph.n_faces; ++f)
          if (graph.at_boundary(c, f))
            {
              const auto  face = graph.iterator(c)->face(f);
              const auto &function =
                conditions.at(face->boundary_id()).function;
              if (function == nullptr)
                continue;
              value.reinit(function->n_components);
              for (const unsigned int v : face->vertex_indices())
                function->vector_value(face->vertex(v), value);
            }
    }
  } // namespace



  template <int dim>
  void
  SimulationParameters<dim>::check(std::vector<std::string> &faults,
                                   const MPI_Comm            communicator) const
  {
    const Collector collect{faults};
    collect([this]() { fluids.check(); });
    collect([this]() { time.check(); });
    collect([this]() {
      parse_expression<dim>(initial_velocity,
                            dim,
                            "Initial conditions/Velocity");
    });
    collect([this]() {
      parse_expression<dim>(initial_level_set,
                            1,
                            "Initial conditions/Level set");
    });
    bool has_forces = false;
    collect([&]() {
      forces.check(time.end_time());
      has_forces = true;
    });
    collect([this]() { method->check(); });
    collect([this]() {
      AssertThrow(!energy_budget ||
                    (fluids.size() == 2 && method->has_energy_budget()),
                  dealii::ExcMessage(
                    "'Statistics/Energy budget' is for two fluids and the "
                    "method 'pfem2'. Leave it out, or choose those."));
    });
    collect([this]() { population.check(); });
    collect([this]() { balance.check(); });
    collect([this]() { mesh.partition->check(); });
    collect([this]() { check_change(); });
    collect([this]() { check_distance_band(); });
    collect([this]() {
      parse_expression<dim>(mesh.local_refinement,
                            1,
                            "Refinement/Local levels");
    });
    const MemoryEstimate estimate = memory(communicator);
    Mesh<dim>            coarse(MPI_COMM_SELF);
    bool                 has_mesh = false;
    collect([&]() {
      estimate.check(
        mesh.geometry->n_cells() *
        std::pow(2., dim * static_cast<double>(mesh.global_refinement)));
      make_coarse(coarse);
      has_mesh = true;
    });
    if (!has_mesh)
      return;
    if (has_forces)
      collect([&]() { check_turning(coarse); });
    collect([&]() { check_size(coarse, estimate); });
    check_on_mesh(coarse, faults);
  }



  template <int dim>
  void
  SimulationParameters<dim>::make_coarse(Mesh<dim> &coarse) const
  {
    try
      {
        coarse.create_coarse(mesh);
        coarse.update();
      }
    catch (const dealii::ExcMessage &)
      {
        throw;
      }
    catch (const std::exception &exception)
      {
        throw dealii::ExcMessage(
          "The mesh of 'Geometry/Model = " + mesh.geometry.model_name() +
          "' cannot be made: " + message_of(exception));
      }
  }



  template <int dim>
  MemoryEstimate
  SimulationParameters<dim>::memory(const MPI_Comm communicator) const
  {
    return {communicator,
            dim,
            std::pow(seeding.particles_per_direction, dim),
            mesh.memory_limit};
  }



  template <int dim>
  void
  SimulationParameters<dim>::check_size(const Mesh<dim>      &coarse,
                                        const MemoryEstimate &memory) const
  {
    if (is_understood<dim>(mesh.local_refinement, 1))
      memory.check(
        count_cells(coarse.triangulation(),
                    mesh.global_refinement,
                    *parse_expression<dim>(mesh.local_refinement,
                                           1,
                                           "Refinement/Local levels"),
                    mesh.local_refinement.find_first_of("xyz") ==
                      std::string::npos,
                    1.1 * memory.most_cells()));
  }



  template <int dim>
  void
  SimulationParameters<dim>::check_on_mesh(
    const Mesh<dim>          &coarse,
    std::vector<std::string> &faults) const
  {
    const Collector collect{faults};
    collect([&]() {
      BoundaryConditions<dim> conditions(boundary_conditions, coarse);
      for (const auto &[id, condition] : conditions.all())
        if (!condition.inflow_fluid.empty())
          fluids.index(condition.inflow_fluid);
      evaluate_at_boundaries(conditions, coarse);
      if (method->computes_flow())
        Thalweg::check_flux_balance(conditions, coarse, 0.);
    });
    for (const auto &[text, n_components, where] :
         {std::make_tuple(initial_velocity, dim, "Velocity"),
          std::make_tuple(initial_level_set, 1, "Level set")})
      collect([&, text = text, n = n_components, where = where]() {
        if (is_understood<dim>(text, n))
          evaluate_at_vertices(
            *parse_expression<dim>(text,
                                   n,
                                   std::string("Initial conditions/") + where),
            coarse);
      });
    const RunOutline<dim> outline{coarse,
                                  fluids,
                                  has_flat_cells(coarse),
                                  has_spray()};
    collect([&]() { adaptive.check(outline); });
    for (std::size_t i = 0; i < postprocessors.chosen().size(); ++i)
      {
        std::vector<std::string> own;
        Collector{own}([&]() { postprocessors.chosen()[i]->check(outline); });
        for (const std::string &fault : own)
          faults.push_back(fault.find("'Postprocess/") == std::string::npos
                             ? "In 'Postprocess/" +
                                 postprocessors.chosen_names()[i] +
                                 "': " + fault
                             : fault);
      }
  }



  template <int dim>
  std::vector<std::string>
  SimulationParameters<dim>::warnings(const bool before_run) const
  {
    Mesh<dim> coarse(MPI_COMM_SELF);
    coarse.create_coarse(mesh);
    coarse.update();
    std::vector<std::string> texts{
      touching_boundaries(coarse.triangulation(), coarse.boundary_names())};
    if (before_run && fluids.size() == 2 && method->computes_flow())
      {
        const double per_cell =
          std::pow(seeding.particles_per_direction, dim) *
          std::pow(2., dim * static_cast<double>(mesh.global_refinement));
        texts.push_back(missing_fluid<dim>(
          coarse,
          fluids,
          *parse_expression<dim>(initial_level_set,
                                 1,
                                 "Initial conditions/Level set"),
          per_cell * coarse.graph().n_owned_cells()));
      }
    texts.erase(std::remove(texts.begin(), texts.end(), ""), texts.end());
    return texts;
  }



  template <int dim>
  void
  SimulationParameters<dim>::check_distance_band() const
  {
    AssertThrow(fluids.size() == 1 || particles_carry == "sign" ||
                  distance_band > 0.,
                dealii::ExcMessage(
                  "'Particles/Distance band' is 0, but the particles carry "
                  "the distance from the interface up to there, and would "
                  "carry 0 and no fluid. Make it 1 or more, or set "
                  "'Particles/Carry = sign'."));
  }



  template <int dim>
  void
  SimulationParameters<dim>::check_change() const
  {
    AssertThrow(mesh.partition->can_change() || !adaptive.is_active(),
                dealii::ExcMessage(
                  "'Refinement/Adaptive/Criteria' is not empty, but meshes "
                  "with 'Partition/Model = " +
                  mesh.partition.model_name() +
                  "' do not change during the run. Use 'Partition/Model = "
                  "p4est', or refine beforehand by 'Refinement/Global levels' "
                  "and 'Local levels'."));
  }



  template <int dim>
  void
  SimulationParameters<dim>::check_turning(const Mesh<dim> &coarse) const
  {
    MovingFrame<dim> frame = forces.frame();
    frame.initialize(time.end_time());
    for (const PeriodicPair &pair : coarse.periodic_pairs())
      AssertThrow(frame.keeps_direction(pair.direction),
                  dealii::ExcMessage(
                    "With 'Moving frame' the tank turns, and what accelerates "
                    "fluids there differs between boundaries of 'Geometry/"
                    "Periodic boundaries': only those along the axis can be "
                    "periodic."));
  }



  template struct SimulationParameters<2>;
  template struct SimulationParameters<3>;
} // namespace Thalweg
