// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/grains.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  template <int dim>
  void
  Grains<dim>::create(const Host<dim> &host_)
  {
    host = std::make_unique<Host<dim>>(host_);
    parameters.initialize();
    GrainSettings settings;
    settings.dim       = dim;
    settings.densities = parameters.materials.densities();
    settings.rolling   = parameters.rolling_model();
    settings.spins     = parameters.has_spin;
    settings.counts    = parameters.counts;
    settings.skin      = parameters.skin;
    system =
      std::make_unique<GrainSystem>(host->context.communicator,
                                    *parameters.law,
                                    settings,
                                    walls,
                                    MeshLocator<dim>::shifts(host->mesh));
    carried = std::make_unique<CarriedGrains<dim>>(*system, host->mesh);
    carried->n_materials = parameters.materials.n();
    view                 = std::make_unique<GrainView>(
      GrainView{*system, parameters.materials, *parameters.law, walls, {}, {}});
  }



  template <int dim>
  void
  Grains<dim>::attach()
  {
    boundary = boundary_facets(host->mesh);
    open     = parameters.open_boundaries(host->mesh);
    parameters.make_walls(host->mesh, boundary, walls, view->wall_names);
    locator = std::make_unique<MeshLocator<dim>>(host->mesh, boundary, open);
    system->set_locator(*locator);
  }



  template <int dim>
  void
  Grains<dim>::initialize()
  {
    walls = WallSet();
    attach();
    system->clear();
    system->counts   = GrainCounts();
    n_sub_steps_made = 0;
    n_insertions.assign(parameters.insertions.all().size(), 0);
    inserted_mass.assign(n_insertions.size(), 0.);
    next_id = n_left = n_lost = n_rebuilds = 0;
    mass_in = mass_left = energy_in = energy_out = 0.;
    contact_work.assign(4, 0.);
    half_of_last.assign(4, 0.);
    insert(0.);
    sums = sum_up(host->context.communicator, *view, gravity(), datum());
  }



  template <int dim>
  void
  Grains<dim>::insert(const double time)
  {
    const double almost  = time + 1e-12 * std::abs(time);
    double       energy  = 0.;
    bool         changes = false;
    for (unsigned int i = 0; i < n_insertions.size(); ++i)
      while (parameters.insertions.all()[i].time_of(n_insertions[i]) <= almost)
        {
          energy += insert_by(i);
          changes = true;
        }
    if (changes)
      energy_in += energy;
  }



  template <int dim>
  double
  Grains<dim>::insert_by(const unsigned int i)
  {
    std::vector<GrainPlace> present;
    for (const std::uint32_t k : system->own())
      present.push_back(system->grains().place[k]);
    const auto         all = parameters.insertions.all()[i].make(host->mesh,
                                                         *locator,
                                                         parameters.materials,
                                                         n_insertions[i],
                                                         inserted_mass[i],
                                                         next_id,
                                                         present,
                                                         walls);
    const unsigned int n_ranks =
      dealii::Utilities::MPI::n_mpi_processes(host->context.communicator);
    const unsigned int rank =
      dealii::Utilities::MPI::this_mpi_process(host->context.communicator);
    std::vector<GrainRecord> own;
    double                   energy = 0.;
    for (const GrainRecord &grain : all)
      {
        energy += energy_of_grain(*system, grain, gravity(), datum());
        const double mass = system->mass(grain.material, grain.r);
        mass_in += mass;
        inserted_mass[i] += mass;
        if (grain.id % n_ranks == rank)
          own.push_back(grain);
        smallest_radius =
          smallest_radius > 0. ? std::min(smallest_radius, grain.r) : grain.r;
      }
    next_id += all.size();
    system->add(own);
    ++n_insertions[i];
    return energy;
  }



  template <int dim>
  void
  Grains<dim>::remove(const double time)
  {
    const auto is_gone = parameters.removal_region(time);
    if (is_gone)
      system->remove(
        [&](const Vec3 &x) { return is_gone->value(as_point<dim>(x)) > 0.; });
  }



  template <int dim>
  double
  Grains<dim>::fastest() const
  {
    double square = 0.;
    for (const std::uint32_t i : system->own())
      square = std::max(square, norm_square(system->grains().momentum[i].v));
    return dealii::Utilities::MPI::max(std::sqrt(square),
                                       host->context.communicator);
  }



  template <int dim>
  unsigned int
  Grains<dim>::n_steps_in(const double time, const double dt) const
  {
    if (smallest_radius == 0.)
      return 1;
    double limit    = parameters.sub_step;
    double of_walls = 0.;
    for (const double part : {0., .25, .5, .75, 1.})
      of_walls = std::max(of_walls, walls.fastest(time + part * dt));
    if (limit == 0.)
      {
        const double g     = norm(as_vec3(host->forces.uniform_acceleration()));
        const double speed = parameters.impact_speed > 0.
                               ? parameters.impact_speed
                               : std::max({2. * fastest(),
                                           fastest() + of_walls,
                                           std::sqrt(4. * g * smallest_radius),
                                           1e-6 * smallest_radius / dt});
        double       mass  = std::numeric_limits<double>::max();
        for (unsigned int m = 0; m < parameters.materials.n(); ++m)
          mass = std::min(mass, system->mass(m, smallest_radius));
        limit = parameters.law->shortest_contact(
                  {smallest_radius, .5 * mass, speed}) /
                parameters.steps_a_contact;
      }
    // Walls do not pass grains in a step.
    if (of_walls > 0.)
      limit = std::min(limit, .2 * smallest_radius / of_walls);
    const double n = std::ceil(dt / limit * (1. - 1e-9));
    AssertThrow(n < 1e9,
                dealii::ExcMessage(
                  "A step of " + std::to_string(dt) +
                  " s would have more than 1e9 sub-steps: take shorter ones "
                  "in 'Time', or softer contacts."));
    return std::max(1u, static_cast<unsigned int>(n));
  }



  template <int dim>
  void
  Grains<dim>::add_body_forces(const double time)
  {
    host->forces.set_time(time);
    system->add_forces([this](const Vec3 &x, const Vec3 &v, const double mass) {
      dealii::Tensor<1, dim> a = host->forces.uniform_acceleration();
      if (host->forces.has_field())
        a += host->forces.field(as_point<dim>(x));
      if (host->forces.is_rotating())
        a -= 2. * (host->forces.spin() * as_point<dim>(v));
      return mass * as_vec3(a);
    });
  }



  template <int dim>
  void
  Grains<dim>::advance(const double time, const double dt)
  {
    dealii::TimerOutput::Scope scope(host->context.timers, "grains");
    host->forces.set_time(time);
    remove(time);
    insert(time);
    const unsigned int                n        = n_steps_in(time, dt);
    const double                      sub_step = dt / n;
    std::function<void(unsigned int)> others;
    if (has_field())
      others = [&](const unsigned int step) {
        add_body_forces(time + (step + 1) * sub_step);
      };
    const GrainCounts before = system->counts;
    system->advance(n, sub_step, gravity(), others, time);
    n_sub_steps_made         = n;
    view->sub_step           = sub_step;
    const GrainCounts &after = system->counts;
    sum_up_work(before, after);
    n_rebuilds += after.n_rebuilds - before.n_rebuilds;
    count_gone();
    sums = sum_up(host->context.communicator, *view, gravity(), datum());
  }



  template <int dim>
  void
  Grains<dim>::sum_up_work(const GrainCounts &before, const GrainCounts &after)
  {
    double work[]{after.work.normal - before.work.normal,
                  after.work.tangential - before.work.tangential,
                  after.work.rolling - before.work.rolling,
                  after.wall_work - before.wall_work,
                  after.last_work.normal,
                  after.last_work.tangential,
                  after.last_work.rolling,
                  after.last_wall_work};
    MPI_Allreduce(
      MPI_IN_PLACE, work, 8, MPI_DOUBLE, MPI_SUM, host->context.communicator);
    for (unsigned int k = 0; k < 4; ++k)
      {
        // The last forces act in this step for half of a sub-step, and in the
        // next step for the other half.
        contact_work[k] += work[k] + half_of_last[k] - .5 * work[4 + k];
        half_of_last[k] = .5 * work[4 + k];
      }
  }



  template <int dim>
  void
  Grains<dim>::count_gone()
  {
    view->gone = system->take_gone();
    double gone[]{0., 0., 0., 0.};
    for (const GoneGrain &one : view->gone)
      {
        gone[one.is_lost ? 1 : 0] += 1.;
        gone[2] += system->mass(one.grain.material, one.grain.r);
        gone[3] += energy_of_grain(*system, one.grain, gravity(), datum());
        if (one.is_lost)
          {
            std::ostringstream message;
            message << "Grain " << one.grain.id << " got lost at ("
                    << one.grain.x.x << ' ' << one.grain.x.y << ' '
                    << one.grain.x.z << ") with " << norm(one.grain.v)
                    << " m/s: it went through a wall. Sub-steps of "
                    << .1 * one.grain.r / (norm(one.grain.v) + 1e-300)
                    << " s would have held it, or a stiffer contact.";
            host->context.log.warning(message.str());
          }
      }
    MPI_Allreduce(
      MPI_IN_PLACE, gone, 4, MPI_DOUBLE, MPI_SUM, host->context.communicator);
    n_left += gone[0];
    n_lost += gone[1];
    mass_left += gone[2];
    energy_out += gone[3];
  }



  template void
  Grains<2>::create(const Host<2> &);
  template void
  Grains<2>::attach();
  template void
  Grains<2>::initialize();
  template void
  Grains<2>::advance(const double, const double);
  template void
  Grains<3>::create(const Host<3> &);
  template void
  Grains<3>::attach();
  template void
  Grains<3>::initialize();
  template void
  Grains<3>::advance(const double, const double);
} // namespace Thalweg
