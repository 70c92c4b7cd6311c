// SPDX-License-Identifier: LGPL-2.1-or-later
// What grains keep, and what is said of them.
#include <thalweg/methods/grains.h>

namespace Thalweg
{
  template <int dim>
  void
  Grains<dim>::keep(const State<dim> &state)
  {
    const Archive &values = state.values();
    std::string law = parameters.law.model_name() + ", " + parameters.rolling;
    for (const std::string &name : parameters.materials.names())
      law += ", " + name;
    if (!parameters.own_walls.list().empty())
      law += "; " + parameters.own_walls.list();
    if (!parameters.insertions.names().empty())
      law += "; " + parameters.insertions.names();
    const std::string present = law;
    values.value("law, materials and walls", law);
    AssertThrow(law == present,
                dealii::ExcMessage("it is of grains with other laws, "
                                   "materials or walls: '" +
                                   law + "' instead of '" + present + "'."));
    values.value("insertions", n_insertions);
    values.value("inserted mass", inserted_mass);
    values.value("next id", next_id);
    values.value("smallest radius", smallest_radius);
    values.value("travelled", system->travelled);
    values.value("left", n_left);
    values.value("lost", n_lost);
    values.value("mass in", mass_in);
    values.value("mass left", mass_left);
    values.value("rebuilds", n_rebuilds);
    values.value("energy in", energy_in);
    values.value("energy out", energy_out);
    values.value("contact work", contact_work);
    values.value("half of the last work", half_of_last);
    keep_walls(values);
    state.carry("grains", *carried);
  }



  template <int dim>
  void
  Grains<dim>::keep_walls(const Archive &values)
  {
    values.value("time of walls", walls.time);
    for (std::size_t w = 0; w < walls.moving.size(); ++w)
      for (const bool is_now : {true, false})
        {
          WallPose &pose =
            is_now ? walls.moving[w].now : walls.moving[w].reference;
          std::vector<double> numbers{pose.shift.x,
                                      pose.shift.y,
                                      pose.shift.z,
                                      pose.angle};
          values.value((is_now ? "wall " : "reference of wall ") +
                         std::to_string(w),
                       numbers);
          pose = {{numbers.at(0), numbers.at(1), numbers.at(2)}, numbers.at(3)};
        }
    if (values.is_restoring())
      walls.set_velocities(walls.time);
  }



  template <int dim>
  std::vector<std::string>
  Grains<dim>::columns() const
  {
    return {"grains",
            "grains left",
            "grains lost",
            "mass in [kg]",
            "mass left [kg]",
            "sub-steps",
            "translational energy [J]",
            "rotational energy [J]",
            "potential energy [J]",
            "elastic energy [J]",
            "dissipated along normals [J]",
            "dissipated by friction [J]",
            "dissipated by rolling [J]",
            "work of walls [J]",
            "missing energy [J]",
            "largest overlap over diameter",
            "contacts a grain",
            "rebuilds of lists",
            "fastest grain [m/s]"};
  }



  template <int dim>
  void
  Grains<dim>::record(const double)
  {
    auto        &statistics  = host->context.statistics;
    const double elastic     = sums.elastic + sums.sheared + sums.rolled;
    const double lost_normal = contact_work[0];
    const double friction    = contact_work[1] - sums.sheared;
    const double rolling     = contact_work[2] - sums.rolled;
    const double wall_work   = contact_work[3];
    statistics.set("grains", sums.n);
    statistics.set("grains left", n_left);
    statistics.set("grains lost", n_lost);
    statistics.set("mass in [kg]", mass_in);
    statistics.set("mass left [kg]", mass_left);
    statistics.set("sub-steps", n_sub_steps_made);
    statistics.set("translational energy [J]", sums.translation);
    statistics.set("rotational energy [J]", sums.rotation);
    statistics.set("potential energy [J]", sums.potential);
    statistics.set("elastic energy [J]", elastic);
    statistics.set("dissipated along normals [J]", lost_normal);
    statistics.set("dissipated by friction [J]", friction);
    statistics.set("dissipated by rolling [J]", rolling);
    statistics.set("work of walls [J]", wall_work);
    statistics.set("missing energy [J]",
                   parameters.counts
                     ? energy_in + wall_work - energy_out - sums.translation -
                         sums.rotation - sums.potential - elastic -
                         lost_normal - friction - rolling
                     : 0.);
    statistics.set("largest overlap over diameter", sums.largest_overlap);
    statistics.set("contacts a grain",
                   sums.n > 0.
                     ? (2. * sums.n_contacts + sums.n_wall_contacts) / sums.n
                     : 0.);
    statistics.set("rebuilds of lists", n_rebuilds);
    statistics.set("fastest grain [m/s]", sums.fastest);
    const double momentum[]{sums.momentum.x, sums.momentum.y, sums.momentum.z};
    const double center[]{sums.center.x, sums.center.y, sums.center.z};
    for (unsigned int d = 0; d < dim; ++d)
      {
        const std::string axis(1, "xyz"[d]);
        statistics.set("momentum " + axis + " [kg m/s]", momentum[d]);
        statistics.set("center of mass " + axis + " [m]",
                       host->mesh.box().first[d] +
                         (sums.mass > 0. ? center[d] / sums.mass : 0.));
      }
  }



  template <int dim>
  std::string
  Grains<dim>::size() const
  {
    return std::to_string(static_cast<std::uint64_t>(
             dealii::Utilities::MPI::sum(double(system->n_own()),
                                         host->context.communicator))) +
           " grains, " + std::to_string(walls.facets.size()) +
           " facets of walls";
  }



  THALWEG_REGISTER(Method,
                   Grains,
                   "grains",
                   "dry grains by the discrete element method, with contacts "
                   "that are springs, dashpots and friction")
} // namespace Thalweg
