// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_interface_contour_h
#define thalweg_interface_contour_h

#include <thalweg/fields/node_space.h>
#include <thalweg/interface/facet.h>

#include <map>
#include <vector>

namespace Thalweg
{
  /// The part of a level set's zero contour in one cell, as plain memory that
  /// can be sent to another rank.
  template <int dim>
  struct ContourPatch
  {
    /// The global index of the cell in the CellGraph.
    dealii::types::global_cell_index cell;
    /// The cell's corners, or their images in a periodic domain.
    std::array<dealii::Point<dim>, (1 << dim)> vertices;
    /// The level set there.
    std::array<double, (1 << dim)> phi;
    /// Bit f is set if the domain ends at face f.
    unsigned int boundary_faces;
  };

  /// The facets of a patch: those on which SimplexCut makes phi vanish.
  template <int dim>
  std::vector<Facet<dim>>
  facets(const ContourPatch<dim> &patch);

  /**
   * @brief The zero contour of a level set near each node, whichever ranks
   * own the cells.
   */
  template <int dim>
  class Contour
  {
  public:
    /**
     * @brief Collects the contour. Collective.
     * @param phi ghosted, consistent with the constraints
     */
    Contour(const NodeSpace<dim> &space, const Vector &phi);

    /// The patches in the cells that touch a local node, owned or ghost;
    /// hanging nodes touch the coarse cell too.
    const std::vector<unsigned int> &
    patches_at(const unsigned int node) const
    {
      return of_node[node];
    }

    unsigned int
    n_patches() const
    {
      return patches.size();
    }

    /// Lets @p nearest be the distance from @p x to patch @p patch if that is
    /// less.
    void
    find_nearest(const unsigned int        patch,
                 const dealii::Point<dim> &x,
                 FacetDistance            &nearest) const;

    /// Appends the facets of patch @p patch that are as near to @p x as
    /// @p nearest says.
    void
    collect_nearest(const unsigned int        patch,
                    const dealii::Point<dim> &x,
                    const FacetDistance      &nearest,
                    std::vector<Facet<dim>>  &facets) const;

  private:
    struct Ball
    {
      dealii::Point<dim>     origin;
      dealii::Tensor<1, dim> center; ///< the way from there, m
      /// Infinite if a facet goes on beyond the domain.
      double radius = 0.;

      /// Of @p x from its surface, negative inside.
      double
      distance(const dealii::Point<dim> &x) const
      {
        return ((x - origin) - center).norm() - radius;
      }
    };

    void
    collect(const Vector &phi);

    /// Tells ghost nodes what their owners know.
    void
    update_ghosts();

    /// Lets nodes that a periodic boundary joins know the same, and hanging
    /// nodes what those know that they depend on.
    void
    join_dependent_nodes();

    /// Tells @p to what @p from knows, moved by @p offset.
    void
    tell(const unsigned int            from,
         const unsigned int            to,
         const dealii::Tensor<1, dim> &offset);

    unsigned int
    add(const ContourPatch<dim> &patch);

    Ball
    ball_around(const std::vector<Facet<dim>> &of_patch) const;

    const NodeSpace<dim>          &space;
    const unsigned int             n_owned;
    std::vector<ContourPatch<dim>> patches;
    std::vector<Facet<dim>>        all_facets;
    /// A ball around the facets of each patch.
    std::vector<Ball> balls;
    /// Of each patch, and behind the last one.
    std::vector<unsigned int>              first_facet = {0};
    std::vector<std::vector<unsigned int>> of_node;
  };
} // namespace Thalweg

#endif
