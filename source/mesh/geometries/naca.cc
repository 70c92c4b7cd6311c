// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/naca.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace Geometries
  {
    NacaOutline::NacaOutline(const std::string &digits, const double chord)
      : length(chord)
    {
      AssertThrow(digits.size() == 4 &&
                    digits.find_first_not_of("0123456789") == std::string::npos,
                  dealii::ExcMessage("'" + digits +
                                     "' is no NACA airfoil of the four-digit "
                                     "series; write four digits, for example "
                                     "'0012' or '2412'."));
      camber = .01 * (digits[0] - '0');
      place  = .1 * (digits[1] - '0');
      thick  = .01 * (10 * (digits[2] - '0') + (digits[3] - '0'));
      AssertThrow(thick > 0. && thick <= .4,
                  dealii::ExcMessage("The airfoil NACA " + digits +
                                     " is none to mesh: the last two digits, "
                                     "its thickness in hundredths of the "
                                     "chord, must be from 01 to 40."));
      AssertThrow((camber > 0.) == (place > 0.),
                  dealii::ExcMessage(
                    "The airfoil NACA " + digits +
                    " does not exist: of the first two digits, the camber and "
                    "its place, none or both are zero, as in '0012' and "
                    "'2412'."));
    }



    dealii::Point<2>
    NacaOutline::point(const Side side, const double s) const
    {
      const double x = s * s;
      const double half =
        5. * thick *
        (.2969 * s + x * (-.1260 + x * (-.3516 + x * (.2843 - x * .1036))));
      double line = 0., slope = 0.;
      if (camber > 0.)
        {
          const double part  = x < place ? place : 1. - place;
          const double scale = camber / (part * part);
          line               = x < place ? scale * x * (2. * place - x)
                                         : scale * (1. - x) * (1. + x - 2. * place);
          slope              = 2. * scale * (place - x);
        }
      const double sign  = side == Side::upper ? 1. : -1.;
      const double angle = std::atan(slope);
      return {length * (x - sign * half * std::sin(angle)),
              length * (line + sign * half * std::cos(angle))};
    }



    dealii::Tensor<1, 2>
    NacaOutline::tangent(const Side side, const double s) const
    {
      // The polynomials go on beyond both ends.
      constexpr double step = 1e-5;
      return (point(side, s + step) - point(side, s - step)) / (2. * step);
    }



    dealii::Tensor<1, 2>
    NacaOutline::normal(const Side side, const double s) const
    {
      const auto   t    = tangent(side, s);
      const double sign = side == Side::upper ? 1. : -1.;
      return dealii::Point<2>(-sign * t[1], sign * t[0]) / t.norm();
    }



    double
    NacaOutline::rise(const double s, const double t) const
    {
      double height = 0.;
      for (const Side side : {Side::upper, Side::lower})
        {
          const auto   a = point(side, s), b = point(side, t);
          const auto   m      = point(side, .5 * (s + t)) - a;
          const double across = (b - a)[0] * m[1] - (b - a)[1] * m[0];
          height = std::max(height, std::abs(across) / a.distance(b));
        }
      return height;
    }



    double
    NacaOutline::parameter(const Side side, const dealii::Point<2> &p) const
    {
      constexpr unsigned int n    = 64;
      double                 best = 0.;
      for (unsigned int i = 1; i <= n; ++i)
        if (point(side, double(i) / n).distance_square(p) <
            point(side, best).distance_square(p))
          best = double(i) / n;
      // Newton's method for the foot of the perpendicular. For points on the
      // outline, whose distance is zero, it converges quadratically without
      // the second derivative.
      for (unsigned int i = 0; i < 30; ++i)
        {
          const auto   t      = tangent(side, best);
          const double change = (p - point(side, best)) * t / t.norm_square();
          best                = std::clamp(best + change, 0., 1.);
          if (std::abs(change) < 1e-15)
            break;
        }
      return best;
    }



    namespace
    {
      /// The chart of one side: s, and in 3D also z.
      template <int dim>
      class NacaManifold : public dealii::ChartManifold<dim, dim, dim - 1>
      {
      public:
        NacaManifold(const NacaOutline &outline, const NacaOutline::Side side)
          : outline(outline)
          , side(side)
        {}

        std::unique_ptr<dealii::Manifold<dim>>
        clone() const override
        {
          return std::make_unique<NacaManifold<dim>>(*this);
        }

        dealii::Point<dim - 1>
        pull_back(const dealii::Point<dim> &point) const override
        {
          dealii::Point<dim - 1> chart;
          chart[0] = outline.parameter(side, {point[0], point[1]});
          if constexpr (dim == 3)
            chart[1] = point[2];
          return chart;
        }

        dealii::Point<dim>
        push_forward(const dealii::Point<dim - 1> &chart) const override
        {
          const auto         p = outline.point(side, chart[0]);
          dealii::Point<dim> point;
          point[0] = p[0];
          point[1] = p[1];
          if constexpr (dim == 3)
            point[2] = chart[1];
          return point;
        }

        dealii::DerivativeForm<1, dim - 1, dim>
        push_forward_gradient(
          const dealii::Point<dim - 1> &chart) const override
        {
          dealii::DerivativeForm<1, dim - 1, dim> gradient;
          const auto t   = outline.tangent(side, chart[0]);
          gradient[0][0] = t[0];
          gradient[1][0] = t[1];
          if constexpr (dim == 3)
            gradient[2][1] = 1.;
          return gradient;
        }

      private:
        const NacaOutline       outline;
        const NacaOutline::Side side;
      };
    } // namespace



    template <int dim>
    std::unique_ptr<dealii::Manifold<dim>>
    naca_manifold(const NacaOutline &outline, const NacaOutline::Side side)
    {
      return std::make_unique<NacaManifold<dim>>(outline, side);
    }

    template std::unique_ptr<dealii::Manifold<2>>
    naca_manifold<2>(const NacaOutline &, const NacaOutline::Side);
    template std::unique_ptr<dealii::Manifold<3>>
    naca_manifold<3>(const NacaOutline &, const NacaOutline::Side);
  } // namespace Geometries
} // namespace Thalweg
