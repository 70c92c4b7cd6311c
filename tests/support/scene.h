// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_support_scene_h
#define tests_support_scene_h

#include <thalweg/fields/boundary_nodes.h>
#include <thalweg/fluid/body_forces.h>
#include <thalweg/interface/phase_field.h>
#include <thalweg/particles/population.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <memory>
#include <string>

#include "input.h"

/**
 * @brief The parts of a simulation that stand on a mesh, as an input file
 * describes them, for tests of each part alone.
 */
template <int dim>
struct Scene
{
  using Point      = dealii::Point<dim>;
  using Tensor     = dealii::Tensor<1, dim>;
  using Scalar     = std::function<double(const Point &)>;
  using Field      = std::function<Tensor(const Point &)>;
  using MeshChange = std::function<void(Thalweg::Mesh<dim> &)>;

  /// @param settings the text of an input file
  /// @param change what happens to the mesh before anything stands on it
  explicit Scene(const std::string &settings, const MeshChange &change = {});

  ~Scene();

  /// The nodal values of @p function, ghosted and consistent.
  Thalweg::Vector
  scalar(const Scalar &function) const
  {
    Thalweg::Vector vector;
    space->initialize_scalar(vector);
    for (unsigned int n = 0; n < vector.locally_owned_size(); ++n)
      vector.local_element(n) = function(space->position(n));
    space->interpolate(vector, 1);
    return vector;
  }

  /// The nodal values of a velocity, ghosted and consistent.
  Thalweg::Vector
  velocity(const Field &function) const
  {
    Thalweg::Vector vector;
    space->initialize_velocity(vector);
    for (unsigned int n = 0; n < vector.locally_owned_size() / dim; ++n)
      {
        const Tensor value = function(space->position(n));
        for (unsigned int d = 0; d < dim; ++d)
          vector.local_element(dim * n + d) = value[d];
      }
    space->interpolate(vector, dim);
    return vector;
  }

  /// The velocity at a local node.
  static Tensor
  at(const Thalweg::Vector &velocity, const unsigned int node)
  {
    Tensor value;
    for (unsigned int d = 0; d < dim; ++d)
      value[d] = velocity.local_element(dim * node + d);
    return value;
  }

  /// Calls @p visit(node, position) for all owned nodes that depend on no
  /// others.
  template <typename Visitor>
  void
  for_each_node(const Visitor &visit) const
  {
    const unsigned int n_owned = space->scalar_layout().locally_owned_size();
    for (unsigned int n = 0; n < n_owned; ++n)
      if (!space->is_dependent(n))
        visit(n, space->position(n));
  }

  /// Lets the level set be @p function, with the volume that it has.
  void
  set_phases(const Scalar &function) const
  {
    phase->rebuild(scalar(function), false);
  }

  dealii::ParameterHandler                          prm;
  Thalweg::MeshParameters<dim>                      mesh_parameters;
  Thalweg::BoundaryConditionParameters              boundary_parameters;
  Thalweg::InterfaceParameters                      interface;
  Thalweg::Fluids                                   fluids;
  Thalweg::BodyForces<dim>                          forces;
  Thalweg::Mesh<dim>                                mesh;
  std::unique_ptr<Thalweg::NodeSpace<dim>>          space;
  std::unique_ptr<Thalweg::BoundaryConditions<dim>> conditions;
  std::unique_ptr<Thalweg::BoundaryNodes<dim>>      boundary;
  std::unique_ptr<Thalweg::PhaseField<dim>>         phase;
  std::unique_ptr<Thalweg::Population<dim>>         population;
};

extern template struct Scene<2>;
extern template struct Scene<3>;



/// Whether a point lies on a side of the unit box.
template <int dim>
bool
on_side_of_unit_box(const dealii::Point<dim> &p)
{
  for (unsigned int d = 0; d < dim; ++d)
    if (p[d] < 1e-9 || p[d] > 1. - 1e-9)
      return true;
  return false;
}



/// The sum and the greatest value over all processes.
inline double
sum_of_all(const double value)
{
  return dealii::Utilities::MPI::sum(value, MPI_COMM_WORLD);
}

inline double
max_of_all(const double value)
{
  return dealii::Utilities::MPI::max(value, MPI_COMM_WORLD);
}



#endif
