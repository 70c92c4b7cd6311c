// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_coupling_host_h
#define thalweg_coupling_host_h

#include <thalweg/core/context.h>
#include <thalweg/core/ports.h>
#include <thalweg/fluid/body_forces.h>
#include <thalweg/mesh/mesh.h>

#include <string>

namespace Thalweg
{
  /// What a method or a coupling stands on, and what it is called there.
  template <int dim>
  struct Host
  {
    std::string      name; ///< empty: the only method
    Context         &context;
    Mesh<dim>       &mesh;
    BodyForces<dim> &forces;
    Ports           &ports; ///< what methods offer each other
  };
} // namespace Thalweg

#endif
