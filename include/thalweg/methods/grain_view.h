// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_grain_view_h
#define thalweg_methods_grain_view_h

#include <thalweg/dem/grain_materials.h>
#include <thalweg/dem/grain_system.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /// What a method with grains offers under "grains".
  struct GrainView
  {
    const GrainSystem       &system;
    const GrainMaterials    &materials;
    const ContactLaw        &law;
    const WallSet           &walls;
    std::vector<std::string> wall_names;    ///< of walls.walls
    std::vector<GoneGrain>   gone;          ///< in the last step, on this rank
    double                   sub_step = 0.; ///< the last one, s
  };
} // namespace Thalweg

#endif
