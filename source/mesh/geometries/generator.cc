// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/plain_text.h>
#include <thalweg/core/trial.h>
#include <thalweg/mesh/geometries/tools.h>
#include <thalweg/mesh/geometry.h>

#include <deal.II/grid/grid_generator.h>

namespace Thalweg
{
  namespace
  {
    /// Any mesh that deal.II can generate.
    template <int dim>
    class Generator : public Geometry<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        section.add("Function",
                    function,
                    "",
                    "The name of a function of deal.II's GridGenerator.");
        section.add("Arguments",
                    arguments,
                    "",
                    "All its arguments after the triangulation, optional "
                    "ones too, separated by colons; the coordinates of a "
                    "point by commas.");
      }


      void
      create(dealii::Triangulation<dim> &triangulation) const override
      {
        const std::string what = "The geometry '" + excerpt(function) + "'";
        dealii::Triangulation<dim> mesh;
        // Some functions take any number, and crash or never end.
        if (!was_tried)
          {
            const std::string fault = fault_in_trial([this]() {
              dealii::Triangulation<dim> trial;
              generate(trial);
            });
            AssertThrow(fault.empty(),
                        dealii::ExcMessage(
                          what + " with the arguments '" + excerpt(arguments) +
                          "' cannot be generated in " + std::to_string(dim) +
                          " dimensions. Compare the function's name and "
                          "arguments with deal.II's documentation of "
                          "GridGenerator. What went wrong:\n" +
                          bounded_message(fault, 1000)));
            was_tried = true;
          }
        generate(mesh);
        Geometries::copy_coarse_mesh(mesh, triangulation, what);
        names = Geometries::numbered_boundaries(mesh);
      }


      std::map<std::string, dealii::types::boundary_id>
      boundary_names() const override
      {
        return names;
      }

    private:
      void
      generate(dealii::Triangulation<dim> &mesh) const
      {
        dealii::GridGenerator::generate_from_name_and_arguments(mesh,
                                                                function,
                                                                arguments);
      }

      std::string  function  = "hyper_cube";
      std::string  arguments = "0 : 1 : true";
      mutable bool was_tried = false;
      mutable std::map<std::string, dealii::types::boundary_id> names;
    };
  } // namespace

  THALWEG_REGISTER(Geometry,
                   Generator,
                   "generator",
                   "any function of deal.II's GridGenerator. Boundaries are "
                   "called by their numbers.")
} // namespace Thalweg
