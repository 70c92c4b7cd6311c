// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_boundary_conditions_h
#define thalweg_fields_boundary_conditions_h

#include <thalweg/core/section.h>
#include <thalweg/mesh/mesh.h>

#include <deal.II/base/function.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Thalweg
{
  /// The parameters of the section "Boundary conditions".
  struct BoundaryConditionParameters
  {
    /// Declares the section below @p root.
    void
    declare(const Section &root);

    std::vector<std::string> no_slip;
    std::vector<std::string> slip;
    std::string              velocity;
    std::string              open;
    std::string              flow_rate;
    std::string              inflow_fluids;
    std::string              otherwise = "slip";
  };

  /// What happens to the flow at a boundary.
  enum class BoundaryKind
  {
    slip,
    no_slip,
    velocity,
    open
  };

  /**
   * @brief The conditions at all boundaries of a mesh.
   */
  template <int dim>
  class BoundaryConditions
  {
  public:
    /// The condition at one boundary.
    struct Condition
    {
      BoundaryKind kind = BoundaryKind::slip;
      /// For BoundaryKind::velocity: dim components, m/s; for
      /// BoundaryKind::open: the pressure, Pa.
      std::shared_ptr<dealii::Function<dim>> function;
      /// The name of the fluid that comes in; empty for the second one, or if
      /// there is an inflow_level_set.
      std::string inflow_fluid;
      /// Where which fluid comes in: the first where it is negative.
      std::shared_ptr<dealii::Function<dim>> inflow_level_set;
      /// Whether the function depends on the time.
      bool is_transient = false;
    };

    /// @throws dealii::ExcMessage for names that the mesh does not have,
    ///   boundaries with two conditions and expressions with faults
    BoundaryConditions(const BoundaryConditionParameters &parameters,
                       const Mesh<dim>                   &mesh);

    /// Evaluates the functions at @p time from now on.
    void
    set_time(const double time);

    /// The condition at boundary @p id.
    const Condition &
    at(const dealii::types::boundary_id id) const
    {
      return conditions.at(id);
    }

    const std::map<dealii::types::boundary_id, Condition> &
    all() const
    {
      return conditions;
    }

    /// Whether the pressure is prescribed somewhere.
    bool
    has_open_boundary() const;

    /// Whether a given velocity depends on the time.
    bool
    has_transient_velocity() const;

  private:
    void
    set(const Mesh<dim> &mesh, const std::string &name, Condition condition);

    void
    set_flow_rates(const std::string &text, const Mesh<dim> &mesh);

    void
    set_inflow_fluids(const std::string &text, const Mesh<dim> &mesh);

    /// Boundaries without a condition get the one that is meant for them.
    void
    set_otherwise(const std::string &otherwise, const Mesh<dim> &mesh);

    std::map<dealii::types::boundary_id, Condition> conditions;
  };
} // namespace Thalweg

#endif
