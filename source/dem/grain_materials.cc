// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/plain_text.h>
#include <thalweg/core/spelling.h>
#include <thalweg/dem/grain_materials.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <set>

namespace Thalweg
{
  namespace
  {
    constexpr double no_limit = std::numeric_limits<double>::max();

    /// Parts of a text between separators, without blanks around.
    std::vector<std::string>
    parts_of(const std::string &text, const char separator)
    {
      std::vector<std::string> parts;
      for (const std::string &part :
           dealii::Utilities::split_string_list(text, separator))
        parts.push_back(trimmed(part));
      return parts;
    }



    double
    number_in(const std::string &text,
              const std::string &where,
              const double       least,
              const double       greatest)
    {
      const auto value = finite_number(text);
      AssertThrow(value.has_value(),
                  dealii::ExcMessage("'" + where + "' has '" + text +
                                     "' where a number is expected."));
      AssertThrow(*value >= least && *value <= greatest,
                  dealii::ExcMessage(
                    "'" + where + "' has " + text + ", but it must be " +
                    (greatest == no_limit
                       ? (least > 0. ? "positive" : "at least 0")
                       : "between 0 and " +
                           std::string(greatest == 1. ? "1" : "0.5")) +
                    "."));
      return *value;
    }



    const char *const by_name =
      " One number for all materials, or one for each by name, `glass: 1 | "
      "steel: 2`.";
  } // namespace



  void
  GrainMaterials::declare_parameters(const Section &section)
  {
    const auto &any = dealii::Patterns::Anything();
    section.add("Names",
                names_,
                "",
                "Names of your own for the materials of grains and walls, "
                "separated by commas.");
    section.add("Density",
                density.text,
                "kg/m^3",
                std::string("Of grains.") + by_name,
                any);
    section.add("Young's modulus",
                young.text,
                "Pa",
                std::string("Of those laws of contact that know it.") + by_name,
                any);
    section.add("Poisson's ratio",
                poisson.text,
                "",
                std::string("Likewise, from 0 to less than 0.5.") + by_name,
                any);
    section.add("Restitution",
                restitution.text,
                "",
                std::string("The speed after a head-on impact over that "
                            "before, above 0.") +
                  by_name,
                any);
    section.add("Friction",
                friction.text,
                "",
                std::string("Coulomb's coefficient.") + by_name,
                any);
    section.add("Rolling friction",
                rolling.text,
                "",
                std::string("The greatest torque over normal force and "
                            "effective radius, which at a wall is the "
                            "grain's.") +
                  by_name,
                any);
    section.add("Rolling damping",
                rolling_damping,
                "",
                "Of the spring of `epsd`, a part of the critical damping.",
                dealii::Patterns::Double(0));
    section.add("Cohesion",
                cohesion.text,
                "Pa",
                std::string("Grains that touch attract each other by this "
                            "times pi times the square of the effective "
                            "radius.") +
                  by_name,
                any);
    const Section     pairs = section.enter("Pairs");
    const std::string text =
      "Of pairs, `glass, steel: 0.3 | steel, steel: 0.1`; others have the "
      "geometric mean of the two.";
    pairs.add("Restitution", restitution.pair_text, "", text, any);
    pairs.add("Friction", friction.pair_text, "", text, any);
    pairs.add("Rolling friction", rolling.pair_text, "", text, any);
    pairs.add("Cohesion", cohesion.pair_text, "Pa", text, any);
  }



  unsigned int
  GrainMaterials::find(const std::string &name, const std::string &where) const
  {
    std::string all;
    for (unsigned int m = 0; m < names_.size(); ++m)
      {
        if (names_[m] == name)
          return m;
        all += (all.empty() ? "'" : ", '") + names_[m] + "'";
      }
    throw dealii::ExcMessage("'" + where + "' has '" + name +
                             "', but 'Materials/Names' has " + all + ".");
  }



  void
  GrainMaterials::read(Property          &property,
                       const std::string &name,
                       const double       least,
                       const double       greatest) const
  {
    const std::string where = "Materials/" + name;
    if (property.text.find(':') == std::string::npos)
      {
        property.values.assign(
          n(), number_in(trimmed(property.text), where, least, greatest));
        return;
      }
    property.values.assign(n(), std::nan(""));
    for (const std::string &entry : parts_of(property.text, '|'))
      {
        const auto parts = parts_of(entry, ':');
        AssertThrow(parts.size() == 2,
                    dealii::ExcMessage("'" + where + "' has '" + entry +
                                       "'; write 'glass: 1 | steel: 2'."));
        property.values[find(parts[0], where)] =
          number_in(parts[1], where, least, greatest);
      }
    for (unsigned int m = 0; m < n(); ++m)
      AssertThrow(!std::isnan(property.values[m]),
                  dealii::ExcMessage("'" + where + "' has nothing for '" +
                                     names_[m] + "'."));
  }



  void
  GrainMaterials::read_pairs(Property          &property,
                             const std::string &name,
                             const double       least,
                             const double       greatest) const
  {
    read(property, name, least, greatest);
    const std::string where = "Materials/Pairs/" + name;
    property.of_pairs.resize(n() * n());
    for (unsigned int a = 0; a < n(); ++a)
      for (unsigned int b = 0; b < n(); ++b)
        property.of_pairs[a * n() + b] =
          a == b ? property.values[a]
                 : std::sqrt(property.values[a] * property.values[b]);
    if (trimmed(property.pair_text).empty())
      return;
    for (const std::string &entry : parts_of(property.pair_text, '|'))
      {
        const auto parts = parts_of(entry, ':');
        const auto two   = parts_of(parts[0], ',');
        AssertThrow(parts.size() == 2 && two.size() == 2,
                    dealii::ExcMessage("'" + where + "' has '" + entry +
                                       "'; write 'glass, steel: 0.3'."));
        const unsigned int a = find(two[0], where), b = find(two[1], where);
        property.of_pairs[a * n() + b] = property.of_pairs[b * n() + a] =
          number_in(parts[1], where, least, greatest);
      }
  }



  void
  GrainMaterials::initialize()
  {
    constexpr double positive        = std::numeric_limits<double>::min();
    constexpr double at_most_poisson = .4999;
    AssertThrow(!names_.empty() && names_.size() < 256,
                dealii::ExcMessage("'Materials/Names' has " +
                                   std::to_string(names_.size()) +
                                   " materials; there are from 1 to 255."));
    std::set<std::string> different;
    for (const std::string &name : names_)
      AssertThrow(different.insert(name).second,
                  dealii::ExcMessage("'Materials/Names' has '" + name +
                                     "' twice."));
    read(density, "Density", positive, no_limit);
    read(young, "Young's modulus", positive, no_limit);
    read(poisson, "Poisson's ratio", 0., at_most_poisson);
    // So small that nothing comes back.
    constexpr double least_restitution = 1e-3;
    read_pairs(restitution, "Restitution", least_restitution, 1.);
    read_pairs(friction, "Friction", 0., no_limit);
    read_pairs(rolling, "Rolling friction", 0., no_limit);
    read_pairs(cohesion, "Cohesion", 0., no_limit);
    densities_ = density.values;
  }



  std::vector<PairMaterial>
  GrainMaterials::pairs() const
  {
    std::vector<PairMaterial> table;
    for (unsigned int a = 0; a < n(); ++a)
      for (unsigned int b = 0; b < n(); ++b)
        {
          const double e1 = young.values[a], e2 = young.values[b];
          const double n1 = poisson.values[a], n2 = poisson.values[b];
          table.push_back({1. / ((1. - n1 * n1) / e1 + (1. - n2 * n2) / e2),
                           1. / (2. * (2. - n1) * (1. + n1) / e1 +
                                 2. * (2. - n2) * (1. + n2) / e2),
                           2. * e1 * e2 / (e1 + e2),
                           .5 * (n1 + n2),
                           restitution.of_pairs[a * n() + b],
                           cohesion.of_pairs[a * n() + b],
                           {friction.of_pairs[a * n() + b],
                            rolling.of_pairs[a * n() + b],
                            rolling_damping}});
        }
    return table;
  }
} // namespace Thalweg
