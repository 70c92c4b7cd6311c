// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_mesh_locator_h
#define thalweg_dem_mesh_locator_h

#include <thalweg/dem/boundary_facets.h>
#include <thalweg/dem/grain_system.h>
#include <thalweg/dem/wall_list.h>
#include <thalweg/particles/cell_maps.h>

#include <memory>
#include <set>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Says which rank and cell of a mesh a grain belongs to: those of its
   * center. Grains that stick out belong to the cell at the nearest place of
   * the boundary, unless that is open, through which they leave.
   */
  template <int dim>
  class MeshLocator : public GrainLocator
  {
  public:
    /// @param mesh must outlive the object, like @p boundary
    /// @param open boundaries that grains may leave through
    MeshLocator(const Mesh<dim>                  &mesh,
                const std::vector<BoundaryFacet> &boundary,
                const std::set<unsigned int>     &open);

    std::vector<GrainOwner>
    locate(const std::vector<GrainPlace> &places) const override;

    Vec3
    wrap(const Vec3 &x) const override;

    /// Whether places, the same on all ranks, are in the mesh and not nearer to
    /// the walls than their radius. Collective.
    std::vector<char>
    have_room(const std::vector<GrainPlace> &places) const;

    /// By which images are moved at periodic boundaries, in all combinations,
    /// m.
    static std::vector<Vec3>
    shifts(const Mesh<dim> &mesh);

  private:
    static constexpr std::uint32_t nowhere = -1;

    /// The owned cell that holds a place, the first one if several do.
    std::uint32_t
    find_here(const Vec3 &x) const;

    bool
    is_in(const std::uint32_t cell, const Vec3 &x) const;

    /// Finds places that are not here on other ranks. Collective.
    void
    ask_others(const std::vector<Vec3> &places,
               std::vector<GrainOwner> &owners) const;

    /// The bin of a place, or of the nearest one.
    std::size_t
    bin(const dealii::Point<dim> &x) const;

    /// Puts the owned cells into bins.
    void
    fill_bins();

    const Mesh<dim>                  &mesh;
    const std::vector<BoundaryFacet> &boundary;
    const std::set<unsigned int>     &open;
    std::vector<Facet>                facets; ///< those of the boundary
    double                            size;   ///< of the mesh, m
    /// Owned cells by where they are.
    dealii::Point<dim>                                             lower, upper;
    std::array<std::size_t, dim>                                   n_bins{};
    std::vector<std::vector<std::uint32_t>>                        bins;
    std::vector<std::pair<dealii::Point<dim>, dealii::Point<dim>>> boxes;
    std::vector<typename CellMaps<dim>::Polynomial>                shapes;
    /// Of all ranks: corners of the box around their cells.
    std::vector<double> rank_boxes;
  };
} // namespace Thalweg

#endif
