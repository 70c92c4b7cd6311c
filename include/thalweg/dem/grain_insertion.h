// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_grain_insertion_h
#define thalweg_dem_grain_insertion_h

#include <thalweg/dem/grain_materials.h>
#include <thalweg/dem/mesh_locator.h>
#include <thalweg/dem/wall_list.h>

#include <deal.II/base/function_parser.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /// Numbers that look random and follow from a seed, on any machine.
  class RandomNumbers
  {
  public:
    explicit RandomNumbers(const std::uint64_t seed)
      : state(seed)
    {}

    /// The next one, from 0 to less than 1.
    double
    next();

    /// The next one of the normal distribution.
    double
    next_normal();

  private:
    std::uint64_t state;
  };

  /// How much is to come in: as many grains, or as much mass at a density.
  struct StreamGoal
  {
    std::size_t number;
    double      mass    = 0.; ///< kg
    double      density = 0.; ///< kg/m^3
  };

  /**
   * @brief How grains come in: the section "Insertion", or one in it.
   *
   * All ranks find the same grains, in the same order.
   */
  template <int dim>
  class GrainInsertion
  {
  public:
    /// @param place of the section, for messages
    /// @param order of all such ones, for other random numbers
    void
    declare_parameters(const Section     &section,
                       const std::string &place,
                       const unsigned int order);

    /// @throws dealii::ExcMessage for what cannot be
    void
    check(const GrainMaterials &materials) const;

    /// The same for what is seen on the mesh.
    void
    check_on_mesh(const Mesh<dim> &mesh) const;

    /// When grains come in for the @p n th time, s; infinity: never.
    double
    time_of(const unsigned int n) const;

    /**
     * @brief The grains of one time, the same on all ranks; collective.
     * @param n how often some have come before
     * @param mass_before of a stream, that has come before, kg
     * @param first_id number of the first one
     * @param present those that are there, of this rank
     * @param walls from which they keep away, besides the boundary
     * @throws dealii::ExcMessage if there is no room for the number asked for
     */
    std::vector<GrainRecord>
    make(const Mesh<dim>               &mesh,
         const MeshLocator<dim>        &locator,
         const GrainMaterials          &materials,
         const unsigned int             n,
         const double                   mass_before,
         const std::uint64_t            first_id,
         const std::vector<GrainPlace> &present,
         const WallSet                 &walls) const;

    /// m
    double
    largest_diameter() const;

    /// Whether grains come in as a stream.
    bool
    is_stream() const
    {
      return number_rate > 0. || mass_rate > 0.;
    }

  private:
    /// The next radius, m.
    double
    radius(RandomNumbers &random) const;

    std::vector<GrainPlace>
    on_lattice(const Mesh<dim> &mesh, RandomNumbers &random) const;

    /// Says that there is no room at places that touch grains that are there on
    /// any rank. Collective.
    void
    take_out_overlapping(const Mesh<dim>               &mesh,
                         const std::vector<GrainPlace> &places,
                         const std::vector<GrainPlace> &present,
                         std::vector<char>             &room) const;

    void
    declare_times(const Section &section);

    /// @throws dealii::ExcMessage for streams that cannot be
    void
    check_stream() const;

    /// How many grains a stream lets in for the @p n th time.
    std::size_t
    number_of_stream(const unsigned int n) const;

    /// Places at random that touch neither each other nor those present, until
    /// there are @p wanted of them, or as much mass.
    std::vector<GrainPlace>
    at_random(const Mesh<dim>               &mesh,
              const MeshLocator<dim>        &locator,
              RandomNumbers                 &random,
              const std::vector<GrainPlace> &present,
              const WallSet                 &walls,
              const StreamGoal              &wanted) const;

    bool
    is_in_region(const Vec3 &x) const;

    unsigned int
    material_number(const GrainMaterials &materials) const;

    /// @throws dealii::ExcMessage if fewer grains were placed than wanted
    void
    check_room(const std::vector<GrainPlace> &places,
               const StreamGoal              &wanted,
               const std::string             &extent) const;

    std::string  where; ///< the section
    unsigned int index    = 0;
    std::string  region   = "1";
    std::string  pattern  = "lattice";
    std::string  sizes    = "mono";
    std::string  velocity = dim == 3 ? "0; 0; 0" : "0; 0";
    std::string  spin     = dim == 3 ? "0; 0; 0" : "0";
    std::string  material;
    double       diameter = 0., spread = 0., spacing = 0., shake = 0.;
    double       first = 0., interval = 0., last = 0.;
    double       number_rate = 0., mass_rate = 0.; ///< 1/s, kg/s
    unsigned int number = 0, seed = 1;

    mutable std::unique_ptr<dealii::FunctionParser<dim>> region_function;
  };
} // namespace Thalweg

#endif
