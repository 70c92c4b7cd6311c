#include <thalweg/core/errors.h>
#include <thalweg/fields/expression.h>
#include <thalweg/simulation/simulation_parameters.h>

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
  } // namespace



  template <int dim>
  void
  SimulationParameters<dim>::declare(const Section &root)
  {
    {
      const Section section = root.enter("Method");
      method.declare_parameters(section, "pfem2", "algorithm");
    }
    mesh.declare(root);
    adaptive.declare_parameters(root);
    balance.declare_parameters(root);
    time.declare_parameters(root);
    checkpoint.declare_parameters(root);
    fluids.declare_parameters(root);
    forces.declare_parameters(root);
    {
      const Section section = root.enter("Initial conditions");
      section.add("Velocity",
                  initial_velocity,
                  "m/s",
                  "A function of x, y and z with a semicolon between the "
                  "components.",
                  dealii::Patterns::Anything());
      section.add("Level set",
                  initial_level_set,
                  "m",
                  "A function of x, y and z that is negative in the first "
                  "fluid and positive in the second. It need not be a "
                  "distance: particles that carry one find it.",
                  dealii::Patterns::Anything());
    }
    boundary_conditions.declare(root);
    {
      const Section section = root.enter("Particles");
      seeding.declare_parameters(section);
      convection.declare_parameters(section);
      population.declare_parameters(section);
      section.add("Carry",
                  particles_carry,
                  "",
                  "What tells the fluids apart: the sign of the level set "
                  "(Eq. 69), or the distance from where it vanishes at the "
                  "start, which makes for a smoother interface and keeps the "
                  "volume better; or its value as it is, whatever that means "
                  "(a concentration).",
                  dealii::Patterns::Selection("sign|distance|value"));
      section.add("Distance band",
                  distance_band,
                  "",
                  "At how many times the shortest edge of a particle's cell "
                  "the distance that it carries is cut off before it is "
                  "projected, where the flow has distorted distances: those "
                  "from farther away say nothing about the surface.",
                  dealii::Patterns::Double(0));
    }
    {
      const Section section = root.enter("Projection");
      projection.declare_parameters(section,
                                    "least squares",
                                    "projection from particles to the mesh");
    }
    interface.declare(root);
    {
      const Section section = root.enter("Fluid solver");
      fluid_solver.declare_parameters(section,
                                      "fractional step",
                                      "solver of the flow equations");
    }
    {
      const Section section = root.enter("Postprocess");
      postprocessors.declare_parameters(section, "postprocessors");
    }
  }



  template <int dim>
  void
  SimulationParameters<dim>::check(std::vector<std::string> &faults) const
  {
    const auto collect = [&faults](const auto &test) {
      try
        {
          test();
        }
      catch (const std::exception &exception)
        {
          faults.push_back(message_of(exception));
        }
    };
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
    collect([this]() { population.check(); });
    collect([this]() { balance.check(); });
    collect([this]() { mesh.partition->check(); });
    collect([this]() { check_change(); });
    collect([this]() {
      parse_expression<dim>(mesh.local_refinement,
                            1,
                            "Refinement/Local levels");
    });
    Mesh<dim> coarse(MPI_COMM_SELF);
    bool      has_mesh = false;
    collect([&]() {
      coarse.create_coarse(mesh);
      coarse.update();
      has_mesh = true;
    });
    if (!has_mesh)
      return;
    if (has_forces)
      collect([&]() { check_turning(coarse); });
    collect([&]() {
      const BoundaryConditions<dim> conditions(boundary_conditions, coarse);
      for (const auto &[id, condition] : conditions.all())
        if (!condition.inflow_fluid.empty())
          fluids.index(condition.inflow_fluid);
    });
    const RunOutline<dim> outline{coarse, fluids, has_flat_cells(coarse)};
    collect([&]() { adaptive.check(outline); });
    for (const Postprocessor<dim> *postprocessor : postprocessors.chosen())
      collect([&]() { postprocessor->check(outline); });
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
