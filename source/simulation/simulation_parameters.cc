// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/simulation/simulation_parameters.h>

namespace Thalweg
{
  template <int dim>
  void
  SimulationParameters<dim>::declare(const Section       &top,
                                     const ParameterFile &input)
  {
    const Section root = top.with(input);
    methods.declare_choice(root, input);
    mesh.declare(root);
    adaptive.declare_parameters(root);
    balance.declare_parameters(root);
    time.declare_parameters(root);
    checkpoint.declare_parameters(root);
    forces.declare_parameters(root);
    methods.declare_sections(root);
    couplings.declare(root, input);
    scheme.declare_parameters(root);
    postprocessors.declare_parameters(root.enter("Postprocess"),
                                      "postprocessors");
  }



  template void
  SimulationParameters<2>::declare(const Section &, const ParameterFile &);
  template void
  SimulationParameters<3>::declare(const Section &, const ParameterFile &);
} // namespace Thalweg
