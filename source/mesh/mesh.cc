// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/mesh.h>

#include <sstream>

namespace Thalweg
{
  template <int dim>
  Mesh<dim>::Mesh(const MPI_Comm communicator)
    : communicator(communicator)
    , tria(MeshPlan<dim>::empty_forest(communicator))
  {}



  // Here, and not in each translation unit: it makes the code of mappings.
  template <int dim>
  Mesh<dim>::~Mesh() = default;



  template <int dim>
  void
  Mesh<dim>::adopt(std::unique_ptr<Triangulation> made,
                   const MeshPlan<dim>           &plan)
  {
    tria     = std::move(made);
    names    = plan.boundary_names();
    periodic = plan.periodic_pairs();
    checksum = plan.coarse_checksum();
    corners  = plan.box();
  }



  template <int dim>
  std::string
  Mesh<dim>::extent() const
  {
    std::ostringstream text;
    text.precision(10);
    text << "from (" << corners.first << ") to (" << corners.second << ")";
    return text.str();
  }



  template <int dim>
  void
  Mesh<dim>::create_coarse(const MeshParameters<dim> &parameters)
  {
    MeshPlan<dim> plan(parameters);
    auto          forest = MeshPlan<dim>::empty_forest(communicator);
    plan.create_coarse(*forest);
    adopt(std::move(forest), plan);
  }



  template <int dim>
  void
  Mesh<dim>::create(const MeshParameters<dim> &parameters)
  {
    MeshPlan<dim> plan(parameters);
    adopt(parameters.partition->create(communicator, plan), plan);
    update();
  }



  template <int dim>
  void
  Mesh<dim>::create_to_load(const MeshParameters<dim> &parameters)
  {
    MeshPlan<dim> plan(parameters);
    adopt(parameters.partition->create_to_load(communicator, plan), plan);
  }



  template <int dim>
  void
  Mesh<dim>::load(const MeshParameters<dim> &parameters,
                  const SavedCells          &saved)
  {
    parameters.partition->load(*tria, saved);
    update();
  }



  template <int dim>
  std::vector<CurveCell>
  Mesh<dim>::cells_on_curve() const
  {
    return curve_cells(cell_graph);
  }



  template <int dim>
  void
  Mesh<dim>::repartition()
  {
    dynamic_cast<typename MeshPlan<dim>::Forest &>(*tria).repartition();
  }



  template <int dim>
  void
  Mesh<dim>::update()
  {
    cell_graph.build(*tria);
  }



  THALWEG_INSTANTIATE(Mesh)
} // namespace Thalweg
