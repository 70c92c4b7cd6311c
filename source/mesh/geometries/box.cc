// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/tools.h>
#include <thalweg/mesh/geometry.h>

#include <deal.II/grid/grid_generator.h>

namespace Thalweg
{
  namespace
  {
    /// A box of equal cells.
    template <int dim>
    class Box : public Geometry<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        for (unsigned int d = 0; d < dim; ++d)
          {
            upper[d]       = 1.;
            repetitions[d] = 1;
          }
        section.add("Lower corner",
                    lower,
                    "m",
                    "The corner with the least coordinates.");
        section.add("Upper corner",
                    upper,
                    "m",
                    "The corner with the greatest coordinates.");
        section.add("Repetitions",
                    repetitions,
                    "",
                    "The number of coarse cells in each direction.",
                    dealii::Patterns::List(dealii::Patterns::Integer(1),
                                           dim,
                                           dim));
      }


      double
      n_cells() const override
      {
        return Geometries::n_cells(repetitions);
      }


      void
      create(dealii::Triangulation<dim> &triangulation) const override
      {
        Geometries::check_corners(lower, upper, "The box");
        dealii::GridGenerator::subdivided_hyper_rectangle(
          triangulation, repetitions, lower, upper, true);
      }


      std::map<std::string, dealii::types::boundary_id>
      boundary_names() const override
      {
        return Geometries::box_sides<dim>();
      }

    private:
      dealii::Point<dim>        lower;
      dealii::Point<dim>        upper;
      std::vector<unsigned int> repetitions = std::vector<unsigned int>(dim, 1);
    };
  } // namespace

  THALWEG_REGISTER(Geometry,
                   Box,
                   "box",
                   "an axis-parallel box of equal cells. Its boundaries are "
                   "called left, right (x), bottom, top (y), and in 3D front, "
                   "back (z), in the order of increasing coordinates.")
} // namespace Thalweg
