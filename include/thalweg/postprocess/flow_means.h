#ifndef thalweg_postprocess_flow_means_h
#define thalweg_postprocess_flow_means_h

#include <thalweg/fields/flow_fields.h>

#include <array>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Means of a flow over time and of the products of its
   * fluctuations, in the flow's own spaces.
   */
  template <int dim>
  class FlowMeans
  {
  public:
    using Vector = typename FlowFields<dim>::Vector;

    /// Counts the present flow for @p duration, in s.
    /// @throws dealii::ExcMessage if the mesh has changed
    void
    add(const FlowFields<dim> &flow, const double duration);

    /// In s.
    double
    averaged_time() const
    {
      return total_time;
    }

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

  private:
    void
    begin(const FlowFields<dim> &flow);

    double                  total_time = 0.;
    Vector                  mean_velocity, mean_pressure;
    std::array<Vector, dim> stress_times_time;
    /// For each owned degree of freedom of the velocity all components at
    /// its node, in local numbers.
    std::vector<std::array<unsigned int, dim>> partners;
  };
} // namespace Thalweg

#endif
