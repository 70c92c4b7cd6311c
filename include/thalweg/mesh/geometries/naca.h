// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_geometries_naca_h
#define thalweg_mesh_geometries_naca_h

#include <deal.II/base/point.h>
#include <deal.II/grid/manifold.h>

#include <memory>
#include <string>

namespace Thalweg
{
  namespace Geometries
  {
    /**
     * @brief The outline of a NACA airfoil of the four-digit series with a
     * sharp trailing edge.
     *
     * The leading edge is at the origin, the trailing edge on the x axis at
     * one chord. The upper and the lower side are smooth curves over the root
     * s of the place on the chord, from the leading (s = 0) to the trailing
     * edge (s = 1), which is regular at the leading edge too. The last
     * coefficient of the thickness is -0.1036 instead of -0.1015, which
     * closes the trailing edge.
     */
    class NacaOutline
    {
    public:
      enum class Side
      {
        upper,
        lower
      };

      /**
       * @param digits as in "2412": the camber in hundredths of the chord,
       *   its place in tenths, and the thickness in hundredths
       * @param chord m
       * @throws dealii::ExcMessage if these are no digits of an airfoil
       */
      NacaOutline(const std::string &digits, const double chord);

      /// The point of a side at @p s from 0 to 1, m.
      dealii::Point<2>
      point(const Side side, const double s) const;

      /// The derivative of point() with respect to @p s, m.
      dealii::Tensor<1, 2>
      tangent(const Side side, const double s) const;

      /// The unit vector at @p s that points into the flow.
      dealii::Tensor<1, 2>
      normal(const Side side, const double s) const;

      /// The s of a point on the side, or of the point of the side next to
      /// @p point.
      double
      parameter(const Side side, const dealii::Point<2> &point) const;

      /// How far the sides rise above straight lines from @p s to @p t, m.
      double
      rise(const double s, const double t) const;

      double
      chord() const
      {
        return length;
      }

      /// The greatest thickness over the chord.
      double
      thickness() const
      {
        return thick;
      }

    private:
      double length;
      double camber;
      double place;
      double thick;
    };

    /// The manifold of one side of @p outline: new points lie on the outline,
    /// in 3D drawn out along z.
    template <int dim>
    std::unique_ptr<dealii::Manifold<dim>>
    naca_manifold(const NacaOutline &outline, const NacaOutline::Side side);
  } // namespace Geometries
} // namespace Thalweg

#endif
