// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/tools.h>
#include <thalweg/mesh/geometry.h>

#include <deal.II/grid/grid_generator.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// A box whose upper side is a lid.
    template <int dim>
    class Cavity : public Geometry<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        for (unsigned int d = 0; d < dim; ++d)
          size[d] = 1.;
        section.add("Size",
                    size,
                    "m",
                    "The corner with the greatest coordinates; that with the "
                    "least is the origin.");
        section.add("Repetitions",
                    repetitions,
                    "",
                    "The number of coarse cells in each direction.",
                    dealii::Patterns::List(dealii::Patterns::Integer(1),
                                           dim,
                                           dim));
        section.add("Grading",
                    grading,
                    "",
                    "How much coarse cells are drawn to the sides: lines are "
                    "at tanh(g t) / tanh(g) for even t from -1 to 1. Zero: "
                    "all cells are equal; with 1.5 those at the sides of many "
                    "are a fifth as wide as those in the middle.",
                    dealii::Patterns::Double(0., 5.));
      }



      double
      n_cells() const override
      {
        return Geometries::n_cells(repetitions);
      }


      void
      create(dealii::Triangulation<dim> &triangulation) const override
      {
        Geometries::check_corners(dealii::Point<dim>(), size, "The cavity");
        std::vector<std::vector<double>> steps;
        for (unsigned int d = 0; d < dim; ++d)
          {
            steps.emplace_back();
            for (unsigned int i = 0; i < repetitions[d]; ++i)
              steps.back().push_back(size[d] *
                                     (position(double(i + 1) / repetitions[d]) -
                                      position(double(i) / repetitions[d])));
          }
        dealii::Triangulation<dim> box;
        dealii::GridGenerator::subdivided_hyper_rectangle(box,
                                                          steps,
                                                          dealii::Point<dim>(),
                                                          size);
        Geometries::color_box(box, dealii::Point<dim>(), size);
        for (const auto &face : box.active_face_iterators())
          if (face->at_boundary() && face->boundary_id() < lid)
            face->set_boundary_id(walls);
        Geometries::copy_coarse_mesh(box,
                                     triangulation,
                                     "The geometry 'cavity'");
      }



      std::map<std::string, dealii::types::boundary_id>
      boundary_names() const override
      {
        auto names = Geometries::box_sides<dim>();
        for (const char *side : {"left", "right", "bottom", "top"})
          names.erase(side);
        names["walls"] = walls;
        names["lid"]   = lid;
        return names;
      }

    private:
      static constexpr dealii::types::boundary_id walls = 0;
      static constexpr dealii::types::boundary_id lid   = 3;

      /// From 0 to 1, where lines at even @p t from 0 to 1 go.
      double
      position(const double t) const
      {
        if (grading < 1e-6)
          return t;
        return .5 +
               .5 * std::tanh(grading * (2. * t - 1.)) / std::tanh(grading);
      }

      dealii::Point<dim>        size;
      std::vector<unsigned int> repetitions = std::vector<unsigned int>(dim, 4);
      double                    grading     = 0.;
    };
  } // namespace

  THALWEG_REGISTER(
    Geometry,
    Cavity,
    "cavity",
    "an axis-parallel box whose upper side is a lid. Its boundaries are "
    "called lid, walls (left, right and bottom), and in 3D front, back.")
} // namespace Thalweg
