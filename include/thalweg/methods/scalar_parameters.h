// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_scalar_parameters_h
#define thalweg_methods_scalar_parameters_h

#include <thalweg/core/section.h>
#include <thalweg/fields/scalar_conditions.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /// The parameters of a scalar.
  struct ScalarParameters
  {
    void
    declare(const Section &section);

    bool
    melts() const
    {
      return latent_heat != "0";
    }

    /// Appends what is wrong with expressions and melting points.
    template <int dim>
    void
    check(std::vector<std::string> &faults) const;

    std::string               carrier;
    std::string               unit;
    std::string               initial     = "0";
    std::string               diffusivity = "0";
    std::string               capacity    = "1";
    std::string               source      = "0";
    std::string               latent_heat = "0";
    double                    solidus     = 0.;
    double                    liquidus    = 0.;
    ScalarConditionParameters conditions;
    double                    tolerance = 1e-10;
  };
} // namespace Thalweg

#endif
