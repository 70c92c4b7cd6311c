#include <thalweg/fields/q1_cell.h>
#include <thalweg/transfer/projection.h>

#include <algorithm>

namespace Thalweg
{
  /**
   * @brief Averages with the shape functions as weights (Eq. 69); velocities
   * with the particles' densities besides, so that it is momentum that is
   * averaged across an interface.
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
    /// Below this weight no particle is near enough to a node to speak for
    /// it.
    constexpr double negligible_weight = 1e-10;



    /// Sums over the particles, a value a node (dim for the momentum).
    struct Sums
    {
      Vector weight, level_set, mass, momentum;
    };



    template <int dim>
    void
    add_cell(const Population<dim> &population,
             const NodeSpace<dim>  &space,
             const Fluids          &fluids,
             const unsigned int     cell,
             const double           band,
             Sums                  &sums)
    {
      const double limit = band * space.mesh().graph().cell(cell).edges().first;
      constexpr unsigned int      n = 1 << dim;
      std::array<double, n>       weight{}, level_set{}, mass{};
      std::array<double, dim * n> momentum{};
      for (const auto &particle : population.handler().particles_in_cell(
             population.mesh().graph().iterator(cell)))
        {
          const auto shape = Q1::values<dim>(particle.get_reference_location());
          const auto properties = particle.get_properties();
          const double phi =
            std::clamp(properties[Population<dim>::level_set_offset],
                       -limit,
                       limit);
          const double density = fluids.at(phi).density;
          for (unsigned int v = 0; v < n; ++v)
            {
              weight[v] += shape[v];
              level_set[v] += shape[v] * phi;
              mass[v] += shape[v] * density;
              for (unsigned int d = 0; d < dim; ++d)
                momentum[dim * v + d] +=
                  shape[v] * density *
                  properties[Population<dim>::velocity_offset + d];
            }
        }
      const auto &nodes = space.nodes(cell);
      for (unsigned int v = 0; v < n; ++v)
        {
          sums.weight.local_element(nodes[v]) += weight[v];
          sums.level_set.local_element(nodes[v]) += level_set[v];
          sums.mass.local_element(nodes[v]) += mass[v];
          for (unsigned int d = 0; d < dim; ++d)
            sums.momentum.local_element(dim * nodes[v] + d) +=
              momentum[dim * v + d];
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
    Sums sums;
    for (Vector *scalar : {&sums.weight, &sums.level_set, &sums.mass})
      space.initialize_scalar(*scalar);
    space.initialize_velocity(sums.momentum);
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      add_cell(population, space, fluids, c, this->band, sums);
    for (Vector *scalar : {&sums.weight, &sums.level_set, &sums.mass})
      space.fold(*scalar, 1);
    space.fold(sums.momentum, dim);

    for (unsigned int n = 0; n < sums.weight.locally_owned_size(); ++n)
      if (sums.weight.local_element(n) > negligible_weight)
        {
          level_set.local_element(n) =
            sums.level_set.local_element(n) / sums.weight.local_element(n);
          for (unsigned int d = 0; d < dim; ++d)
            velocity.local_element(dim * n + d) =
              sums.momentum.local_element(dim * n + d) /
              sums.mass.local_element(n);
        }
    space.interpolate(level_set, 1);
    space.interpolate(velocity, dim);
  }



  THALWEG_INSTANTIATE(WeightedAverage)
  THALWEG_REGISTER(Projection,
                   WeightedAverage,
                   "weighted average",
                   "means with the shape functions as weights, velocities "
                   "with the densities besides (Eq. 69)")
} // namespace Thalweg
