// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/blocks.h>
#include <thalweg/mesh/geometries/tools.h>
#include <thalweg/mesh/geometry.h>

#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    const std::string channel_model = "cylinder in channel";

    /**
     * @brief A channel along x around a circular cylinder along z.
     *
     * The cylinder stands in a square of O-shaped blocks: rings about the
     * cylinder, which follow circles when they are refined, and one layer
     * from there to the square. All other cells are rectangles in rows and
     * columns that continue those of the square.
     */
    template <int dim>
    class CylinderInChannel : public Geometry<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override;

      double
      n_cells() const override;

      void
      create(dealii::Triangulation<dim> &triangulation) const override;

      std::map<std::string, dealii::types::boundary_id>
      boundary_names() const override
      {
        return Geometries::sides_and<dim>({{"cylinder", cylinder}});
      }

    private:
      static constexpr dealii::types::boundary_id cylinder =
        Geometries::first_own_id;

      void
      check() const;

      void
      check_distance(const double position,
                     const double extent,
                     const char  *direction) const;

      /// Blocks of rectangles around the square; the square's lines are
      /// centre + half_square * [-1, 1].
      void
      add_rectangles(Geometries::PlaneBlocks &blocks) const;

      void
      add_square(Geometries::PlaneBlocks &blocks) const;

      void
      color(dealii::Triangulation<2> &mesh) const;

      /// Gives the cells of the rings, with all their faces and lines, the
      /// manifold that follows circles.
      void
      attach_manifold(dealii::Triangulation<dim> &mesh) const;

      double
      half_square() const
      {
        return .5 * square_width * diameter;
      }

      double           length = dim == 2 ? 2.2 : 2.5;
      double           height = .41;
      double           width  = .41;
      unsigned int     layers = 4;
      dealii::Point<2> center{dim == 2 ? .2 : .5, .2};
      double           diameter     = .1;
      unsigned int     cells_around = 8;
      double           square_width = 2.;
      double           ring         = 1.4;
      unsigned int     ring_layers  = 1;
      double           ring_growth  = 1.5;
      double           stretching   = 2.;
    };



    template <int dim>
    void
    CylinderInChannel<dim>::declare_parameters(const Section &section)
    {
      section.add("Length", length, "m", "The channel reaches from x = 0.");
      section.add("Height", height, "m", "The channel reaches from y = 0.");
      if (dim == 3)
        {
          section.add("Width", width, "m", "The channel reaches from z = 0.");
          section.add("Layers",
                      layers,
                      "",
                      "The number of coarse cells along the cylinder.",
                      dealii::Patterns::Integer(1));
        }
      section.add("Centre",
                  center,
                  "m",
                  "Where the cylinder's axis passes through the plane of x and "
                  "y.");
      section.add("Diameter", diameter, "m", "The cylinder's diameter.");
      section.add("Cells around",
                  cells_around,
                  "",
                  "The number of coarse cells around the cylinder, a multiple "
                  "of eight. The rows and columns of the channel have the "
                  "width of a quarter of them on the square's sides.",
                  dealii::Patterns::Integer(8));
      section.add("Square width",
                  square_width,
                  "",
                  "The width in diameters of the square around the cylinder "
                  "outside of which cells are rectangles.");
      section.add("Ring diameter",
                  ring,
                  "",
                  "The outer diameter, in diameters of the cylinder, of the "
                  "cells that follow circles when they are refined.");
      section.add("Ring layers",
                  ring_layers,
                  "",
                  "The number of coarse cells between the cylinder and the "
                  "ring's outer circle.",
                  dealii::Patterns::Integer(1));
      section.add("Ring growth",
                  ring_growth,
                  "",
                  "Each of these layers is so many times as thick as the one "
                  "closer to the cylinder.");
      section.add("Stretching",
                  stretching,
                  "",
                  "How many times as long as at the square coarse cells are "
                  "at the inlet and the outlet.");
    }



    template <int dim>
    void
    CylinderInChannel<dim>::check_distance(const double position,
                                           const double extent,
                                           const char  *direction) const
    {
      const double half = half_square();
      if (position > half * (1 + 1e-6) && extent - position > half * (1 + 1e-6))
        return;
      std::ostringstream message;
      message << "In the geometry '" << channel_model << "' the square of "
              << 2. * half << " m about the cylinder's axis at " << direction
              << " = " << position << " m does not fit between " << direction
              << " = 0 and " << extent
              << " m. Move the 'Centre', or reduce 'Square width' below "
              << 2. * std::min(position, extent - position) / diameter << '.';
      AssertThrow(false, dealii::ExcMessage(message.str()));
    }



    template <int dim>
    void
    CylinderInChannel<dim>::check() const
    {
      Geometries::check_positive(length, "Length", channel_model);
      Geometries::check_positive(height, "Height", channel_model);
      Geometries::check_positive(width, "Width", channel_model);
      Geometries::check_positive(diameter, "Diameter", channel_model);
      Geometries::check_positive(ring_growth, "Ring growth", channel_model);
      Geometries::check_positive(stretching, "Stretching", channel_model);
      AssertThrow(cells_around >= 8 && cells_around % 8 == 0,
                  dealii::ExcMessage("The 'Cells around' of the geometry '" +
                                     channel_model + "' are " +
                                     std::to_string(cells_around) +
                                     "; they must be a multiple of eight."));
      AssertThrow(ring > 1. && ring < .95 * square_width,
                  dealii::ExcMessage(
                    "The 'Ring diameter' of the geometry '" + channel_model +
                    "' is " + std::to_string(ring) +
                    " cylinder diameters; it must be greater than 1 and less "
                    "than 0.95 times the 'Square width'."));
      check_distance(center[0], length, "x");
      check_distance(center[1], height, "y");
    }



    template <int dim>
    void
    CylinderInChannel<dim>::add_rectangles(
      Geometries::PlaneBlocks &blocks) const
    {
      using Geometries::graded_lengths;
      using Geometries::positions;
      const unsigned int n = cells_around / 4;
      const double       a = half_square(), h = 2. * a / n;
      const double       far = stretching * h;

      auto before = graded_lengths(center[0] - a, h, far);
      std::reverse(before.begin(), before.end());
      const auto upstream = positions(0., before);
      const auto beside   = positions(center[0] - a, std::vector<double>(n, h));
      const auto downstream =
        positions(center[0] + a,
                  graded_lengths(length - center[0] - a, h, far));
      const auto below  = positions(0., graded_lengths(center[1] - a, h, h));
      const auto middle = positions(center[1] - a, std::vector<double>(n, h));
      const auto above =
        positions(center[1] + a, graded_lengths(height - center[1] - a, h, h));
      for (const auto &x : {upstream, downstream})
        for (const auto &y : {below, middle, above})
          blocks.add_grid(x, y);
      blocks.add_grid(beside, below);
      blocks.add_grid(beside, above);
    }



    template <int dim>
    void
    CylinderInChannel<dim>::add_square(Geometries::PlaneBlocks &blocks) const
    {
      const unsigned int n = cells_around / 4;
      const double       a = half_square();
      // Anticlockwise around the axis from -45 degrees on: the square's
      // vertices, which are those of its neighbours, and directions at equal
      // angles.
      std::vector<dealii::Tensor<1, 2>> square, circle;
      for (unsigned int i = 0; i <= cells_around; ++i)
        {
          const double t = (2. * (i % n)) / n - 1.;
          const double angle =
            (2. * i / cells_around - .25) * dealii::numbers::PI;
          const double corner[4][2] = {{1, t}, {-t, 1}, {-1, -t}, {t, -1}};
          const auto  &p            = corner[(i / n) % 4];
          square.push_back(dealii::Point<2>(a * p[0], a * p[1]));
          circle.push_back(dealii::Point<2>(std::cos(angle), std::sin(angle)));
        }
      const auto radii =
        Geometries::positions(.5 * diameter,
                              Geometries::geometric_lengths(.5 * (ring - 1.) *
                                                              diameter,
                                                            ring_growth,
                                                            ring_layers));
      const auto point = [&](const unsigned int i, const unsigned int l) {
        return center + (l < radii.size() ? radii[l] * circle[i] : square[i]);
      };
      for (unsigned int i = 1; i <= cells_around; ++i)
        {
          // To the right and below, the direction along the circle is that of
          // the rectangles' lines; above and to the left it is opposite.
          const unsigned int side  = (i - 1) / n;
          const bool         along = side == 0 || side == 3;
          for (unsigned int l = 1; l <= radii.size(); ++l)
            if (along)
              blocks.add_cell(point(i - 1, l - 1),
                              point(i - 1, l),
                              point(i, l),
                              point(i, l - 1));
            else
              blocks.add_cell(point(i, l - 1),
                              point(i - 1, l - 1),
                              point(i - 1, l),
                              point(i, l));
        }
    }



    template <int dim>
    void
    CylinderInChannel<dim>::color(dealii::Triangulation<2> &mesh) const
    {
      Geometries::color_box(mesh,
                            dealii::Point<2>(),
                            dealii::Point<2>(length, height));
      for (const auto &face : mesh.active_face_iterators())
        if (face->at_boundary() &&
            face->center().distance(center) < half_square())
          face->set_boundary_id(cylinder);
    }



    template <int dim>
    void
    CylinderInChannel<dim>::attach_manifold(
      dealii::Triangulation<dim> &mesh) const
    {
      constexpr dealii::types::manifold_id circles = 1;
      for (const auto &cell : mesh.cell_iterators_on_level(0))
        {
          bool inside = true;
          for (const unsigned int v : cell->vertex_indices())
            inside = inside && std::hypot(cell->vertex(v)[0] - center[0],
                                          cell->vertex(v)[1] - center[1]) <
                                 .5 * ring * diameter * (1. + 1e-6);
          if (inside)
            cell->set_all_manifold_ids(circles);
        }
      if constexpr (dim == 2)
        mesh.set_manifold(circles, dealii::PolarManifold<2>(center));
      else
        mesh.set_manifold(circles,
                          dealii::CylindricalManifold<3>(
                            dealii::Tensor<1, 3>({0., 0., 1.}),
                            dealii::Point<3>(center[0], center[1], 0.)));
    }



    template <int dim>
    double
    CylinderInChannel<dim>::n_cells() const
    {
      check();
      const double h   = 8. * half_square() / cells_around;
      const double n_x = Geometries::n_graded(length, h, stretching * h);
      const double n_y = height / h;
      return (n_x * n_y + double(cells_around) * ring_layers) *
             (dim == 3 ? layers : 1.);
    }



    template <int dim>
    void
    CylinderInChannel<dim>::create(
      dealii::Triangulation<dim> &triangulation) const
    {
      check();
      Geometries::PlaneBlocks blocks(1e-6 * diameter / cells_around);
      add_rectangles(blocks);
      add_square(blocks);
      dealii::Triangulation<2> section;
      blocks.create(section);
      color(section);
      Geometries::extrude(
        section,
        Geometries::positions(0., std::vector<double>(layers, width / layers)),
        triangulation,
        "The geometry '" + channel_model + "'");
      attach_manifold(triangulation);
    }
  } // namespace

  THALWEG_REGISTER(
    Geometry,
    CylinderInChannel,
    "cylinder in channel",
    "a channel along x around a circular cylinder along z; its defaults are "
    "the benchmark of Schaefer and Turek (1996). Its boundaries are called "
    "left (inlet), right (outlet), bottom, top, cylinder, and in 3D front, "
    "back. Cells are finest at the cylinder and grow towards the inlet and "
    "the outlet.")
} // namespace Thalweg
