// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_mesh_plan_h
#define thalweg_mesh_mesh_plan_h

#include <thalweg/mesh/geometry.h>
#include <thalweg/mesh/mesh_partition.h>

#include <deal.II/distributed/tria.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Thalweg
{
  /// The parameters of the sections "Geometry", "Refinement" and "Partition".
  template <int dim>
  struct MeshParameters
  {
    /// Declares the sections below @p root.
    void
    declare(const Section &root);

    Choice<Geometry<dim>>      geometry;
    std::vector<std::string>   periodic_boundaries;
    unsigned int               global_refinement = 0;
    std::string                local_refinement  = "0";
    double                     memory_limit      = 0.;
    Choice<MeshPartition<dim>> partition;
  };

  /// A pair of periodic boundaries.
  struct PeriodicPair
  {
    dealii::types::boundary_id first;
    dealii::types::boundary_id second;
    unsigned int               direction;
  };

  using BoundaryNames = std::map<std::string, dealii::types::boundary_id>;

  /// The id of the boundary @p name; the message of the exception lists the
  /// names that exist.
  dealii::types::boundary_id
  find_boundary(const BoundaryNames &names, const std::string &name);

  /**
   * @brief What a mesh looks like, whoever gets its cells: how its coarse
   * cells come about, which boundaries are joined, and how it is refined.
   */
  template <int dim>
  class MeshPlan
  {
  public:
    using Triangulation = dealii::Triangulation<dim>;
    using Forest        = dealii::parallel::distributed::Triangulation<dim>;

    /// @param parameters must outlive the plan
    explicit MeshPlan(const MeshParameters<dim> &parameters);

    /// A mesh of p4est without cells.
    static std::unique_ptr<Forest>
    empty_forest(const MPI_Comm communicator);

    /**
     * @brief Fills @p tria with the coarse mesh and joins periodic boundaries;
     * what the functions below say is known from then on.
     * @throws dealii::ExcMessage for unknown boundary names and everything
     *   that the geometry refuses
     */
    void
    create_coarse(Triangulation &tria);

    /// Refines the coarse mesh globally and locally.
    void
    refine(Triangulation &tria) const;

    /// Joins the periodic boundaries in a copy of the coarse mesh or of a part
    /// of it.
    void
    join_periodic_boundaries(Triangulation &tria) const;

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

    /// The lower and the upper corner of the box around the coarse mesh.
    const std::pair<dealii::Point<dim>, dealii::Point<dim>> &
    box() const
    {
      return corners;
    }

    /// A number that tells the coarse mesh from others: a checksum of its
    /// corners and boundary ids.
    std::uint64_t
    coarse_checksum() const
    {
      return checksum;
    }

  private:
    PeriodicPair
    find_periodic_pair(const Triangulation &tria,
                       const std::string   &pair_of_names) const;

    /// @throws dealii::ExcMessage if a face of a periodic boundary has no
    ///   partner
    void
    check_periodic_faces(const Triangulation &tria) const;

    const MeshParameters<dim>                        &parameters;
    BoundaryNames                                     names;
    std::vector<PeriodicPair>                         periodic;
    std::uint64_t                                     checksum = 0;
    std::pair<dealii::Point<dim>, dealii::Point<dim>> corners;
  };
} // namespace Thalweg

#endif
