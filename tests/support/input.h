// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_support_input_h
#define tests_support_input_h

#include <string>
#include <vector>

/// The text of a section of an input file with @p settings, "name = value",
/// and the text of subsections behind them.
inline std::string
section(const std::string              &name,
        const std::vector<std::string> &settings,
        const std::string              &subsections = "")
{
  std::string text = "subsection " + name + "\n";
  for (const std::string &setting : settings)
    text += "set " + setting + "\n";
  return text + subsections + "end\n";
}



/// A unit box with these repetitions, "4, 4", refined as often as @p levels
/// says.
inline std::string
box_of(const std::string              &repetitions,
       const std::string              &levels,
       const std::vector<std::string> &geometry = {})
{
  return section("Geometry",
                 geometry,
                 section("box", {"Repetitions = " + repetitions})) +
         section("Refinement", {"Local levels = " + levels});
}

/// The unit box of n^dim cells, refined once more where @p levels says so.
template <int dim>
std::string
unit_box(const unsigned int              n,
         const std::string              &levels   = "0",
         const std::vector<std::string> &geometry = {})
{
  std::string repetitions = std::to_string(n);
  for (unsigned int d = 1; d < dim; ++d)
    repetitions += ", " + std::to_string(n);
  return box_of(repetitions, levels, geometry);
}

/// Half of the unit box refined, with hanging nodes on a stair.
template <int dim>
std::string
hanging_box(const unsigned int n, const std::vector<std::string> &geometry = {})
{
  return unit_box<dim>(n, "if(x + y < 0.9, 1, 0)", geometry);
}

/// The text of "Refinement" for a mesh that adapts before every step.
/// @param criterion with its own @p settings
inline std::string
adapting_every_step(const std::string              &global_levels,
                    const std::string              &maximum_level,
                    const std::string              &criterion,
                    const std::vector<std::string> &settings = {})
{
  return section("Refinement",
                 {"Global levels = " + global_levels},
                 section("Adaptive",
                         {"Criteria = " + criterion,
                          "Maximum level = " + maximum_level},
                         section(criterion, settings)));
}

/// A given viscosity and density of the only fluid.
inline std::string
one_fluid(const double density, const double viscosity)
{
  return section("Fluids",
                 {"Number = 1"},
                 section("First fluid",
                         {"Density = " + std::to_string(density),
                          "Viscosity = " + std::to_string(viscosity)}));
}

/// Steps of one size until an end, s.
inline std::string
steps_of(const std::string &dt, const std::string &end)
{
  return section("Time", {"Time step = " + dt, "End time = " + end});
}

/// Densities and viscosities of two fluids.
inline std::string
two_fluids(const double density_1,
           const double density_2,
           const double viscosity_1 = 0.,
           const double viscosity_2 = 0.)
{
  return section("Fluids",
                 {},
                 section("First fluid",
                         {"Density = " + std::to_string(density_1),
                          "Viscosity = " + std::to_string(viscosity_1)}) +
                   section("Second fluid",
                           {"Density = " + std::to_string(density_2),
                            "Viscosity = " + std::to_string(viscosity_2)}));
}

/// `left: text | right: text` and so on, for all sides of a box.
template <int dim>
std::string
on_all_sides(const std::string &text)
{
  std::string all = "left: " + text + " | right: " + text +
                    " | bottom: " + text + " | top: " + text;
  if (dim == 3)
    all += " | front: " + text + " | back: " + text;
  return all;
}

/// How accurate the fractional step's linear solvers are.
inline std::string
tight_solver(const std::string &pressure, const std::string &velocity)
{
  return section("Fluid solver",
                 {},
                 section("fractional step",
                         {"Pressure tolerance = " + pressure,
                          "Velocity tolerance = " + velocity,
                          "Divergence tolerance = 1e-9"}));
}

#endif
