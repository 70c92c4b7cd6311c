// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/boundary_entries.h>
#include <thalweg/fields/expression.h>
#include <thalweg/fields/scalar_conditions.h>

namespace Thalweg
{
  void
  ScalarConditionParameters::declare(const Section &section)
  {
    section.add("Value",
                value,
                "",
                "Boundaries where the scalar is given, as a function of x, y, "
                "z and t: `left: 1 | right: sin(t)`. What flows in there has "
                "this value. Nothing passes through boundaries that are named "
                "nowhere but with the flow.",
                dealii::Patterns::Anything());
    section.add("Flux",
                flux,
                "",
                "Boundaries through which it comes in at a given rate, in "
                "units of the scalar times the capacity, for each square metre "
                "and second (W/m^2 of heat): `bottom: 100`.",
                dealii::Patterns::Anything());
    section.add("Exchange",
                exchange,
                "",
                "Boundaries through which it comes in in proportion to the "
                "difference from a value outside: the coefficient (W/(m^2 K) "
                "of heat) and, behind a semicolon, that value: `top: 10; "
                "293`.",
                dealii::Patterns::Anything());
  }



  template <int dim>
  ScalarConditions<dim>::ScalarConditions(
    const ScalarConditionParameters &parameters,
    const Mesh<dim>                 &mesh,
    const std::string               &where)
  {
    struct Kind
    {
      ScalarBoundary     kind;
      const char        *name;
      const std::string &text;
      unsigned int       n_components;
    };
    for (const auto &[kind, parameter, text, n_components] :
         {Kind{ScalarBoundary::value, "Value", parameters.value, 1},
          Kind{ScalarBoundary::flux, "Flux", parameters.flux, 1},
          Kind{ScalarBoundary::exchange, "Exchange", parameters.exchange, 2}})
      for (const auto &[name, expression] :
           split_by_boundary(text, where + "/" + parameter))
        {
          const auto id = find_boundary(mesh, name, where);
          AssertThrow(!is_periodic(mesh, id),
                      dealii::ExcMessage("The boundary '" + name +
                                         "' is periodic and can have no "
                                         "condition in '" +
                                         where + "'."));
          const bool is_new =
            conditions
              .emplace(id,
                       Condition{kind,
                                 parse_expression<dim>(expression,
                                                       n_components,
                                                       where + "/" +
                                                         parameter)})
              .second;
          AssertThrow(is_new,
                      dealii::ExcMessage("The boundary '" + name +
                                         "' has two conditions in '" + where +
                                         "'; leave one."));
        }
  }



  template <int dim>
  void
  ScalarConditions<dim>::set_time(const double time)
  {
    for (auto &[id, condition] : conditions)
      condition.function->set_time(time);
  }



  template <int dim>
  const typename ScalarConditions<dim>::Condition &
  ScalarConditions<dim>::at(const dealii::types::boundary_id id) const
  {
    static const Condition insulated;
    const auto             found = conditions.find(id);
    return found == conditions.end() ? insulated : found->second;
  }



  THALWEG_INSTANTIATE(ScalarConditions)
} // namespace Thalweg
