// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/tools.h>
#include <thalweg/mesh/geometry.h>

#include <deal.II/grid/grid_generator.h>

#include <set>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    /// A box without some smaller boxes, meshed by lines through their faces.
    template <int dim>
    class BoxWithObstacles : public Geometry<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        for (unsigned int d = 0; d < dim; ++d)
          upper[d] = 1.;
        section.add("Lower corner",
                    lower,
                    "m",
                    "The corner with the least coordinates.");
        section.add("Upper corner",
                    upper,
                    "m",
                    "The corner with the greatest coordinates.");
        section.add("Cell size",
                    cell_size,
                    "m",
                    "The coarse cells' target size in all directions. Grid "
                    "lines pass through all faces of obstacles, and the space "
                    "between two of them is divided evenly.");
        section.add(
          "Obstacles",
          obstacles,
          "m",
          "Axis-parallel boxes that are cut out, each as 'least corner : "
          "greatest corner', separated by semicolons, for example " +
            std::string(dim == 2
                          ? "'0.292, 0 : 0.316, 0.048; 0.4, 0 : 0.42, 0.02'."
                          : "'0.66, 0, 0.29 : 0.82, 0.16, 0.69'."));
      }


      double
      n_cells() const override
      {
        check();
        double n = 1.;
        for (unsigned int d = 0; d < dim; ++d)
          n *= std::max(1., (upper[d] - lower[d]) / cell_size);
        return n;
      }


      void
      create(dealii::Triangulation<dim> &triangulation) const override
      {
        check();
        std::vector<std::vector<double>> steps;
        for (unsigned int d = 0; d < dim; ++d)
          {
            std::vector<double> faces;
            for (const auto &[first, second] : obstacles)
              {
                faces.push_back(first[d]);
                faces.push_back(second[d]);
              }
            steps.push_back(
              Geometries::divide(lower[d], upper[d], faces, cell_size));
          }

        dealii::Triangulation<dim> full;
        dealii::GridGenerator::subdivided_hyper_rectangle(full,
                                                          steps,
                                                          lower,
                                                          upper);
        std::set<typename dealii::Triangulation<dim>::active_cell_iterator>
          removed;
        for (const auto &cell : full.active_cell_iterators())
          if (is_inside_obstacle(cell->center()))
            removed.insert(cell);
        AssertThrow(removed.size() < full.n_active_cells(),
                    dealii::ExcMessage(
                      "The obstacles of the geometry 'box with obstacles' "
                      "fill the whole box; nothing is left to compute in."));

        // The tool for removing cells does not take an empty list.
        dealii::Triangulation<dim> rest;
        if (removed.empty())
          rest.copy_triangulation(full);
        else
          dealii::GridGenerator::create_triangulation_with_removed_cells(
            full, removed, rest);
        Geometries::color_box(rest, lower, upper);
        Geometries::copy_coarse_mesh(rest,
                                     triangulation,
                                     "The geometry 'box with obstacles'");
      }


      std::map<std::string, dealii::types::boundary_id>
      boundary_names() const override
      {
        auto names = Geometries::box_sides<dim>();
        if (!obstacles.empty())
          names["obstacle"] = 2 * dim;
        return names;
      }

    private:
      void
      check() const
      {
        Geometries::check_corners(lower, upper, "The box");
        AssertThrow(cell_size > 0.,
                    dealii::ExcMessage(
                      "The 'Cell size' of the geometry 'box with obstacles' "
                      "must be greater than zero."));
        for (const auto &[first, second] : obstacles)
          {
            Geometries::check_corners(first, second, "The obstacle");
            for (unsigned int d = 0; d < dim; ++d)
              if (second[d] <= lower[d] || first[d] >= upper[d])
                {
                  std::ostringstream message;
                  message << "The obstacle from (" << first << ") to ("
                          << second << ") lies outside the box from (" << lower
                          << ") to (" << upper << "); move it or leave it out.";
                  AssertThrow(false, dealii::ExcMessage(message.str()));
                }
          }
      }


      bool
      is_inside_obstacle(const dealii::Point<dim> &point) const
      {
        for (const auto &[first, second] : obstacles)
          {
            bool inside = true;
            for (unsigned int d = 0; d < dim; ++d)
              inside = inside && first[d] < point[d] && point[d] < second[d];
            if (inside)
              return true;
          }
        return false;
      }


      dealii::Point<dim> lower;
      dealii::Point<dim> upper;
      double             cell_size = 0.1;
      std::vector<std::pair<dealii::Point<dim>, dealii::Point<dim>>> obstacles;
    };
  } // namespace

  THALWEG_REGISTER(Geometry,
                   BoxWithObstacles,
                   "box with obstacles",
                   "an axis-parallel box without some smaller boxes. "
                   "Boundaries as for 'box', and 'obstacle'.")
} // namespace Thalweg
