// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_scalar_conditions_h
#define thalweg_fields_scalar_conditions_h

#include <thalweg/core/section.h>
#include <thalweg/mesh/mesh.h>

#include <deal.II/base/function.h>

#include <map>
#include <memory>
#include <string>

namespace Thalweg
{
  /// What users say of a scalar at the boundaries.
  struct ScalarConditionParameters
  {
    void
    declare(const Section &section);

    std::string value;
    std::string flux;
    std::string exchange;
  };

  /// What happens to a scalar at a boundary.
  enum class ScalarBoundary
  {
    insulated,
    value,   ///< s = g
    flux,    ///< k ds/dn = q, what comes in through an area in a second
    exchange ///< k ds/dn = h (s_outside - s)
  };

  /**
   * @brief The conditions of a scalar at all boundaries of a mesh.
   */
  template <int dim>
  class ScalarConditions
  {
  public:
    struct Condition
    {
      ScalarBoundary kind = ScalarBoundary::insulated;
      /// The value, the flux, or coefficient and value outside.
      std::shared_ptr<dealii::Function<dim>> function;
    };

    /// @param where the section, for messages
    /// @throws dealii::ExcMessage for names that the mesh does not have,
    ///   periodic boundaries, boundaries with two conditions and expressions
    ///   with faults
    ScalarConditions(const ScalarConditionParameters &parameters,
                     const Mesh<dim>                 &mesh,
                     const std::string               &where);

    /// Evaluates the functions at @p time from now on, in s.
    void
    set_time(const double time);

    /// The condition at boundary @p id.
    const Condition &
    at(const dealii::types::boundary_id id) const;

    /// Those that were given, by boundary.
    const std::map<dealii::types::boundary_id, Condition> &
    all() const
    {
      return conditions;
    }

  private:
    std::map<dealii::types::boundary_id, Condition> conditions;
  };
} // namespace Thalweg

#endif
