// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_mesh_geometry_h
#define thalweg_mesh_geometry_h

#include <thalweg/core/registry.h>

#include <deal.II/base/types.h>
#include <deal.II/grid/tria.h>

#include <map>
#include <string>
#include <utility>

namespace Thalweg
{
  /**
   * @brief A domain and its coarse mesh.
   *
   * Models of this kind are registered and chosen in the section "Geometry".
   */
  template <int dim>
  class Geometry
  {
  public:
    virtual ~Geometry() = default;

    /// Declares the geometry's own parameters.
    virtual void
    declare_parameters(const Section &section) = 0;

    /**
     * @brief About how many coarse cells create() will make, so that too many
     * are refused before; 0: only create() knows.
     * @throws dealii::ExcMessage as create() does
     */
    virtual double
    n_cells() const
    {
      return 0.;
    }

    /**
     * @brief Fills @p triangulation with the coarse mesh and sets boundary
     * and material ids.
     * @throws dealii::ExcMessage for impossible parameters or unreadable
     *   files, telling what to write instead
     */
    virtual void
    create(dealii::Triangulation<dim> &triangulation) const = 0;

    /**
     * @brief The names by which the input file calls the boundaries.
     *
     * A box has "left", "right", "bottom", "top", in 3D also "front" and
     * "back" (x, y and z direction in this order), and "obstacle" where
     * there is one; other geometries name them by their number, "0", "1".
     * Valid after create().
     */
    virtual std::map<std::string, dealii::types::boundary_id>
    boundary_names() const = 0;
  };
} // namespace Thalweg

#endif
