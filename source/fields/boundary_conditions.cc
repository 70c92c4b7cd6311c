// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/boundary_conditions.h>
#include <thalweg/fields/boundary_entries.h>
#include <thalweg/fields/expression.h>
#include <thalweg/fields/uniform_inflow.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace Thalweg
{
  namespace
  {
    const std::string section_name = "Boundary conditions";

    /// Splits 'left: y-1, top: air' or 'left: max(y,1) | top: air' into its
    /// entries; commas within parentheses belong to expressions.
    std::vector<std::string>
    split_entries(const std::string &text)
    {
      std::vector<std::string> entries(1);
      int                      depth = 0;
      for (const char c : text)
        {
          depth += c == '(' ? 1 : c == ')' ? -1 : 0;
          if (c == '|' || (c == ',' && depth == 0))
            entries.emplace_back();
          else
            entries.back() += c;
        }
      std::vector<std::string> result;
      for (const std::string &entry : entries)
        if (const auto trimmed = dealii::Utilities::trim(entry);
            !trimmed.empty())
          result.push_back(trimmed);
      return result;
    }



    /// Whether @p text can only be the name of a fluid: a word that is no
    /// variable of an expression.
    bool
    is_name(const std::string &text)
    {
      static const std::set<std::string> variables{"x", "y", "z", "t", "pi"};
      return !text.empty() && variables.count(text) == 0 &&
             (std::isalpha(static_cast<unsigned char>(text[0])) ||
              text[0] == '_') &&
             std::all_of(text.begin(), text.end(), [](const char c) {
               return std::isalnum(static_cast<unsigned char>(c)) || c == '_' ||
                      c == ' ';
             });
    }



    /// A point that has no coordinate zero.
    template <int dim>
    dealii::Point<dim>
    elsewhere()
    {
      dealii::Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = 1.37 + d;
      return x;
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
    section.add("Flow rate",
                flow_rate,
                "m^2/s, m^3/s",
                "Boundaries through which a given volume comes in each second "
                "(out, if it is negative), a function of t; in two dimensions "
                "that of a slice of one metre: 'left: 0.02 | right: "
                "-0.02*sin(t)'. The velocity is uniform and normal to the "
                "boundary, to its mean normal if it is not plane.",
                dealii::Patterns::Anything());
    section.add("Inflow fluids",
                inflow_fluids,
                "",
                "Which fluid comes in through boundaries that are open or "
                "have a velocity or a flow rate: 'top: air, left: water'; or "
                "a level set, a function of x, y, z and t that is negative "
                "where it is the first one: 'left: y-0.2-0.01*sin(t)'. The "
                "second fluid where nothing is said.",
                dealii::Patterns::Anything());
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
      set(mesh, name, {BoundaryKind::no_slip, nullptr, "", nullptr});
    for (const std::string &name : parameters.slip)
      set(mesh, name, {BoundaryKind::slip, nullptr, "", nullptr});
    for (const auto &[name, text] :
         split_by_boundary(parameters.velocity, section_name + "/Velocity"))
      set(mesh,
          name,
          {BoundaryKind::velocity,
           parse_expression<dim>(text, dim, section_name + "/Velocity"),
           "",
           nullptr,
           mentions_time(text)});
    for (const auto &[name, text] :
         split_by_boundary(parameters.open, section_name + "/Open"))
      set(mesh,
          name,
          {BoundaryKind::open,
           parse_expression<dim>(text, 1, section_name + "/Open"),
           "",
           nullptr,
           mentions_time(text)});
    set_flow_rates(parameters.flow_rate, mesh);
    set_inflow_fluids(parameters.inflow_fluids, mesh);
    set_otherwise(parameters.otherwise, mesh);
  }



  template <int dim>
  void
  BoundaryConditions<dim>::set_flow_rates(const std::string &text,
                                          const Mesh<dim>   &mesh)
  {
    for (const auto &[name, expression] :
         split_by_boundary(text, section_name + "/Flow rate"))
      {
        constexpr double closed = 1e-6;
        auto             rate =
          parse_expression<dim>(expression, 1, section_name + "/Flow rate");
        AssertThrow(rate->value(elsewhere<dim>()) ==
                      rate->value(dealii::Point<dim>()),
                    dealii::ExcMessage(
                      "The 'Flow rate' of the boundary '" + name +
                      "' is that of the whole boundary: it may depend on t, "
                      "but not on x, y or z as '" +
                      expression + "' does. For a profile write 'Velocity'."));
        const auto area =
          vector_area(mesh, find_boundary(mesh, name, section_name));
        AssertThrow(area.norm() >
                      closed *
                        scalar_area(mesh,
                                    find_boundary(mesh, name, section_name)),
                    dealii::ExcMessage(
                      "The boundary '" + name +
                      "' is closed in itself, so that its 'Flow rate' has no "
                      "direction. Write a 'Velocity' instead."));
        set(mesh,
            name,
            {BoundaryKind::velocity,
             std::make_shared<UniformInflow<dim>>(std::move(rate), area),
             "",
             nullptr,
             mentions_time(expression)});
      }
  }



  template <int dim>
  void
  BoundaryConditions<dim>::set_inflow_fluids(const std::string &text,
                                             const Mesh<dim>   &mesh)
  {
    const std::string where = section_name + "/Inflow fluids";
    for (const std::string &entry : split_entries(text))
      {
        const auto colon = entry.find(':');
        AssertThrow(colon != std::string::npos,
                    dealii::ExcMessage(
                      "'" + entry + "' in '" + where +
                      "' should be 'boundary: fluid', or 'boundary: "
                      "expression' for a level set."));
        const std::string name =
          dealii::Utilities::trim(entry.substr(0, colon));
        const std::string value =
          dealii::Utilities::trim(entry.substr(colon + 1));
        const auto condition =
          conditions.find(find_boundary(mesh, name, section_name));
        AssertThrow(condition != conditions.end() &&
                      condition->second.function != nullptr,
                    dealii::ExcMessage(
                      "'" + where + "' names '" + name +
                      "', which is neither open nor has a velocity."));
        if (is_name(value))
          condition->second.inflow_fluid = value;
        else
          condition->second.inflow_level_set =
            parse_expression<dim>(value, 1, where);
      }
  }



  template <int dim>
  void
  BoundaryConditions<dim>::set_otherwise(const std::string &otherwise,
                                         const Mesh<dim>   &mesh)
  {
    for (const auto &[name, id] : mesh.boundary_names())
      {
        if (is_periodic(mesh, id) || conditions.count(id) > 0)
          continue;
        AssertThrow(otherwise != "fault",
                    dealii::ExcMessage("The boundary '" + name +
                                       "' has no condition; name it in '" +
                                       section_name + "'."));
        conditions[id].kind =
          otherwise == "slip" ? BoundaryKind::slip : BoundaryKind::no_slip;
      }
  }



  template <int dim>
  void
  BoundaryConditions<dim>::set(const Mesh<dim>   &mesh,
                               const std::string &name,
                               Condition          condition)
  {
    const auto id = find_boundary(mesh, name, section_name);
    AssertThrow(!is_periodic(mesh, id),
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
      for (const auto &function :
           {condition.function, condition.inflow_level_set})
        if (function)
          function->set_time(time);
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
