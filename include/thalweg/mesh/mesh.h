#ifndef thalweg_mesh_mesh_h
#define thalweg_mesh_mesh_h

#include <thalweg/core/registry.h>
#include <thalweg/mesh/cell_graph.h>
#include <thalweg/mesh/geometry.h>

#include <deal.II/distributed/tria.h>
#include <deal.II/fe/mapping_q1.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace Thalweg
{
  /// The parameters of the sections "Geometry" and "Refinement".
  template <int dim>
  struct MeshParameters
  {
    /// Declares both sections below @p root.
    void
    declare(const Section &root);

    Choice<Geometry<dim>>    geometry;
    std::vector<std::string> periodic_boundaries;
    unsigned int             global_refinement = 0;
    std::string              local_refinement  = "0";
  };

  /**
   * @brief The p4est mesh, its boundary names, and its cell graph.
   *
   * What stands on it is made anew after each change (SimulationParts).
   */
  template <int dim>
  class Mesh
  {
  public:
    using Triangulation = dealii::parallel::distributed::Triangulation<dim>;

    explicit Mesh(const MPI_Comm communicator);

    /// Creates the coarse mesh and joins periodic boundaries, no more; for
    /// checks of the input. Throws as create() does.
    void
    create_coarse(const MeshParameters<dim> &parameters);

    /**
     * @brief Creates the coarse mesh, joins periodic boundaries and refines.
     * @throws dealii::ExcMessage for unknown boundary names and everything
     *   that the geometry refuses
     */
    void
    create(const MeshParameters<dim> &parameters);

    const Triangulation &
    triangulation() const
    {
      return tria;
    }

    Triangulation &
    triangulation()
    {
      return tria;
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
    boundary_id(const std::string &name) const;

    const std::map<std::string, dealii::types::boundary_id> &
    boundary_names() const
    {
      return names;
    }

    /// A pair of periodic boundaries.
    struct PeriodicPair
    {
      dealii::types::boundary_id first;
      dealii::types::boundary_id second;
      unsigned int               direction;
    };

    const std::vector<PeriodicPair> &
    periodic_pairs() const
    {
      return periodic;
    }

    /// A number that tells the coarse mesh from others: a checksum of its
    /// corners and boundary ids.
    std::uint64_t
    coarse_checksum() const;

    /// Makes the graph anew; to be called when the triangulation was changed
    /// from outside.
    void
    update();

  private:
    void
    join_periodic_boundaries(const std::vector<std::string> &pairs);

    PeriodicPair
    find_periodic_pair(const std::string &names) const;

    void
    refine_locally(const unsigned int global_levels,
                   const std::string &extra_levels);

    Triangulation                                     tria;
    dealii::MappingQ1<dim>                            mapping_q1;
    CellGraph<dim>                                    cell_graph;
    std::map<std::string, dealii::types::boundary_id> names;
    std::vector<PeriodicPair>                         periodic;
  };
} // namespace Thalweg

#endif
