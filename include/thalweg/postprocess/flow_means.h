// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_flow_means_h
#define thalweg_postprocess_flow_means_h

#include <thalweg/fields/flow_fields.h>
#include <thalweg/fields/state.h>

#include <array>
#include <memory>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Means of a flow over time and, on demand, of the products of its
   * fluctuations, in spaces of the flow's degrees.
   *
   * The spaces are its own, so that they outlive the flow's when the mesh
   * changes. Dependent nodes have what follows from the others.
   */
  template <int dim>
  class FlowMeans
  {
  public:
    /// @param with_stresses whether stress() is needed
    explicit FlowMeans(const bool with_stresses)
      : with_stresses(with_stresses)
    {}

    /**
     * @brief Makes spaces for means of @p flow, whose values are then zero;
     * the averaged time stays what it was. To be called at the start, and
     * when the mesh has changed.
     * @param mesh of the flow; it and the flow's mapping must outlive the
     *   spaces
     */
    void
    initialize(const Mesh<dim> &mesh, const FlowFields<dim> &flow);

    /// Counts the present flow for @p duration, in s.
    void
    add(const FlowFields<dim> &flow, const double duration);

    /// In s.
    double
    averaged_time() const
    {
      return total_time;
    }

    /// The means as a flow, with what @p present says of the fluid; no
    /// reaction. Valid until initialize() is called again.
    FlowFields<dim>
    flow(const FlowFields<dim> &present) const;

    /// m/s, ghosted.
    const Vector &
    velocity() const
    {
      return mean_velocity;
    }

    /// Pa, ghosted.
    const Vector &
    pressure() const
    {
      return mean_pressure;
    }

    /**
     * @brief A row of the tensor of Reynolds stresses, the means of
     * u'_component u', in m^2/s^2, in the space of the velocity; ghosted.
     */
    Vector
    stress(const unsigned int component) const;

    void
    keep(const State<dim> &state);

  private:
    /// For each owned degree of freedom of @p own the local number in
    /// @p vector of the one of @p dofs at the same place.
    static std::vector<unsigned int>
    find_sources(const LagrangeSpace<dim>      &own,
                 const dealii::DoFHandler<dim> &dofs,
                 const Vector                  &vector);

    bool   with_stresses;
    double total_time = 0.;
    /// They are one if the degrees are equal.
    std::shared_ptr<LagrangeSpace<dim>> velocity_space, pressure_space;
    std::vector<unsigned int>           velocity_sources, pressure_sources;
    Vector                              mean_velocity, mean_pressure;
    /// Empty where the flow has none.
    Vector                  mean_traction;
    std::array<Vector, dim> stress_times_time;
  };
} // namespace Thalweg

#endif
