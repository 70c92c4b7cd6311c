// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_materials_fluids_h
#define thalweg_materials_fluids_h

#include <thalweg/core/section.h>
#include <thalweg/materials/rheology.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /// An incompressible fluid.
  struct Fluid
  {
    std::string name;
    double      density   = 1000.; ///< kg/m^3
    double      viscosity = 1e-3;  ///< dynamic, Pa s
  };

  /**
   * @brief The one or two fluids of a flow.
   *
   * The first has negative, the second positive level set values (Eq. 69:
   * the denser one negative by convention).
   */
  class Fluids
  {
  public:
    /// Declares the section "Fluids" below @p root.
    void
    declare_parameters(const Section &root);

    /// Checks names, densities and viscosities. @throws dealii::ExcMessage
    void
    check() const;

    unsigned int
    size() const
    {
      return number;
    }

    /// Fluid 0 or 1.
    const Fluid &
    operator[](const unsigned int index) const
    {
      return fluids[index];
    }

    /// How the viscosity of fluid 0 or 1 depends on the shear rate; nullptr:
    /// not at all.
    const Rheology *
    rheology(const unsigned int index) const
    {
      const Rheology *model =
        rheologies[index].find(rheologies[index].model_name());
      return model != nullptr && model->depends_on_shear() ? model : nullptr;
    }

    /// Whether it does in any of them.
    bool
    depend_on_shear() const
    {
      return rheology(0) != nullptr || (number == 2 && rheology(1) != nullptr);
    }

    /// The number of the fluid called @p name.
    /// @throws dealii::ExcMessage, listing the fluids that exist
    unsigned int
    index(const std::string &name) const;

    /// The number of the denser fluid; of two that are alike the first.
    unsigned int
    denser() const
    {
      return number == 2 && fluids[1].density > fluids[0].density ? 1 : 0;
    }

    /// The sign of the level set in fluid @p index.
    static double
    sign(const unsigned int index)
    {
      return index == 0 ? -1. : 1.;
    }

    /// The one that particles of the given number consist of: a single fluid
    /// has no numbers.
    const Fluid &
    of_particle(const unsigned int index) const
    {
      return fluids[number == 1 ? 0 : index];
    }

    /// The fluid where the level set is @p phi.
    const Fluid &
    at(const double phi) const
    {
      return fluids[(phi < 0 || number == 1) ? 0 : 1];
    }

  private:
    unsigned int     number = 2;
    Fluid            fluids[2]{{"water", 1000., 1e-3}, {"air", 1.2, 1.8e-5}};
    Choice<Rheology> rheologies[2];
  };
} // namespace Thalweg

#endif
