// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/interface/interface_quadrature.h>
#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/phase_integrals.h>
#include <thalweg/postprocess/scheduled_output.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// The measure of the interface in a cell.
    template <int dim>
    double
    interface_of_cell(const typename CellGraph<dim>::Cell  &cell,
                      const std::array<double, (1 << dim)> &phi)
    {
      double area = 0.;
      for (const auto &simplex : SimplexCut::divide<dim>(cell.vertices, phi))
        SimplexCut::cut(simplex, [&](const auto &piece) {
          for_each_interface_point<dim>(
            piece,
            [&](const dealii::Point<dim> &,
                const dealii::Tensor<1, dim> &vector) {
              area += vector.norm();
            });
        });
      return area;
    }



    /// The measure of the interface between two fluids. Collective.
    template <int dim>
    double
    interface_area(const FlowView<dim> &solution)
    {
      const CellGraph<dim> &graph = solution.mesh.graph();
      double                area  = 0.;
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        {
          const auto phi = cell_level_set(solution, c);
          const auto [least, most] =
            std::minmax_element(phi.begin(), phi.end());
          if (*least < 0. && *most >= 0.)
            area += interface_of_cell<dim>(graph.cell(c), phi);
        }
      return dealii::Utilities::MPI::sum(
        area, solution.mesh.triangulation().get_communicator());
    }



    /// The measure of the surface of a ball with this volume.
    template <int dim>
    double
    surface_of_ball(const double volume)
    {
      constexpr double pi = dealii::numbers::PI;
      return dim == 2 ? 2. * std::sqrt(pi * volume)
                      : std::cbrt(36. * pi * volume * volume);
    }



    /// How large the interface is, and how round the fluid on one side.
    template <int dim>
    class InterfaceArea : public TableOutput<dim>
    {
    public:
      InterfaceArea()
        : TableOutput<dim>("interface_area.csv")
      {}


      void
      check_for_flow(const FlowOutline<dim> &outline) const override
      {
        AssertThrow(outline.fluids.size() == 2,
                    dealii::ExcMessage(
                      "The postprocessor 'interface area' needs two fluids, "
                      "but the section 'Fluids' has one. Remove it from "
                      "'Postprocess/Models' or name a second fluid."));
        if (!fluid.empty())
          outline.fluids.index(fluid);
      }

    private:
      void
      declare_own_parameters(const Section &section) override
      {
        section.add("Fluid",
                    fluid,
                    "",
                    "The name of the fluid whose roundness is to be known; "
                    "empty: the first one.",
                    dealii::Patterns::Anything());
      }


      std::vector<std::string>
      columns(const FlowView<dim> &solution) override
      {
        index = fluid.empty() ? 0 : solution.fluids.index(fluid);
        return {"area [" + length_unit(dim - 1) + "]",
                solution.fluids[index].name + " roundness"};
      }


      std::vector<double>
      row(const FlowView<dim> &solution) override
      {
        const double area = interface_area(solution);
        const double ball =
          surface_of_ball<dim>(integrate_phases(solution)[index].volume);
        return {area, area > 0. ? ball / area : 0.};
      }


      std::string  fluid;
      unsigned int index = 0;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   InterfaceArea,
                   "interface area",
                   "the measure of the interface between two fluids, and how "
                   "round one of them is: the measure of the surface of a ball "
                   "of its volume over that (in 2D its circularity); writes "
                   "interface_area.csv.")
} // namespace Thalweg
