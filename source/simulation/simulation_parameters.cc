// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/simulation/simulation_parameters.h>

namespace Thalweg
{
  template <int dim>
  void
  SimulationParameters<dim>::declare(const Section       &root,
                                     const ParameterFile &input)
  {
    const std::string usual_method = "pfem2";
    method.declare_parameters(root.enter("Method"), usual_method, "algorithm");
    mesh.declare(root);
    adaptive.declare_parameters(root);
    balance.declare_parameters(root);
    time.declare_parameters(root);
    checkpoint.declare_parameters(root);
    forces.declare_parameters(root);
    // Names that are none are refused when the file is read.
    Method<dim> *used = method.find(input.value("Method/Model", usual_method));
    (used != nullptr ? used : method.find(usual_method))
      ->declare_sections(root);
    postprocessors.declare_parameters(root.enter("Postprocess"),
                                      "postprocessors");
  }



  template void
  SimulationParameters<2>::declare(const Section &, const ParameterFile &);
  template void
  SimulationParameters<3>::declare(const Section &, const ParameterFile &);
} // namespace Thalweg
