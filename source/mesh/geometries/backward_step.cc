// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/blocks.h>
#include <thalweg/mesh/geometries/tools.h>
#include <thalweg/mesh/geometry.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    const std::string step_model = "backward step";

    /// A channel that widens downwards at x = 0.
    template <int dim>
    class BackwardStep : public Geometry<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        section.add("Step height",
                    step_height,
                    "m",
                    "The step's face is at x = 0 and reaches from y = 0 up to "
                    "here.");
        section.add("Inlet height",
                    inlet_height,
                    "m",
                    "The height of the channel before the step. Equal heights "
                    "make the expansion ratio 2.");
        section.add("Inlet length",
                    inlet_length,
                    "m",
                    "The length of the channel before the step.");
        section.add("Outlet length",
                    outlet_length,
                    "m",
                    "The length of the channel behind the step.");
        section.add("Cell size",
                    cell_size,
                    "m",
                    "The coarse cells' target size at the step. Rows are as "
                    "high everywhere.");
        section.add("Inlet cell length",
                    inlet_cell,
                    "m",
                    "The coarse cells' target length at the inlet.");
        section.add("Outlet cell length",
                    outlet_cell,
                    "m",
                    "The coarse cells' target length at the outlet.");
        if (dim == 3)
          {
            section.add("Width",
                        width,
                        "m",
                        "The channel reaches from z = 0 to here.");
            section.add("Layers",
                        layers,
                        "",
                        "The number of coarse cells along z.",
                        dealii::Patterns::Integer(1));
          }
      }



      double
      n_cells() const override
      {
        check();
        using Geometries::n_graded;
        const double n_inlet  = n_graded(inlet_length, cell_size, inlet_cell);
        const double n_outlet = n_graded(outlet_length, cell_size, outlet_cell);
        const double n_above  = n_graded(inlet_height, cell_size, cell_size);
        const double n_below  = n_graded(step_height, cell_size, cell_size);
        return (n_inlet * n_above + n_outlet * (n_above + n_below)) *
               (dim == 3 ? layers : 1.);
      }



      void
      create(dealii::Triangulation<dim> &triangulation) const override
      {
        check();
        using Geometries::graded_lengths;
        using Geometries::positions;
        auto before = graded_lengths(inlet_length, cell_size, inlet_cell);
        std::reverse(before.begin(), before.end());
        auto inlet   = positions(-inlet_length, before);
        inlet.back() = 0.;
        const auto outlet =
          positions(0., graded_lengths(outlet_length, cell_size, outlet_cell));
        const auto below =
          positions(0., graded_lengths(step_height, cell_size, cell_size));
        const auto above =
          positions(step_height,
                    graded_lengths(inlet_height, cell_size, cell_size));

        Geometries::PlaneBlocks blocks(1e-3 * shortest());
        blocks.add_grid(inlet, above);
        blocks.add_grid(outlet, below);
        blocks.add_grid(outlet, above);
        dealii::Triangulation<2> section;
        blocks.create(section);
        Geometries::color_box(section,
                              dealii::Point<2>(-inlet_length, 0.),
                              dealii::Point<2>(outlet_length,
                                               step_height + inlet_height));
        // What lies on no side of the whole box is the step.
        for (const auto &face : section.active_face_iterators())
          if (face->at_boundary() && face->boundary_id() == 4)
            face->set_boundary_id(step);
        Geometries::extrude(
          section,
          positions(0., std::vector<double>(layers, width / layers)),
          triangulation,
          "The geometry '" + step_model + "'");
      }



      std::map<std::string, dealii::types::boundary_id>
      boundary_names() const override
      {
        return Geometries::sides_and<dim>({{"step", step}});
      }

    private:
      static constexpr dealii::types::boundary_id step =
        Geometries::first_own_id;

      void
      check() const
      {
        Geometries::check_positive(step_height, "Step height", step_model);
        Geometries::check_positive(inlet_height, "Inlet height", step_model);
        Geometries::check_positive(inlet_length, "Inlet length", step_model);
        Geometries::check_positive(outlet_length, "Outlet length", step_model);
        Geometries::check_positive(cell_size, "Cell size", step_model);
        Geometries::check_positive(inlet_cell, "Inlet cell length", step_model);
        Geometries::check_positive(outlet_cell,
                                   "Outlet cell length",
                                   step_model);
        Geometries::check_positive(width, "Width", step_model);
      }

      /// No cell is shorter than this.
      double
      shortest() const
      {
        return std::min({cell_size,
                         inlet_cell,
                         outlet_cell,
                         step_height,
                         inlet_height,
                         inlet_length,
                         outlet_length}) /
               4.;
      }

      double       step_height   = 1.;
      double       inlet_height  = 1.;
      double       inlet_length  = 4.;
      double       outlet_length = 30.;
      double       cell_size     = .5;
      double       inlet_cell    = 1.;
      double       outlet_cell   = 2.;
      double       width         = 4.;
      unsigned int layers        = 8;
    };
  } // namespace

  THALWEG_REGISTER(
    Geometry,
    BackwardStep,
    "backward step",
    "a channel along x that widens downwards at x = 0. Its boundaries are "
    "called left (inlet), right (outlet), top, bottom (the floor behind the "
    "step), step (the step's face and the floor before it), and in 3D front, "
    "back.")
} // namespace Thalweg
