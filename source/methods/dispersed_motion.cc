// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/methods/dispersed_motion.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    template <int dim>
    dealii::Tensor<1, dim>
    acceleration_at_rest(const BodyForces<dim>    &forces,
                         const Fluid              &fluid,
                         const dealii::Point<dim> &place)
    {
      dealii::Tensor<1, dim> sum = forces.uniform_acceleration();
      if (forces.has_field())
        sum += forces.field(place);
      if (forces.has_density())
        sum += forces.density(place) / fluid.density;
      return sum;
    }



    template <int dim>
    double
    diameter(const double volume)
    {
      return dim == 2 ? std::sqrt(4. * volume / dealii::numbers::PI)
                      : std::cbrt(6. * volume / dealii::numbers::PI);
    }



    double
    rise_velocity(const Fluids &fluids,
                  const double  acceleration,
                  const double  diameter)
    {
      const double cap = .71 * std::sqrt(acceleration * diameter);
      if (fluids[0].viscosity == 0)
        return cap;
      const double creeping = (fluids[0].density - fluids[1].density) *
                              acceleration * diameter * diameter /
                              (18. * fluids[0].viscosity);
      return std::min(creeping, cap);
    }
  } // namespace



  template <int dim>
  DispersedMotion<dim>
  dispersed_motion(const BodyForces<dim> &forces, const Fluids &fluids)
  {
    using Coordinates = typename DispersedMotion<dim>::Coordinates;
    DispersedMotion<dim> motion;
    motion.acceleration = [&forces, &fluids](const dealii::Point<dim> &place,
                                             const Coordinates &velocity) {
      const auto  sum = acceleration_at_rest(forces, fluids[0], place);
      Coordinates result;
      for (unsigned int d = 0; d < dim; ++d)
        {
          result[d] = sum[d];
          if (forces.is_rotating())
            for (unsigned int e = 0; e < dim; ++e)
              result[d] -= 2. * forces.spin()[d][e] * velocity[e];
        }
      return result;
    };
    motion.rise = [&forces, &fluids](const dealii::Point<dim> &place,
                                     const double              volume) {
      const auto   sum  = acceleration_at_rest(forces, fluids[0], place);
      const double size = sum.norm();
      Coordinates  result{};
      if (size > 0)
        for (unsigned int d = 0; d < dim; ++d)
          result[d] =
            -rise_velocity(fluids, size, diameter<dim>(volume)) * sum[d] / size;
      return result;
    };
    return motion;
  }



  template DispersedMotion<2>
  dispersed_motion(const BodyForces<2> &, const Fluids &);
  template DispersedMotion<3>
  dispersed_motion(const BodyForces<3> &, const Fluids &);
} // namespace Thalweg
