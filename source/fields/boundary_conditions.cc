#include <thalweg/core/registry.h>
#include <thalweg/fields/boundary_conditions.h>
#include <thalweg/fields/expression.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    const std::string section_name = "Boundary conditions";

    /// Splits 'left: 1; 0 | top: 2; 0' into names and expressions.
    std::vector<std::pair<std::string, std::string>>
    split_expressions(const std::string &text, const std::string &where)
    {
      std::vector<std::pair<std::string, std::string>> result;
      for (const std::string &entry :
           dealii::Utilities::split_string_list(text, '|'))
        {
          if (entry.empty())
            continue;
          const auto colon = entry.find(':');
          AssertThrow(colon != std::string::npos,
                      dealii::ExcMessage(
                        "'" + entry + "' in '" + section_name + "/" + where +
                        "' has no colon between the boundary's name and the "
                        "expression."));
          result.emplace_back(dealii::Utilities::trim(entry.substr(0, colon)),
                              dealii::Utilities::trim(entry.substr(colon + 1)));
        }
      return result;
    }
  } // namespace



  void
  BoundaryConditionParameters::declare(const Section &root)
  {
    const Section section = root.enter(section_name);
    section.add("No slip",
                no_slip,
                "",
                "Names of boundaries to which the fluid sticks.");
    section.add("Slip",
                slip,
                "",
                "Names of boundaries along which the fluid slides freely.");
    section.add("Velocity",
                velocity,
                "m/s",
                "Boundaries with a given velocity, a function of x, y, z and "
                "t with a semicolon between the components and '|' between "
                "boundaries: 'left: 4*y*(1-y); 0 | top: 1; 0'.",
                dealii::Patterns::Anything());
    section.add("Open",
                open,
                "Pa",
                "Boundaries through which fluid comes and goes, with the "
                "pressure there as a function of x, y, z and t: 'top: 0'.",
                dealii::Patterns::Anything());
    section.add("Inflow fluids",
                inflow_fluids,
                "",
                "Which fluid comes in through boundaries that are open or "
                "have a velocity: 'top: air, left: water'. The second fluid "
                "where nothing is said.");
    section.add("Otherwise",
                otherwise,
                "",
                "The condition at boundaries that are not named.",
                dealii::Patterns::Selection("slip|no slip|fault"));
  }



  template <int dim>
  BoundaryConditions<dim>::BoundaryConditions(
    const BoundaryConditionParameters &parameters,
    const Mesh<dim>                   &mesh)
  {
    for (const std::string &name : parameters.no_slip)
      set(mesh, name, {BoundaryKind::no_slip, nullptr, "", false});
    for (const std::string &name : parameters.slip)
      set(mesh, name, {BoundaryKind::slip, nullptr, "", false});
    for (const auto &[name, text] :
         split_expressions(parameters.velocity, "Velocity"))
      set(mesh,
          name,
          {BoundaryKind::velocity,
           parse_expression<dim>(text, dim, section_name + "/Velocity"),
           "",
           mentions_time(text)});
    for (const auto &[name, text] : split_expressions(parameters.open, "Open"))
      set(mesh,
          name,
          {BoundaryKind::open,
           parse_expression<dim>(text, 1, section_name + "/Open"),
           "",
           mentions_time(text)});
    for (const std::string &entry : parameters.inflow_fluids)
      {
        const auto parts = dealii::Utilities::split_string_list(entry, ':');
        AssertThrow(parts.size() == 2,
                    dealii::ExcMessage("'" + entry + "' in '" + section_name +
                                       "/Inflow fluids' should be 'boundary: "
                                       "fluid'."));
        const auto condition = conditions.find(mesh.boundary_id(parts[0]));
        AssertThrow(condition != conditions.end() &&
                      condition->second.function != nullptr,
                    dealii::ExcMessage(
                      "'" + section_name + "/Inflow fluids' names '" +
                      parts[0] +
                      "', which is neither open nor has a velocity."));
        condition->second.inflow_fluid = parts[1];
      }
    for (const auto &[name, id] : mesh.boundary_names())
      {
        const bool is_periodic =
          std::any_of(mesh.periodic_pairs().begin(),
                      mesh.periodic_pairs().end(),
                      [id = id](const auto &pair) {
                        return pair.first == id || pair.second == id;
                      });
        if (is_periodic || conditions.count(id) > 0)
          continue;
        AssertThrow(parameters.otherwise != "fault",
                    dealii::ExcMessage("The boundary '" + name +
                                       "' has no condition; name it in '" +
                                       section_name + "'."));
        conditions[id].kind = parameters.otherwise == "slip"
                                ? BoundaryKind::slip
                                : BoundaryKind::no_slip;
      }
  }



  template <int dim>
  void
  BoundaryConditions<dim>::set(const Mesh<dim>   &mesh,
                               const std::string &name,
                               Condition          condition)
  {
    const auto id = mesh.boundary_id(name);
    for (const auto &pair : mesh.periodic_pairs())
      AssertThrow(pair.first != id && pair.second != id,
                  dealii::ExcMessage("The boundary '" + name +
                                     "' is periodic and can have no condition "
                                     "in '" +
                                     section_name + "'."));
    AssertThrow(conditions.count(id) == 0,
                dealii::ExcMessage("The boundary '" + name +
                                   "' has two conditions in '" + section_name +
                                   "'; leave one."));
    conditions[id] = std::move(condition);
  }



  template <int dim>
  void
  BoundaryConditions<dim>::set_time(const double time)
  {
    for (auto &[id, condition] : conditions)
      if (condition.function)
        condition.function->set_time(time);
  }



  template <int dim>
  bool
  BoundaryConditions<dim>::has_open_boundary() const
  {
    return std::any_of(conditions.begin(),
                       conditions.end(),
                       [](const auto &entry) {
                         return entry.second.kind == BoundaryKind::open;
                       });
  }



  template <int dim>
  bool
  BoundaryConditions<dim>::has_transient_velocity() const
  {
    return std::any_of(conditions.begin(),
                       conditions.end(),
                       [](const auto &entry) {
                         return entry.second.kind == BoundaryKind::velocity &&
                                entry.second.is_transient;
                       });
  }



  THALWEG_INSTANTIATE(BoundaryConditions)
} // namespace Thalweg
