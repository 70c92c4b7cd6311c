// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_interface_surface_tension_h
#define thalweg_interface_surface_tension_h

#include <thalweg/core/section.h>
#include <thalweg/mesh/mesh.h>

#include <map>
#include <string>

namespace Thalweg
{
  /// The parameters of the section "Interface/Surface tension" but for the
  /// model, see InterfaceForce.
  struct SurfaceTensionParameters
  {
    /// Declares them in their own section.
    void
    declare(const Section &section);

    /// @throws dealii::ExcMessage
    template <int dim>
    void
    check(const unsigned int n_fluids) const;

    /// The contact angles, in rad, of the boundaries that are named.
    /// @throws dealii::ExcMessage for names that the mesh does not have, and
    ///   what is no angle
    template <int dim>
    std::map<dealii::types::boundary_id, double>
    angles(const Mesh<dim> &mesh) const;

    bool
    acts() const
    {
      return coefficient > 0.;
    }

    double      coefficient = 0.; ///< N/m
    std::string curvature;
    std::string contact_angles;
  };
} // namespace Thalweg

#endif
