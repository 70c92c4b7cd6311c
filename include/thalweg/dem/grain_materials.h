// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_grain_materials_h
#define thalweg_dem_grain_materials_h

#include <thalweg/core/section.h>
#include <thalweg/dem/law.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief What grains and walls are made of: the section "Materials".
   *
   * Pairs of materials mix by geometric means, unless the table "Pairs" says
   * something else; moduli as Hertz's theory says.
   */
  class GrainMaterials
  {
  public:
    void
    declare_parameters(const Section &section);

    /// Reads what is given. @throws dealii::ExcMessage
    void
    initialize();

    unsigned int
    n() const
    {
      return names_.size();
    }

    const std::vector<std::string> &
    names() const
    {
      return names_;
    }

    /// The number of a material. @param where the parameter, for messages
    /// @throws dealii::ExcMessage that lists those that there are
    unsigned int
    find(const std::string &name, const std::string &where) const;

    /// kg/m^3
    const std::vector<double> &
    densities() const
    {
      return densities_;
    }

    /// What each two are to each other, n * n.
    std::vector<PairMaterial>
    pairs() const;

  private:
    /// A property: as given, and of each material or pair.
    struct Property
    {
      std::string         text;      ///< "2500", or "glass: 2500 | steel: 7800"
      std::string         pair_text; ///< "glass, steel: 0.3 | ..."
      std::vector<double> values{};
      std::vector<double> of_pairs{}; ///< n * n
    };

    /// Reads the values of a property. @param name as in the section
    void
    read(Property          &property,
         const std::string &name,
         const double       least,
         const double       greatest) const;

    /// Mixes values, and reads those of pairs.
    void
    read_pairs(Property          &property,
               const std::string &name,
               const double       least,
               const double       greatest) const;

    std::vector<std::string> names_{"grain"};
    std::vector<double>      densities_;
    Property density{"2500", ""}, young{"5e6", ""}, poisson{"0.3", ""},
      restitution{"0.9", ""}, friction{"0.5", ""}, rolling{"0", ""},
      cohesion{"0", ""};
    double rolling_damping = .3;
  };
} // namespace Thalweg

#endif
