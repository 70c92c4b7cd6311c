// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_mesh_partition_h
#define thalweg_mesh_mesh_partition_h

#include <thalweg/core/registry.h>
#include <thalweg/mesh/curve_cells.h>

#include <deal.II/base/types.h>
#include <deal.II/distributed/tria_base.h>

#include <memory>
#include <string>
#include <vector>

namespace Thalweg
{
  template <int dim>
  class MeshPlan;

  /// The cells of a mesh as a checkpoint has them.
  struct SavedCells
  {
    /// The checkpoint, for messages.
    std::string place;
    /// On how many ranks they were, and on how many this is.
    unsigned int n_old_ranks = 1, n_ranks = 1;
    /// The number of each rank's first cell among all, and of all cells: on as
    /// many ranks as they were, each gets those that it had.
    std::vector<std::uint64_t> first_of_rank;
    /// Those of this rank.
    std::vector<CurveCell> own;
  };

  /// The boundary id of those faces of ghost cells behind which there are
  /// cells that this rank does not know: the domain goes on there.
  constexpr dealii::types::boundary_id unknown_neighbor =
    dealii::numbers::internal_face_boundary_id - 1;

  /**
   * @brief Makes a mesh and says which rank gets which of its cells.
   *
   * Models of this kind are registered and chosen in the section "Partition".
   * All functions that make meshes are collective.
   */
  template <int dim>
  class MeshPartition
  {
  public:
    using Triangulation = dealii::parallel::DistributedTriangulationBase<dim>;

    virtual ~MeshPartition() = default;

    /// Declares the model's own parameters.
    virtual void
    declare_parameters(const Section &)
    {}

    /// @throws dealii::ExcMessage if this deal.II does not have the model
    virtual void
    check() const
    {}

    /// Whether cells can be refined, coarsened and given to other ranks
    /// during the run.
    virtual bool
    can_change() const = 0;

    /// The mesh of @p plan, refined.
    /// @throws dealii::ExcMessage for everything that the geometry refuses
    virtual std::unique_ptr<Triangulation>
    create(const MPI_Comm communicator, MeshPlan<dim> &plan) const = 0;

    /// A mesh of @p plan for load(). Throws as create() does.
    virtual std::unique_ptr<Triangulation>
    create_to_load(const MPI_Comm communicator, MeshPlan<dim> &plan) const = 0;

    /**
     * @brief Gives @p mesh the cells that were saved, to the same ranks if
     * there are as many as then.
     * @param mesh from create_to_load()
     * @param saved known to cover the mesh
     * @throws dealii::ExcMessage on all processes if these cells or ranks
     *   cannot be
     */
    virtual void
    load(Triangulation &mesh, const SavedCells &saved) const = 0;
  };
} // namespace Thalweg

#endif
