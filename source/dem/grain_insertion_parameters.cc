// SPDX-License-Identifier: LGPL-2.1-or-later
// The parameters of GrainInsertion.
#include <thalweg/dem/grain_insertion.h>
#include <thalweg/fields/expression.h>

#include <cmath>

namespace Thalweg
{
  template <int dim>
  void
  GrainInsertion<dim>::declare_parameters(const Section     &section,
                                          const std::string &place,
                                          const unsigned int order)
  {
    where = place;
    index = order;
    using namespace dealii::Patterns;
    section.add("Region",
                region,
                "",
                "Centers of grains are where this function of x, y, z and t is "
                "positive, in the mesh, and a radius or more from walls.",
                Anything());
    section.add("Pattern",
                pattern,
                "",
                "`lattice`: on a square or cubic lattice; `random`: without "
                "overlap; `none`: no grains come in.",
                Selection("lattice|random|none"));
    section.add("Spacing",
                spacing,
                "m",
                "Of the lattice; 0: the largest diameter.",
                Double(0));
    section.add("Shake",
                shake,
                "m",
                "By how much each coordinate of a place on the lattice is off, "
                "at random, at most.",
                Double(0));
    section.add("Number",
                number,
                "",
                "How many grains come in at a time; 0, on a lattice: as many "
                "as have room.");
    section.add("Diameter", diameter, "m", "The mean one.", Double(0));
    section.add("Sizes",
                sizes,
                "",
                "Which diameters: `mono`; `uniform`: from mean minus spread to "
                "mean plus spread; `normal`: with the spread as standard "
                "deviation, within three of them; `lognormal`: likewise of "
                "their logarithm, with the mean as median.",
                Selection("mono|uniform|normal|lognormal"));
    section.add("Spread",
                spread,
                "m",
                "See above; for `lognormal` without unit.",
                Double(0));
    section.add("Material",
                material,
                "",
                "One of `Materials/Names`; nothing: the first.",
                Anything());
    section.add("Velocity",
                velocity,
                "m/s",
                "Of grains when they come in: a function of x, y, z and t with "
                "semicolons between the components.",
                Anything());
    section.add(
      "Spin", spin, "rad/s", "Likewise; one component in 2D.", Anything());
    section.add("Seed", seed, "", "Another one gives other random numbers.");
    declare_times(section);
  }



  template <int dim>
  void
  GrainInsertion<dim>::declare_times(const Section &section)
  {
    using dealii::Patterns::Double;
    section.add("First time", first, "s", "When grains come in.", Double(0));
    section.add("Interval",
                interval,
                "s",
                "After what time more come in; 0: never.",
                Double(0));
    section.add("Last time",
                last,
                "s",
                "No more come in after this; 0: they do to the end.",
                Double(0));
    section.add(
      "Number rate",
      number_rate,
      "1/s",
      "A stream: so many come in each second, at random places of the "
      "region, in each interval those that are due in it. It must be "
      "short enough that there is room: what came in before must "
      "have left the region.",
      Double(0));
    section.add("Mass rate",
                mass_rate,
                "kg/s",
                "The same by mass; in 2D of discs of unit length.",
                Double(0));
  }



  template <int dim>
  void
  GrainInsertion<dim>::check(const GrainMaterials &materials) const
  {
    if (pattern == "none")
      return;
    parse_expression<dim>(region, 1, where + "/Region");
    parse_expression<dim>(velocity, dim, where + "/Velocity");
    parse_expression<dim>(spin, dim == 3 ? 3 : 1, where + "/Spin");
    if (!material.empty())
      materials.find(material, where + "/Material");
    AssertThrow(diameter > 0.,
                dealii::ExcMessage("\'" + where +
                                   "/Diameter' is missing; grains "
                                   "need one above 0."));
    AssertThrow(sizes == "mono" || spread > 0.,
                dealii::ExcMessage("\'" + where + "/Sizes' is '" + sizes +
                                   "', which needs a 'Spread' above 0."));
    AssertThrow((sizes != "uniform" || spread < diameter) &&
                  (sizes != "normal" || 3. * spread < diameter),
                dealii::ExcMessage("\'" + where +
                                   "/Spread' is so large that "
                                   "diameters reach zero."));
    check_stream();
    AssertThrow(pattern != "random" || number > 0 || is_stream(),
                dealii::ExcMessage("\'" + where +
                                   "/Pattern' is 'random', which "
                                   "needs a 'Number' above 0."));
    AssertThrow(pattern != "lattice" || spacing == 0. ||
                  spacing - 2. * shake >= largest_diameter() * (1. - 1e-9),
                dealii::ExcMessage("Grains overlap at the start: "
                                   "\'" +
                                   where +
                                   "/Spacing' less twice 'Shake' "
                                   "must be at least the largest diameter."));
    AssertThrow(last == 0. || (interval > 0. && last >= first),
                dealii::ExcMessage("\'" + where +
                                   "/Last time' is for grains that "
                                   "come in at intervals, and not before the "
                                   "first ones: give an 'Interval', or leave "
                                   "it out."));
  }



  template <int dim>
  void
  GrainInsertion<dim>::check_stream() const
  {
    AssertThrow(number_rate == 0. || mass_rate == 0.,
                dealii::ExcMessage(
                  "\'" + where +
                  "/Number rate' and 'Mass rate' "
                  "are both given: a stream has one of them."));
    AssertThrow(!is_stream() || interval > 0.,
                dealii::ExcMessage("A stream needs an '" + where +
                                   "/Interval' "
                                   "above 0, at which grains come in."));
    AssertThrow(!is_stream() || (pattern == "random" && number == 0),
                dealii::ExcMessage("A stream needs '" + where +
                                   "/Pattern = "
                                   "random' and no 'Number', which follows "
                                   "from its rate."));
  }



  template <int dim>
  std::size_t
  GrainInsertion<dim>::number_of_stream(const unsigned int n) const
  {
    const double a_time = number_rate * interval;
    return static_cast<std::size_t>(std::floor((n + 1.) * a_time + 1e-9)) -
           static_cast<std::size_t>(std::floor(n * a_time + 1e-9));
  }



  template <int dim>
  double
  GrainInsertion<dim>::largest_diameter() const
  {
    return sizes == "uniform"     ? diameter + spread
           : sizes == "normal"    ? diameter + 3. * spread
           : sizes == "lognormal" ? diameter * std::exp(3. * spread)
                                  : diameter;
  }



  template <int dim>
  void
  GrainInsertion<dim>::check_on_mesh(const Mesh<dim> &mesh) const
  {
    if (pattern == "none")
      return;
    const auto &[lower, upper] = mesh.box();
    double least               = std::numeric_limits<double>::max();
    for (unsigned int d = 0; d < dim; ++d)
      least = std::min(least, upper[d] - lower[d]);
    AssertThrow(largest_diameter() <= least,
                dealii::ExcMessage("The largest grain, of a diameter of " +
                                   std::to_string(largest_diameter()) +
                                   " m, does not fit into the domain " +
                                   mesh.extent() + ": see '" + where +
                                   "/Diameter'."));
    for (const PeriodicPair &pair : mesh.periodic_pairs())
      AssertThrow(upper[pair.direction] - lower[pair.direction] >
                    2.5 * largest_diameter(),
                  dealii::ExcMessage(
                    "Periodic boundaries are nearer to each other than two "
                    "diameters and a half of the largest grain, which would "
                    "touch others twice: see '" +
                    where + "/Diameter'."));
  }



  template <int dim>
  double
  GrainInsertion<dim>::time_of(const unsigned int n) const
  {
    const double never = std::numeric_limits<double>::infinity();
    const double time  = first + n * interval;
    return pattern == "none" || (n > 0 && interval == 0.) ||
               (last > 0. && time > last)
             ? never
             : time;
  }



  template void
  GrainInsertion<2>::declare_parameters(const Section &,
                                        const std::string &,
                                        const unsigned int);
  template void
  GrainInsertion<2>::check(const GrainMaterials &) const;
  template void
  GrainInsertion<2>::check_on_mesh(const Mesh<2> &) const;
  template double
  GrainInsertion<2>::time_of(const unsigned int) const;
  template std::size_t
  GrainInsertion<2>::number_of_stream(const unsigned int) const;
  template double
  GrainInsertion<2>::largest_diameter() const;
  template void
  GrainInsertion<3>::declare_parameters(const Section &,
                                        const std::string &,
                                        const unsigned int);
  template void
  GrainInsertion<3>::check(const GrainMaterials &) const;
  template void
  GrainInsertion<3>::check_on_mesh(const Mesh<3> &) const;
  template double
  GrainInsertion<3>::time_of(const unsigned int) const;
  template std::size_t
  GrainInsertion<3>::number_of_stream(const unsigned int) const;
  template double
  GrainInsertion<3>::largest_diameter() const;
} // namespace Thalweg
