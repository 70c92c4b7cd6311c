// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_grains_h
#define thalweg_methods_grains_h

#include <thalweg/dem/carried_grains.h>
#include <thalweg/dem/points.h>
#include <thalweg/methods/grain_budget.h>
#include <thalweg/methods/grain_parameters.h>
#include <thalweg/methods/method.h>

#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Dry grains by the discrete element method: contacts are springs and
   * dashpots, and each grain moves by Newton's laws (Eq. 97-115 of seed 000).
   */
  template <int dim>
  class Grains : public Method<dim>
  {
  public:
    void
    declare_parameters(const Section &) override
    {}

    void
    declare_sections(const Section &sections) override
    {
      parameters.declare_parameters(sections);
    }

    void
    check(std::vector<std::string> &faults) const override
    {
      parameters.check(faults);
    }

    void
    check_on_mesh(const Mesh<dim>          &mesh,
                  std::vector<std::string> &faults) const override
    {
      parameters.check_on_mesh(mesh, faults);
    }

    std::vector<std::string>
    warnings(const Mesh<dim> &mesh, const double) const override
    {
      return parameters.own_walls.warnings(dim,
                                           as_vec3(mesh.box().first),
                                           as_vec3(mesh.box().second));
    }

    using Method<dim>::publish;

    void
    publish(const std::string &name, RunOutline<dim> &outline) const override
    {
      outline.offered.add(name, "grains");
    }

    void
    create(const Host<dim> &host) override;

    void
    release() override
    {
      view.reset();
      carried.reset();
      system.reset();
      locator.reset();
    }

    void
    attach() override;

    void
    offer(Ports &ports) const override
    {
      ports.offer<const GrainView>(host->name, "grains", *view);
    }

    void
    initialize() override;

    void
    clear() override
    {
      system->clear();
    }

    void
    keep(const State<dim> &state) override;

    void
    advance(const double time, const double dt) override;

    std::vector<std::string>
    columns() const override;

    void
    record(const double time) override;

    std::string
    size() const override;

    std::string
    headline() const override
    {
      std::ostringstream text;
      text << "grains = " << static_cast<std::uint64_t>(sums.n)
           << ", contacts = " << sums.n_contacts + sums.n_wall_contacts
           << ", overlap/d = " << sums.largest_overlap;
      return text.str();
    }

  private:
    /// Lets grains come in that are due until now.
    void
    insert(const double time);

    /// Lets those of the @p i th insertion come in once more. Collective.
    /// @return their energy, J
    double
    insert_by(const unsigned int i);

    /// Takes out grains in the region of removal. Collective.
    void
    remove(const double time);

    /// Sums up what contacts did in a step. Collective.
    void
    sum_up_work(const GrainCounts &before, const GrainCounts &after);

    /// Takes account of grains that went.
    void
    count_gone();

    /// How many equal sub-steps a step has, in s. Collective.
    unsigned int
    n_steps_in(const double time, const double dt) const;

    /// Names where walls are that move.
    void
    keep_walls(const Archive &values);

    /// The fastest grain, m/s. Collective.
    double
    fastest() const;

    /// Adds what accelerates grains besides gravity.
    void
    add_body_forces(const double time);

    /// Whether accelerations depend on place or time.
    bool
    has_field() const
    {
      return host->forces.has_field() || host->forces.frame().is_active();
    }

    Vec3
    gravity() const
    {
      return has_field() ? Vec3{0., 0., 0.}
                         : as_vec3(host->forces.uniform_acceleration());
    }

    Vec3
    datum() const
    {
      return as_vec3(host->mesh.box().first);
    }

    GrainParameters<dim>                parameters;
    std::unique_ptr<Host<dim>>          host;
    WallSet                             walls;
    std::vector<BoundaryFacet>          boundary;
    std::set<unsigned int>              open;
    std::unique_ptr<GrainSystem>        system;
    std::unique_ptr<MeshLocator<dim>>   locator;
    std::unique_ptr<CarriedGrains<dim>> carried;
    std::unique_ptr<GrainView>          view;
    GrainSums                           sums;
    unsigned int                        n_sub_steps_made = 0;
    /// Of each insertion: how often, and how much, kg.
    std::vector<unsigned int> n_insertions;
    std::vector<double>       inserted_mass;
    double                    smallest_radius = 0.; ///< m
    /// Since the start, on all ranks.
    std::uint64_t next_id = 0, n_left = 0, n_lost = 0, n_rebuilds = 0;
    double        mass_in = 0., mass_left = 0.;    ///< kg
    double        energy_in = 0., energy_out = 0.; ///< J
    /// J, along normals (but what springs have), at right angles, in rolling,
    /// and of walls; and what half of a sub-step adds, which is to come.
    std::vector<double> contact_work = std::vector<double>(4, 0.);
    std::vector<double> half_of_last = std::vector<double>(4, 0.);
  };
} // namespace Thalweg

#endif
