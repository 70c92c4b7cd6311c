// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/grain_table.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// How a heap of grains looks at a moment.
    struct PileShape
    {
      double height  = 0.; ///< m
      double run_out = 0.; ///< m
      double bulk    = 0.; ///< distance within which most of the mass is, m
      double slope   = 0.; ///< degrees
    };



    /// A grain of a heap: how far from its middle, how high, and how heavy.
    struct PileGrain
    {
      double distance, top, mass;
    };



    /// The slope of a straight line through the tops between a fifth and four
    /// fifths of the height, degrees. @param width of each of @p tops, m
    double
    slope_of(const std::vector<double> &tops,
             const double               height,
             const double               width)
    {
      double n = 0., x = 0., y = 0., xx = 0., xy = 0.;
      for (std::size_t b = 0; b < tops.size(); ++b)
        if (tops[b] > .2 * height && tops[b] < .8 * height)
          {
            const double at = (b + .5) * width;
            n += 1.;
            x += at;
            y += tops[b];
            xx += at * at;
            xy += at * tops[b];
          }
      const double determinant = n * xx - x * x;
      return n < 2. ? 0.
                    : std::atan(-(n * xy - x * y) / determinant) * 180. / M_PI;
    }



    /// @param tops the highest of each distance, 0 where there are no grains
    /// @param masses at each distance, kg
    PileShape
    shape_of(const std::vector<double> &tops,
             const std::vector<double> &masses,
             const double               width,
             const double               part)
    {
      PileShape shape;
      double    all = 0., sum = 0.;
      for (const double mass : masses)
        all += mass;
      for (std::size_t b = 0; b < tops.size(); ++b)
        {
          shape.height = std::max(shape.height, tops[b]);
          if (sum < part * all)
            shape.bulk = (b + 1.) * width;
          sum += masses[b];
        }
      // Those that rolled away alone are behind a gap.
      for (std::size_t b = 0; b < tops.size() && tops[b] > 0.; ++b)
        shape.run_out = (b + 1.) * width;
      shape.slope = slope_of(tops, shape.height, width);
      return shape;
    }



    /// Height, run-out and slope of a heap.
    template <int dim>
    class GrainPile : public GrainRows<dim>
    {
    public:
      GrainPile()
        : GrainRows<dim>("pile")
      {}

      void
      declare_parameters(const Section &section) override
      {
        using namespace dealii::Patterns;
        GrainRows<dim>::declare_parameters(section);
        section.add("Center",
                    center,
                    "m",
                    "From where distances count, on the ground; nothing: the "
                    "lower corner of the domain.",
                    List(Double()));
        section.add("Upwards",
                    upwards,
                    "",
                    "The axis along which heights count; nothing: the last.",
                    Selection("|x|y|z"));
        section.add("Along",
                    along,
                    "",
                    "The axes along which distances count: `x`, or `x, y`; "
                    "nothing: all but that of heights.",
                    List(Selection("x|y|z")));
        section.add("Width",
                    width,
                    "m",
                    "Grains are sorted into intervals of distance of this "
                    "width; 0: a 200th of the domain's largest side.",
                    Double(0));
        section.add("Part",
                    part,
                    "",
                    "Of the mass, for the distance within which it is.",
                    Double(0, 1));
      }

      void
      check(const RunOutline<dim> &outline) const override
      {
        GrainTable<dim>::check(outline);
        AssertThrow(center.empty() || center.size() == dim,
                    dealii::ExcMessage("'Postprocess/pile/Center' needs " +
                                       std::to_string(dim) + " numbers."));
        for (const std::string &axis : along)
          AssertThrow(number_of(axis) < dim && number_of(axis) != up(),
                      dealii::ExcMessage(
                        "'Postprocess/pile/Along' has '" + axis +
                        "', along which there are no distances: heights are "
                        "along '" +
                        std::string(1, "xyz"[up()]) + "'."));
        AssertThrow(up() < dim,
                    dealii::ExcMessage("'Postprocess/pile/Upwards' is 'z', "
                                       "which two dimensions do not have."));
      }

    private:
      std::vector<std::string>
      columns(const GrainView &) const override
      {
        return {"time [s]",
                "height [m]",
                "run-out [m]",
                "distance of the given part of the mass [m]",
                "slope [degrees]"};
      }

      std::vector<double>
      row(const MPI_Comm   communicator,
          const Mesh<dim> &mesh,
          const GrainView &view) const override
      {
        const auto &[low, high] = mesh.box();
        double largest          = 0.;
        for (unsigned int d = 0; d < dim; ++d)
          largest = std::max(largest, high[d] - low[d]);
        const double        w = width > 0. ? width : largest / 200.;
        const std::size_t   n = 1 + std::ceil(std::sqrt(3.) * largest / w);
        std::vector<double> tops(n, 0.), masses(n, 0.);
        for (const PileGrain &grain : grains_of(view, low))
          {
            const auto b = std::min<std::size_t>(n - 1, grain.distance / w);
            tops[b]      = std::max(tops[b], grain.top);
            masses[b] += grain.mass;
          }
        MPI_Allreduce(
          MPI_IN_PLACE, tops.data(), n, MPI_DOUBLE, MPI_MAX, communicator);
        dealii::Utilities::MPI::sum(masses, communicator, masses);
        const PileShape shape = shape_of(tops, masses, w, part);
        return {shape.height, shape.run_out, shape.bulk, shape.slope};
      }

      static unsigned int
      number_of(const std::string &axis)
      {
        return axis[0] - 'x';
      }

      unsigned int
      up() const
      {
        return upwards.empty() ? dim - 1 : number_of(upwards);
      }

      std::vector<PileGrain>
      grains_of(const GrainView &view, const dealii::Point<dim> &low) const
      {
        std::vector<PileGrain> all;
        const GrainArrays     &grains = view.system.grains();
        for (const std::uint32_t i : view.system.own())
          {
            const Vec3  &x = grains.place[i].x;
            const double at[]{x.x, x.y, x.z};
            double       square = 0.;
            for (unsigned int d = 0; d < dim; ++d)
              if (d != up() &&
                  (along.empty() ||
                   std::find(along.begin(),
                             along.end(),
                             std::string(1, "xyz"[d])) != along.end()))
                square += std::pow(at[d] - origin(low, d), 2);
            all.push_back({std::sqrt(square),
                           at[up()] + grains.place[i].r - origin(low, up()),
                           1. / grains.momentum[i].inverse_mass});
          }
        return all;
      }

      double
      origin(const dealii::Point<dim> &low, const unsigned int d) const
      {
        return center.empty() ? low[d] : center[d];
      }

      std::vector<double>      center;
      std::string              upwards;
      std::vector<std::string> along;
      double                   width = 0., part = .95;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   GrainPile,
                   "pile",
                   "how high, wide and steep a heap of grains is; writes "
                   "METHOD_pile.csv.")
} // namespace Thalweg
