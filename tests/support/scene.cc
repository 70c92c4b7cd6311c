// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/scene.h"

template <int dim>
Scene<dim>::Scene(const std::string &settings, const MeshChange &change)
  : mesh(MPI_COMM_WORLD)
{
  {
    const Thalweg::Section root(prm);
    mesh_parameters.declare(root);
    fluids.declare_parameters(root);
    boundary_parameters.declare(root);
    forces.declare_parameters(root);
    interface.declare(root);
  }
  prm.parse_input_from_string(settings);
  fluids.check();
  forces.initialize();
  mesh.create(mesh_parameters);
  if (change)
    change(mesh);
  space = std::make_unique<Thalweg::NodeSpace<dim>>(mesh);
  conditions =
    std::make_unique<Thalweg::BoundaryConditions<dim>>(boundary_parameters,
                                                       mesh);
  boundary = std::make_unique<Thalweg::BoundaryNodes<dim>>(*space, *conditions);
  phase = std::make_unique<Thalweg::PhaseField<dim>>(*space, fluids, interface);
  population = std::make_unique<Thalweg::Population<dim>>(mesh);
}



template <int dim>
Scene<dim>::~Scene() = default;

template struct Scene<2>;
template struct Scene<3>;
