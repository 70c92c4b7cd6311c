// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/boundary_entries.h>
#include <thalweg/fields/expression.h>
#include <thalweg/interface/surface_tension.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

namespace Thalweg
{
  namespace
  {
    const std::string tension_section = "Interface/Surface tension";

    /// A contact angle in degrees. @throws dealii::ExcMessage
    double
    to_angle(const std::string &text, const std::string &boundary)
    {
      constexpr double smallest = 1., largest = 179.;
      double           angle = 0.;
      try
        {
          angle = dealii::Utilities::string_to_double(text);
        }
      catch (const dealii::ExceptionBase &)
        {}
      AssertThrow(angle >= smallest && angle <= largest,
                  dealii::ExcMessage(
                    "The contact angle of the boundary '" + boundary +
                    "' in '" + tension_section + "/Contact angles' is '" +
                    text +
                    "'. Write a number of degrees from 1 to 179, measured "
                    "in the first fluid."));
      return angle;
    }
  } // namespace



  void
  SurfaceTensionParameters::declare(const Section &section)
  {
    section.add("Coefficient",
                coefficient,
                "N/m",
                "The surface tension between two fluids, 0.0728 for water and "
                "air at 20 degrees; 0: none.",
                dealii::Patterns::Double(0.));
    section.add("Contact angles",
                contact_angles,
                "degrees",
                "The angles at which the interface meets walls, measured in "
                "the first fluid, by the names of boundaries, such as 'bottom: "
                "60 | left: 120'. At other walls it is 90.",
                dealii::Patterns::Anything());
    section.add("Curvature",
                curvature,
                "1/m",
                "Not found from the interface, but this function of x, y and "
                "z, positive where the first fluid is convex (only to show "
                "what its errors do).",
                dealii::Patterns::Anything());
  }



  template <int dim>
  void
  SurfaceTensionParameters::check(const unsigned int n_fluids) const
  {
    AssertThrow(n_fluids == 2 || !acts(),
                dealii::ExcMessage(
                  "'" + tension_section +
                  "/Coefficient' is for two fluids, but "
                  "'Fluids/Number' is 1. Write 0, or 2 there."));
    if (!curvature.empty())
      parse_expression<dim>(curvature, 1, tension_section + "/Curvature");
  }



  template <int dim>
  std::map<dealii::types::boundary_id, double>
  SurfaceTensionParameters::angles(const Mesh<dim> &mesh) const
  {
    constexpr double degree = dealii::numbers::PI / 180.;
    std::map<dealii::types::boundary_id, double> angles;
    for (const auto &[name, text] :
         split_by_boundary(contact_angles, tension_section + "/Contact angles"))
      angles[find_boundary(mesh, name, tension_section)] =
        to_angle(text, name) * degree;
    return angles;
  }



  template void
  SurfaceTensionParameters::check<2>(const unsigned int) const;
  template void
  SurfaceTensionParameters::check<3>(const unsigned int) const;
  template std::map<dealii::types::boundary_id, double>
  SurfaceTensionParameters::angles(const Mesh<2> &) const;
  template std::map<dealii::types::boundary_id, double>
  SurfaceTensionParameters::angles(const Mesh<3> &) const;
} // namespace Thalweg
