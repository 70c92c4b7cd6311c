// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/blocks.h>
#include <thalweg/mesh/geometries/naca.h>
#include <thalweg/mesh/geometries/tools.h>
#include <thalweg/mesh/geometry.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    const std::string naca = "airfoil";

    /**
     * @brief The flow around an airfoil, meshed in the shape of a C.
     *
     * Lines of the mesh leave the airfoil at right angles and end on a half
     * circle about the trailing edge or on the straight upper and lower
     * boundaries behind it; they are divided into layers that grow outwards.
     * Behind the trailing edge the blocks of both sides meet in the wake.
     */
    template <int dim>
    class Airfoil : public Geometry<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override;

      double
      n_cells() const override
      {
        check();
        const double last   = 1. - std::pow(place(cells_a_side - 1), 2);
        const double n_wake = Geometries::n_graded(wake, last, outlet_length);
        return 2. * (cells_a_side + n_wake) * layers *
               (dim == 3 ? span_cells : 1.);
      }

      void
      create(dealii::Triangulation<dim> &triangulation) const override;

      std::map<std::string, dealii::types::boundary_id>
      boundary_names() const override
      {
        return Geometries::sides_and<dim>({{"inflow", inflow},
                                           {"outflow", outflow},
                                           {"airfoil", airfoil}},
                                          {"left", "right", "bottom", "top"});
      }

    private:
      static constexpr dealii::types::boundary_id inflow  = 0;
      static constexpr dealii::types::boundary_id outflow = 1;
      static constexpr dealii::types::boundary_id airfoil =
        Geometries::first_own_id;

      using Points = std::vector<dealii::Point<2>>;
      using Side   = Geometries::NacaOutline::Side;

      void
      check() const;

      /// Refuses coarse cells whose outer face is straight while their inner
      /// one would come too close to it when it follows the outline.
      void
      check_curvature(const Geometries::NacaOutline &outline) const;

      /// The root of the place on the chord (NacaOutline) of vertex @p i of
      /// those from the leading to the trailing edge.
      double
      place(const unsigned int i) const;

      /// The points of a line away from the airfoil, number @p i of those
      /// from the leading to the trailing edge.
      Points
      line_from_airfoil(const Geometries::NacaOutline &outline,
                        const Side                     side,
                        const unsigned int             i) const;

      /// The points of a line across the wake's half at @p x.
      Points
      line_from_wake(const Side side, const double x) const;

      void
      add_side(Geometries::PlaneBlocks       &blocks,
               const Geometries::NacaOutline &outline,
               const Side                     side) const;

      void
      color(dealii::Triangulation<2> &mesh) const;

      /// Lets boundary faces on the airfoil follow its outline.
      void
      attach_manifolds(dealii::Triangulation<dim>    &mesh,
                       const Geometries::NacaOutline &outline) const;

      std::string  naca          = "0012";
      double       chord         = 1.;
      double       far_field     = 8.;
      double       wake          = 10.;
      unsigned int cells_a_side  = 10;
      unsigned int layers        = 10;
      double       first_layer   = .03;
      double       outlet_length = 2.;
      double       width         = 1.;
      unsigned int span_cells    = 4;
    };



    template <int dim>
    void
    Airfoil<dim>::declare_parameters(const Section &section)
    {
      section.add("NACA",
                  naca,
                  "",
                  "The four digits of the airfoil. Its leading edge is at the "
                  "origin, its chord on the x axis; an angle of attack is "
                  "given by the direction of the inflow.",
                  dealii::Patterns::Anything());
      section.add("Chord", chord, "m", "The airfoil's length.");
      section.add("Far field",
                  far_field,
                  "chords",
                  "The radius of the half circle about the trailing edge "
                  "where the inflow begins; the upper and the lower boundary "
                  "are as far away.");
      section.add("Wake length",
                  wake,
                  "chords",
                  "The distance from the trailing edge to the outflow.");
      section.add("Cells a side",
                  cells_a_side,
                  "",
                  "The number of coarse cells along the upper and along the "
                  "lower side, densest at both edges.",
                  dealii::Patterns::Integer(3));
      section.add("Layers",
                  layers,
                  "",
                  "The number of coarse cells from the airfoil to the far "
                  "field.",
                  dealii::Patterns::Integer(2));
      section.add("First layer",
                  first_layer,
                  "chords",
                  "The thickness of the coarse cells at the airfoil.");
      section.add("Outlet cell length",
                  outlet_length,
                  "chords",
                  "The length of coarse cells at the outflow.");
      if (dim == 3)
        {
          section.add("Width",
                      width,
                      "m",
                      "The extent in z, from zero, of the airfoil and the "
                      "domain.");
          section.add("Span cells",
                      span_cells,
                      "",
                      "The number of coarse cells along z.",
                      dealii::Patterns::Integer(1));
        }
    }



    template <int dim>
    void
    Airfoil<dim>::check() const
    {
      Geometries::check_positive(chord, "Chord", naca);
      Geometries::check_positive(width, "Width", naca);
      Geometries::check_positive(outlet_length, "Outlet cell length", naca);
      AssertThrow(far_field >= 2. && wake >= 1.,
                  dealii::ExcMessage(
                    "The domain of the geometry '" + naca +
                    "' is too small: 'Far field' must be at least 2 chords "
                    "and 'Wake length' at least 1."));
      AssertThrow(first_layer > 0. && first_layer * layers < far_field,
                  dealii::ExcMessage(
                    "The 'First layer' of the geometry '" + naca +
                    "' must be thicker than zero, and so thin that layers can "
                    "grow to the far field: less than " +
                    std::to_string(far_field / layers) + " chords."));
    }



    template <int dim>
    double
    Airfoil<dim>::place(const unsigned int i) const
    {
      // Even roots are dense at the leading edge, sines also at the trailing
      // edge, but they alone would leave slivers there.
      const double t = double(i) / cells_a_side;
      return i == cells_a_side
               ? 1.
               : .3 * t + .7 * std::sin(.5 * dealii::numbers::PI * t);
    }



    template <int dim>
    void
    Airfoil<dim>::check_curvature(const Geometries::NacaOutline &outline) const
    {
      double height = 0.;
      for (unsigned int i = 1; i <= cells_a_side; ++i)
        height = std::max(height, outline.rise(place(i - 1), place(i)));
      std::ostringstream message;
      message << "In the geometry '" << naca << "' the outline rises "
              << height / chord
              << " chords above the line between two coarse vertices, too much "
                 "for cells of "
              << first_layer
              << " chords. Raise 'Cells a side', or make 'First layer' more "
                 "than "
              << 3. * height / chord << '.';
      AssertThrow(height <= first_layer * chord / 3.,
                  dealii::ExcMessage(message.str()));
    }



    template <int dim>
    typename Airfoil<dim>::Points
    Airfoil<dim>::line_from_airfoil(const Geometries::NacaOutline &outline,
                                    const Side                     side,
                                    const unsigned int             i) const
    {
      const double right  = .5 * dealii::numbers::PI;
      const double t      = double(i) / cells_a_side;
      const double s      = place(i);
      const double radius = far_field * chord;
      const double sign   = side == Side::upper ? 1. : -1.;
      const auto   foot   = outline.point(side, s);
      const auto   n      = outline.normal(side, s);
      // From the direction against the flow (0) to upright (pi/2), between
      // the normal's direction and an even distribution over the half circle.
      const double own = i == 0 ? 0. : std::atan2(sign * n[1], -n[0]);
      const double angle =
        i == cells_a_side ? right : .2 * std::min(own, right) + .8 * right * t;
      const dealii::Point<2> end(chord - radius * std::cos(angle),
                                 sign * radius * std::sin(angle));
      // Upright where the normal leans backwards, so that no line crosses the
      // one at the trailing edge.
      const dealii::Tensor<1, 2> departure = i == 0 ? dealii::Point<2>(-1., 0.)
                                             : n[0] >= 0.
                                               ? dealii::Point<2>(0., sign)
                                               : dealii::Point<2>(n);
      // Halfway, so that a straight line's points keep their distances.
      const auto bend = foot + .5 * radius * departure;

      Points points;
      for (const double d :
           Geometries::geometric_positions(radius, first_layer * chord, layers))
        {
          const double u = d / radius, v = 1. - u;
          points.push_back(
            dealii::Point<2>(v * v * foot + 2. * u * v * bend + u * u * end));
        }
      return points;
    }



    template <int dim>
    typename Airfoil<dim>::Points
    Airfoil<dim>::line_from_wake(const Side side, const double x) const
    {
      const double sign   = side == Side::upper ? 1. : -1.;
      const double radius = far_field * chord;
      // The wake grows wider, and so may its cells.
      const double behind = (x - chord) / (wake * chord);
      const double even   = radius / layers;
      const double first =
        std::min(first_layer * chord * (1. + 4. * behind), even);
      Points points;
      for (const double d :
           Geometries::geometric_positions(radius, first, layers))
        points.emplace_back(x, sign * d);
      return points;
    }



    template <int dim>
    void
    Airfoil<dim>::add_side(Geometries::PlaneBlocks       &blocks,
                           const Geometries::NacaOutline &outline,
                           const Side                     side) const
    {
      std::vector<Points> lines;
      for (unsigned int i = 0; i <= cells_a_side; ++i)
        lines.push_back(line_from_airfoil(outline, side, i));
      // The same for both sides, so that they meet in the wake.
      const double last = chord * (1. - std::pow(place(cells_a_side - 1), 2));
      const auto   x =
        Geometries::positions(chord,
                              Geometries::graded_lengths(wake * chord,
                                                         1.2 * last,
                                                         outlet_length *
                                                           chord));
      for (unsigned int i = 1; i < x.size(); ++i)
        lines.push_back(line_from_wake(side, x[i]));

      for (unsigned int i = 1; i < lines.size(); ++i)
        for (unsigned int l = 1; l <= layers; ++l)
          {
            const auto &a = lines[i - 1], &b = lines[i];
            if (side == Side::upper)
              blocks.add_cell(a[l - 1], b[l - 1], b[l], a[l]);
            else
              blocks.add_cell(a[l - 1], a[l], b[l], b[l - 1]);
          }
    }



    template <int dim>
    void
    Airfoil<dim>::color(dealii::Triangulation<2> &mesh) const
    {
      const double end = (1. + wake) * chord;
      for (const auto &face : mesh.active_face_iterators())
        if (face->at_boundary())
          {
            const auto center = face->center();
            if (std::abs(center[0] - end) < 1e-6 * chord)
              face->set_boundary_id(outflow);
            else if (center.distance(dealii::Point<2>(chord, 0.)) < 1.3 * chord)
              face->set_boundary_id(airfoil);
            else
              face->set_boundary_id(inflow);
          }
    }



    template <int dim>
    void
    Airfoil<dim>::attach_manifolds(dealii::Triangulation<dim>    &mesh,
                                   const Geometries::NacaOutline &outline) const
    {
      for (const auto &cell : mesh.cell_iterators_on_level(0))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == airfoil)
            {
              // The sides of a face's cell tell which it is: the upper
              // side's cells reach further up than the face.
              const bool upper = cell->center()[1] > face->center()[1];
              face->set_all_manifold_ids(upper ? 1 : 2);
            }
      mesh.set_manifold(1,
                        *Geometries::naca_manifold<dim>(outline, Side::upper));
      mesh.set_manifold(2,
                        *Geometries::naca_manifold<dim>(outline, Side::lower));
    }



    template <int dim>
    void
    Airfoil<dim>::create(dealii::Triangulation<dim> &triangulation) const
    {
      check();
      const Geometries::NacaOutline outline(naca, chord);
      check_curvature(outline);
      Geometries::PlaneBlocks blocks(1e-9 * chord);
      add_side(blocks, outline, Side::upper);
      add_side(blocks, outline, Side::lower);
      dealii::Triangulation<2> section;
      blocks.create(section);
      color(section);
      Geometries::extrude(
        section,
        Geometries::positions(
          0., std::vector<double>(span_cells, width / span_cells)),
        triangulation,
        "The geometry '" + naca + "'");
      attach_manifolds(triangulation, outline);
    }
  } // namespace

  THALWEG_REGISTER(
    Geometry,
    Airfoil,
    "airfoil",
    "a wide domain around a NACA airfoil of the four-digit series with a "
    "sharp trailing edge. Its boundaries are called inflow (in front, above "
    "and below), outflow (behind), airfoil, and in 3D front, back. Cells are "
    "finest at the airfoil.")
} // namespace Thalweg
