// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_mesh_h
#define thalweg_mesh_mesh_h

#include <thalweg/mesh/cell_graph.h>
#include <thalweg/mesh/mesh_plan.h>

#include <deal.II/fe/mapping_q1.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Thalweg
{
  /**
   * @brief The distributed mesh, its boundary names, and its cell graph.
   *
   * What stands on it is made anew after each change (SimulationParts).
   */
  template <int dim>
  class Mesh
  {
  public:
    using Triangulation = typename MeshPartition<dim>::Triangulation;

    /// A mesh of p4est that is still empty.
    explicit Mesh(const MPI_Comm communicator);

    ~Mesh();

    /// Creates the coarse mesh and joins periodic boundaries, no more; for
    /// checks of the input. Throws as create() does.
    void
    create_coarse(const MeshParameters<dim> &parameters);

    /**
     * @brief Creates the coarse mesh, joins periodic boundaries, refines, and
     * distributes the cells.
     * @throws dealii::ExcMessage for unknown boundary names and everything
     *   that the geometry refuses
     */
    void
    create(const MeshParameters<dim> &parameters);

    /// Creates what load() needs. Throws as create() does.
    void
    create_to_load(const MeshParameters<dim> &parameters);

    /**
     * @brief Makes the mesh have the cells that were saved. Collective.
     * @param parameters those of create_to_load()
     * @param saved those of cells_on_curve() on all ranks, then
     * @throws dealii::ExcMessage on all processes if they cannot be cells of
     *   this mesh
     */
    void
    load(const MeshParameters<dim> &parameters, const SavedCells &saved);

    /// The cells of this rank, to be saved.
    std::vector<CurveCell>
    cells_on_curve() const;

    const Triangulation &
    triangulation() const
    {
      return *tria;
    }

    Triangulation &
    triangulation()
    {
      return *tria;
    }

    const CellGraph<dim> &
    graph() const
    {
      return cell_graph;
    }

    const dealii::Mapping<dim> &
    mapping() const
    {
      return mapping_q1;
    }

    /// The id of the boundary @p name; the message of the exception lists
    /// the names that exist.
    dealii::types::boundary_id
    boundary_id(const std::string &name) const
    {
      return find_boundary(names, name);
    }

    const BoundaryNames &
    boundary_names() const
    {
      return names;
    }

    const std::vector<PeriodicPair> &
    periodic_pairs() const
    {
      return periodic;
    }

    /// The lower and the upper corner of the box around the coarse mesh, m;
    /// the same whatever is refined.
    const std::pair<dealii::Point<dim>, dealii::Point<dim>> &
    box() const
    {
      return corners;
    }

    /// Where the mesh is, for messages: "from (0 0) to (1 2)".
    std::string
    extent() const;

    /// A number that tells the coarse mesh from others.
    std::uint64_t
    coarse_checksum() const
    {
      return checksum;
    }

    /// Distributes the cells over the ranks anew, for meshes whose partition
    /// can change. What hangs on the cells must have been attached to them.
    void
    repartition();

    /// Makes the graph anew; to be called when the triangulation was changed
    /// from outside.
    void
    update();

  private:
    /// Takes over a mesh and what its plan knows.
    void
    adopt(std::unique_ptr<Triangulation> made, const MeshPlan<dim> &plan);

    MPI_Comm                                          communicator;
    std::unique_ptr<Triangulation>                    tria;
    dealii::MappingQ1<dim>                            mapping_q1;
    CellGraph<dim>                                    cell_graph;
    BoundaryNames                                     names;
    std::vector<PeriodicPair>                         periodic;
    std::uint64_t                                     checksum = 0;
    std::pair<dealii::Point<dim>, dealii::Point<dim>> corners;
  };
} // namespace Thalweg

#endif
