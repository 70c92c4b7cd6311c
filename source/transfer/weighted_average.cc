// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/q1_cell.h>
#include <thalweg/transfer/negligible_weight.h>
#include <thalweg/transfer/projection.h>

#include <algorithm>

namespace Thalweg
{
  /**
   * @brief Averages of the level set with the shape functions as weights
   * (Eq. 69), and velocities by project_momentum().
   */
  template <int dim>
  class WeightedAverage : public Projection<dim>
  {
  public:
    void
    declare_parameters(const Section &) override
    {}

    void
    project(const Population<dim> &population,
            const NodeSpace<dim>  &space,
            const Fluids          &fluids,
            Vector                &velocity,
            Vector                &level_set) const override;
  };



  namespace
  {
    template <int dim>
    void
    add_cell(const Population<dim> &population,
             const NodeSpace<dim>  &space,
             const unsigned int     cell,
             const double           band,
             Vector                &sum_of_weights,
             Vector                &sum)
    {
      const double limit = band * space.mesh().graph().cell(cell).edges().first;
      constexpr unsigned int n = 1 << dim;
      std::array<double, n>  weight{}, level_set{};
      for (const auto &particle : population.in_cell(cell))
        {
          const auto   shape = Q1::values<dim>(particle.reference());
          const double phi =
            std::clamp(particle.properties()[Population<dim>::level_set_offset],
                       -limit,
                       limit);
          for (unsigned int v = 0; v < n; ++v)
            {
              weight[v] += shape[v];
              level_set[v] += shape[v] * phi;
            }
        }
      const auto &nodes = space.nodes(cell);
      for (unsigned int v = 0; v < n; ++v)
        {
          sum_of_weights.local_element(nodes[v]) += weight[v];
          sum.local_element(nodes[v]) += level_set[v];
        }
    }
  } // namespace



  template <int dim>
  void
  WeightedAverage<dim>::project(const Population<dim> &population,
                                const NodeSpace<dim>  &space,
                                const Fluids          &fluids,
                                Vector                &velocity,
                                Vector                &level_set) const
  {
    project_momentum(population, space, fluids, velocity);

    Vector weight, sum;
    space.initialize_scalar(weight);
    space.initialize_scalar(sum);
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      add_cell(population, space, c, this->band, weight, sum);
    space.fold(weight, 1);
    space.fold(sum, 1);
    for (unsigned int n = 0; n < weight.locally_owned_size(); ++n)
      if (weight.local_element(n) > negligible_weight)
        level_set.local_element(n) =
          sum.local_element(n) / weight.local_element(n);
    space.interpolate(level_set, 1);
  }



  THALWEG_INSTANTIATE(WeightedAverage)
  THALWEG_REGISTER(Projection,
                   WeightedAverage,
                   "weighted average",
                   "means with the shape functions as weights (Eq. 69)")
} // namespace Thalweg
