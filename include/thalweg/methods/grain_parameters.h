// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_grain_parameters_h
#define thalweg_methods_grain_parameters_h

#include <thalweg/core/registry.h>
#include <thalweg/dem/boundary_facets.h>
#include <thalweg/dem/grain_insertions.h>
#include <thalweg/dem/grain_materials.h>
#include <thalweg/dem/grain_walls.h>

#include <deal.II/base/function_parser.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace Thalweg
{
  /// The sections of a method with grains.
  template <int dim>
  struct GrainParameters
  {
    void
    declare_parameters(const Section &sections);

    /// Reads what is given, and lets the law know the materials.
    /// @throws dealii::ExcMessage
    void
    initialize();

    void
    check(std::vector<std::string> &faults) const;

    void
    check_on_mesh(const Mesh<dim>          &mesh,
                  std::vector<std::string> &faults) const;

    RollingModel
    rolling_model() const;

    /// Where grains are taken out at a time, in s; nothing: nowhere.
    std::unique_ptr<dealii::FunctionParser<dim>>
    removal_region(const double time) const;

    /// The boundaries that grains leave through.
    std::set<unsigned int>
    open_boundaries(const Mesh<dim> &mesh) const;

    /// Makes the walls; those that have moved stay where they are.
    /// @param boundary of the mesh
    /// @param names are set to those of the walls
    void
    make_walls(const Mesh<dim>                  &mesh,
               const std::vector<BoundaryFacet> &boundary,
               WallSet                          &walls,
               std::vector<std::string>         &names) const;

    GrainMaterials           materials;
    Choice<ContactLaw>       law;
    GrainInsertions<dim>     insertions;
    std::string              rolling         = "none";
    double                   steps_a_contact = 25.;
    double                   sub_step        = 0.; ///< s
    double                   impact_speed    = 0.; ///< m/s
    double                   skin            = .25;
    bool                     has_spin        = true;
    bool                     counts          = true;
    std::string              wall_material;
    std::vector<std::string> open;
    std::string              planes;
    std::string              removal;
    GrainWalls               own_walls;

  private:
    void
    declare_walls(const Section &walls);

    /// A plane out of "x, y, z: nx, ny, nz".
    std::vector<Facet>
    read_planes() const;

    unsigned int
    material_of_walls() const;
  };
} // namespace Thalweg

#endif
