// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_interface_signed_distance_h
#define thalweg_interface_signed_distance_h

#include <deal.II/base/function.h>

namespace Thalweg
{
  /**
   * @brief The signed distance to where another function vanishes, for any
   * level set that is smooth there: scaled, or a polynomial.
   *
   * Where the function's slope is one it is taken as it is. Elsewhere Newton's
   * method goes along the gradient to the zero; on edges of the function, or
   * where it does not find a zero, the value over the slope must do, which has
   * the right sign. Exact for planes and circles.
   */
  template <int dim>
  class SignedDistance : public dealii::Function<dim>
  {
  public:
    /**
     * @param function a level set; must outlive this object
     * @param length a small length of the mesh, m; slopes are differences
     *   over a part of it
     */
    SignedDistance(const dealii::Function<dim> &function, const double length);

    double
    value(const dealii::Point<dim> &x,
          const unsigned int        component = 0) const override;

    /// Whether the function itself is a distance as far as its slope at @p x
    /// tells; on an edge of the function it may be.
    bool
    is_function(const dealii::Point<dim> &x) const;

  private:
    /// Differences to both sides of a point.
    struct Slope
    {
      dealii::Tensor<1, dim> gradient;      ///< their means
      double                 steepest = 0.; ///< the greatest one
      double                 roughest = 0.; ///< the greatest change of one
    };

    Slope
    slope(const dealii::Point<dim> &x, const double value) const;

    const dealii::Function<dim> &function;
    const double                 step;
  };
} // namespace Thalweg

#endif
