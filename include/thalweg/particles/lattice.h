// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_lattice_h
#define thalweg_particles_lattice_h

#include <thalweg/mesh/mesh.h>
#include <thalweg/particles/cell_maps.h>

#include <cstdint>
#include <functional>

namespace Thalweg
{
  /**
   * @brief A lattice of points in space, with half a spacing to the lower
   * sides of the box around the mesh: the same points on any mesh of a domain
   * and on any number of ranks.
   */
  template <int dim>
  class Lattice
  {
  public:
    /// Called with a cell, the point's coordinates there, its place, and its
    /// number among all of the box.
    using Action = std::function<void(const unsigned int        cell,
                                      const dealii::Point<dim> &reference,
                                      const dealii::Point<dim> &place,
                                      const std::uint64_t       number)>;

    /// @param spacing m
    /// @throws dealii::ExcMessage if these are more points than there are
    ///   numbers for
    Lattice(const Mesh<dim> &mesh, const double spacing);

    /// All points in owned cells, each in one cell.
    void
    for_each_point(const Action &action) const;

    /// How many points the box has.
    std::uint64_t
    n_points() const
    {
      return n_all;
    }

  private:
    /// The points in the box around a cell, and behind them.
    using Range = std::array<std::int64_t, dim>;

    void
    visit(const unsigned int   cell,
          const CellMaps<dim> &maps,
          const Range         &begin,
          const Range         &end,
          const Action        &action) const;

    const Mesh<dim>               &mesh;
    const double                   spacing;
    std::array<std::uint64_t, dim> n_along;
    std::uint64_t                  n_all = 1;
  };
} // namespace Thalweg

#endif
