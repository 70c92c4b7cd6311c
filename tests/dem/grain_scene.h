// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_dem_grain_scene_h
#define tests_dem_grain_scene_h

#include <thalweg/core/registry.h>
#include <thalweg/dem/grain_system.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <string>
#include <vector>

/// Some grains and walls without a mesh.
class GrainScene
{
public:
  /// A material of soft glass.
  static Thalweg::PairMaterial
  material(const double restitution      = .9,
           const double friction         = .5,
           const double rolling_friction = 0.)
  {
    return {5e6 / (2. * .91),
            5e6 / (4. * 1.7 * 1.3),
            5e6,
            .3,
            restitution,
            0.,
            {friction, rolling_friction, .3}};
  }

  /// @param settings of the law, "set Normal stiffness = 1000"
  GrainScene(const std::string           &law_name,
             const Thalweg::PairMaterial &pair,
             const std::string           &settings = "",
             const Thalweg::RollingModel  rolling = Thalweg::RollingModel::none,
             const int                    dim     = 3,
             const double                 density = 2500.)
    : law(Thalweg::Registry<Thalweg::ContactLaw>::entries().at(law_name).make())
  {
    dealii::ParameterHandler prm;
    law->declare_parameters(Thalweg::Section(prm));
    prm.parse_input_from_string(settings);
    law->prepare({pair}, rolling);
    Thalweg::GrainSettings grain_settings;
    grain_settings.dim       = dim;
    grain_settings.densities = {density};
    grain_settings.rolling   = rolling;
    system                   = std::make_unique<Thalweg::GrainSystem>(
      MPI_COMM_SELF, *law, grain_settings, walls, std::vector<Thalweg::Vec3>());
    system->set_locator(locator);
  }

  void
  add_grain(const Thalweg::Vec3 &x,
            const double         r,
            const Thalweg::Vec3 &v,
            const Thalweg::Vec3 &w = {0., 0., 0.})
  {
    const Thalweg::Vec3 nothing{0., 0., 0.};
    grains.push_back({grains.size(), x, v, w, nothing, nothing, x, r, 0, 0});
  }

  /// A facet of a wall of its own, or of wall @p wall.
  void
  add_facet(Thalweg::Facet facet, const int wall = -1)
  {
    const Thalweg::Vec3 nothing{0., 0., 0.};
    if (wall < 0)
      {
        walls.walls.push_back({nothing, nothing, facet.corner[0], 0, true});
        walls.forces.push_back({nothing, nothing});
      }
    facet.wall = wall < 0 ? walls.walls.size() - 1 : wall;
    walls.facets.push_back(facet);
  }

  void
  add_plane(const Thalweg::Vec3 &point, const Thalweg::Vec3 &normal)
  {
    Thalweg::Facet facet{};
    facet.kind      = Thalweg::Facet::Kind::plane;
    facet.is_solid  = true;
    facet.corner[0] = point;
    facet.normal    = (1. / norm(normal)) * normal;
    add_facet(facet);
  }

  void
  begin()
  {
    system->add(grains);
  }

  void
  advance(const unsigned int   n_steps,
          const double         dt,
          const Thalweg::Vec3 &gravity = {0., 0., 0.})
  {
    system->advance(n_steps, dt, gravity, {});
  }

  /// All that is known of a grain now.
  Thalweg::GrainRecord
  grain(const std::uint64_t id) const
  {
    for (const auto &grain : system->all().grains)
      if (grain.id == id)
        return grain;
    throw dealii::ExcMessage("There is no such grain.");
  }

  std::unique_ptr<Thalweg::ContactLaw>  law;
  Thalweg::WallSet                      walls;
  std::vector<Thalweg::GrainRecord>     grains;
  std::unique_ptr<Thalweg::GrainSystem> system;

private:
  /// All places are this process's.
  struct Everywhere : Thalweg::GrainLocator
  {
    std::vector<Thalweg::GrainOwner>
    locate(const std::vector<Thalweg::GrainPlace> &places) const override
    {
      return std::vector<Thalweg::GrainOwner>(places.size(), {0, 0});
    }
  };

  Everywhere locator;
};

#endif
