// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_convected_change_h
#define thalweg_methods_convected_change_h

#include <thalweg/fields/node_space.h>
#include <thalweg/particles/streamline_convection.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief What convection will change of a velocity in a short time:
   * V(x_{-t}) - V(x) at each node, with the streamline of V through x that has
   * been at x_{-t} the time t before. Stable for any time, other than an
   * extrapolation of what it has changed before.
   */
  template <int dim>
  class ConvectedChange
  {
  public:
    /// @p space must outlive the object.
    explicit ConvectedChange(const NodeSpace<dim> &space);

    /**
     * @brief Finds the changes. Collective.
     * @param convection walks along streamlines
     * @param velocity ghosted and consistent, m/s
     * @param level_set whatever is at hand
     * @param time t, s
     * @param change m/s, owned values at independent nodes
     */
    void
    find(const StreamlineConvection<dim> &convection,
         const Vector                    &velocity,
         const CellField<dim, 1>         &level_set,
         const double                     time,
         Vector                          &change) const;

  private:
    const NodeSpace<dim>           &space;
    std::vector<unsigned int>       nodes; ///< independent, known here
    std::vector<unsigned int>       cells; ///< the owned one that they start in
    std::vector<dealii::Point<dim>> reference_points; ///< there
  };
} // namespace Thalweg

#endif
