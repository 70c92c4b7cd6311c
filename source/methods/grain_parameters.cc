// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/plain_text.h>
#include <thalweg/core/spelling.h>
#include <thalweg/fields/expression.h>
#include <thalweg/mesh/boundary_name.h>
#include <thalweg/methods/grain_parameters.h>

#include <deal.II/base/utilities.h>

#include <cmath>

namespace Thalweg
{
  template <int dim>
  void
  GrainParameters<dim>::declare_parameters(const Section &sections)
  {
    using namespace dealii::Patterns;
    materials.declare_parameters(sections.enter("Materials"));
    const Section contact = sections.enter("Contact");
    law.declare_parameters(contact, "linear", "law of contact");
    contact.add("Rolling",
                rolling,
                "",
                "What resists rolling: `none`; `constant torque`: rolling "
                "friction times normal force times effective radius; `epsd`: "
                "an elastic-plastic spring up to that torque, which holds "
                "slopes.",
                Selection("none|constant torque|epsd"));
    contact.add("Spin",
                has_spin,
                "",
                "Whether grains turn; those that stand for much smaller ones "
                "may not.",
                Bool());
    contact.add("Sub-step",
                sub_step,
                "s",
                "Steps are divided into equal ones of at most this size; 0: "
                "as the shortest contact says.",
                Double(0));
    contact.add("Steps a contact",
                steps_a_contact,
                "",
                "How many sub-steps the shortest contact has, where no "
                "'Sub-step' is given.",
                Double(std::numeric_limits<double>::min()));
    contact.add(
      "Impact speed",
      impact_speed,
      "m/s",
      "Of the fastest impact, on which the duration of contacts "
      "depends with some laws; 0: twice that of the fastest grain, or "
      "what it gets by falling its diameter.",
      Double(0));
    contact.add("Skin",
                skin,
                "",
                "Pairs that are less than this part of the smallest radius "
                "apart are in the lists, which are made anew when grains have "
                "moved half of it. It has no influence on results.",
                Double(std::numeric_limits<double>::min()));
    contact.add("Energy budget",
                counts,
                "",
                "Whether what contacts do to the energy is summed up; costs a "
                "twentieth of the time.",
                Bool());
    insertions.declare_parameters(sections.enter("Insertion"));
    sections.enter("Removal").add(
      "Region",
      removal,
      "",
      "Grains whose centers are where this function of x, y, z and t is "
      "positive are taken out at the beginning of each step, and counted with "
      "those that left; nothing: none are.",
      Anything());
    declare_walls(sections.enter("Walls"));
  }



  template <int dim>
  void
  GrainParameters<dim>::declare_walls(const Section &walls)
  {
    using dealii::Patterns::Anything;
    walls.add("Material",
              wall_material,
              "",
              "What walls are made of, one of `Materials/Names`; nothing: the "
              "first.",
              Anything());
    walls.add("Open",
              open,
              "",
              "The names of boundaries that grains leave through; the others "
              "are walls, except for periodic ones.");
    walls.add("Planes",
              planes,
              "",
              "More walls: a point and, behind a colon, the direction of the "
              "grains, `0, 0, 0.1: 0, 0, 1 | ...`.",
              Anything());
    own_walls.declare_parameters(walls);
  }



  template <int dim>
  void
  GrainParameters<dim>::initialize()
  {
    materials.initialize();
    law->check(materials.pairs());
    law->prepare(materials.pairs(), rolling_model());
  }



  template <int dim>
  std::unique_ptr<dealii::FunctionParser<dim>>
  GrainParameters<dim>::removal_region(const double time) const
  {
    if (removal.empty())
      return nullptr;
    auto function = parse_expression<dim>(removal, 1, "Removal/Region");
    function->set_time(time);
    return function;
  }



  template <int dim>
  RollingModel
  GrainParameters<dim>::rolling_model() const
  {
    return rolling == "none"   ? RollingModel::none
           : rolling == "epsd" ? RollingModel::epsd
                               : RollingModel::constant_torque;
  }



  template <int dim>
  unsigned int
  GrainParameters<dim>::material_of_walls() const
  {
    return wall_material.empty()
             ? 0
             : materials.find(wall_material, "Walls/Material");
  }



  template <int dim>
  std::vector<Facet>
  GrainParameters<dim>::read_planes() const
  {
    using dealii::Utilities::split_string_list;
    std::vector<Facet> facets;
    for (const std::string &entry : split_string_list(planes, '|'))
      {
        std::vector<double> numbers;
        bool                are_numbers = true;
        const auto          parts       = split_string_list(entry, ':');
        for (const std::string &part : parts)
          for (const std::string &number : split_string_list(part, ','))
            {
              const auto value = finite_number(trimmed(number));
              are_numbers      = are_numbers && value.has_value();
              numbers.push_back(value.value_or(0.));
            }
        Facet facet{};
        facet.kind     = Facet::Kind::plane;
        facet.is_solid = true;
        const bool is_complete =
          are_numbers && parts.size() == 2 && numbers.size() == 2 * dim;
        if (is_complete)
          {
            facet.corner[0] = {numbers[0],
                               numbers[1],
                               dim == 3 ? numbers[2] : 0.};
            facet.normal    = {numbers[dim],
                               numbers[dim + 1],
                            dim == 3 ? numbers[dim + 2] : 0.};
          }
        AssertThrow(is_complete && norm(facet.normal) > 0.,
                    dealii::ExcMessage(
                      "'Walls/Planes' has '" + trimmed(entry) +
                      "'; write a point and a direction, '" +
                      (dim == 3 ? "0, 0, 0.1: 0, 0, 1" : "0, 0.1: 0, 1") +
                      "'."));
        facet.normal = (1. / norm(facet.normal)) * facet.normal;
        facets.push_back(facet);
      }
    return facets;
  }



  template <int dim>
  void
  GrainParameters<dim>::check(std::vector<std::string> &faults) const
  {
    GrainMaterials read          = materials;
    bool           has_materials = false;
    collect_fault(faults, [&]() {
      read.initialize();
      has_materials = true;
    });
    collect_fault(faults, [&]() { read_planes(); });
    collect_fault(faults, [&]() { removal_region(0.); });
    collect_fault(faults, [&]() { law->check({}); });
    if (!has_materials)
      return;
    collect_fault(faults, [&]() { insertions.check(read); });
    collect_fault(faults, [&]() {
      if (!wall_material.empty())
        read.find(wall_material, "Walls/Material");
    });
    own_walls.check(dim, read, faults);
  }



  template <int dim>
  void
  GrainParameters<dim>::check_on_mesh(const Mesh<dim>          &mesh,
                                      std::vector<std::string> &faults) const
  {
    collect_fault(faults, [&]() { insertions.check_on_mesh(mesh); });
    collect_fault(faults, [&]() {
      for (const unsigned int id : open_boundaries(mesh))
        for (const PeriodicPair &pair : mesh.periodic_pairs())
          AssertThrow(id != pair.first && id != pair.second,
                      dealii::ExcMessage(
                        "The boundary '" +
                        boundary_name(mesh.boundary_names(), id) +
                        "' is both in 'Walls/Open' and periodic; take it out "
                        "of one of them."));
    });
    collect_fault(faults, [&]() {
      for (const std::string &name : own_walls.names())
        AssertThrow(mesh.boundary_names().count(name) == 0,
                    dealii::ExcMessage("'Walls/Names' has '" + name +
                                       "', which is the name of a boundary: "
                                       "give the wall another one."));
    });
  }



  template <int dim>
  std::set<unsigned int>
  GrainParameters<dim>::open_boundaries(const Mesh<dim> &mesh) const
  {
    std::set<unsigned int> ids;
    for (const std::string &name : open)
      ids.insert(mesh.boundary_id(name));
    return ids;
  }



  template <int dim>
  void
  GrainParameters<dim>::make_walls(const Mesh<dim>                  &mesh,
                                   const std::vector<BoundaryFacet> &boundary,
                                   WallSet                          &walls,
                                   std::vector<std::string> &names) const
  {
    const std::vector<MovingWall> before = walls.moving;
    const double                  time   = walls.time;
    walls                                = WallSet();
    names.clear();
    const Vec3                           nothing{0., 0., 0.};
    const std::set<unsigned int>         is_open = open_boundaries(mesh);
    std::map<unsigned int, unsigned int> wall_of_boundary;
    const auto add_wall = [&](const std::string &name, const Vec3 &center) {
      names.push_back(name);
      walls.walls.push_back(
        {nothing, nothing, center, material_of_walls(), true});
      walls.forces.push_back({nothing, nothing});
      return walls.walls.size() - 1;
    };
    for (const auto &[facet, id] : boundary)
      if (is_open.count(id) == 0)
        {
          if (wall_of_boundary.count(id) == 0)
            wall_of_boundary[id] =
              add_wall(boundary_name(mesh.boundary_names(), id),
                       facet.corner[0]);
          walls.facets.push_back(facet);
          walls.facets.back().wall = wall_of_boundary[id];
        }
    for (Facet facet : read_planes())
      {
        facet.wall =
          add_wall("plane " + std::to_string(names.size()), facet.corner[0]);
        walls.facets.push_back(facet);
      }
    const auto &[low, high] = mesh.box();
    own_walls.add_to(
      walls, names, dim, materials, material_of_walls(), low.distance(high));
    for (std::size_t w = 0; w < before.size(); ++w)
      {
        walls.moving[w].now       = before[w].now;
        walls.moving[w].reference = before[w].reference;
      }
    walls.set_velocities(time);
    walls.place_facets(&MovingWall::now);
  }



  template struct GrainParameters<2>;
  template struct GrainParameters<3>;
} // namespace Thalweg
