// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_fluid_viscosities_h
#define thalweg_fluid_fluid_viscosities_h

#include <thalweg/fields/node_space.h>
#include <thalweg/materials/fluids.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace Thalweg
{
  /**
   * @brief The dynamic viscosities of the fluids in each cell: those of the
   * section "Fluids", unless something else is said.
   *
   * Methods of flows that heed that offer it under "viscosities"; couplings
   * set it. At first, and behind each attach(), they are those of "Fluids".
   */
  template <int dim>
  class FluidViscosities
  {
  public:
    static constexpr const char *port = "viscosities";

    /// @param space, fluids must outlive the object, or the next attach()
    void
    attach(const NodeSpace<dim> &space, const Fluids &fluids)
    {
      nodes  = &space;
      names  = &fluids;
      values = {};
    }

    /// Whose cells they are of.
    const NodeSpace<dim> &
    space() const
    {
      return *nodes;
    }

    const Fluids &
    fluids() const
    {
      return *names;
    }

    /// @param of_cells Pa s, of each owned cell
    void
    set(const unsigned int fluid, std::vector<double> of_cells)
    {
      values[fluid] = std::move(of_cells);
    }

    /// Whether they are not everywhere those of "Fluids".
    bool
    are_set() const
    {
      return !values[0].empty() || !values[1].empty();
    }

    /// Pa s, in an owned cell.
    double
    operator()(const unsigned int fluid, const unsigned int cell) const
    {
      return values[fluid].empty() ? (*names)[fluid].viscosity
                                   : values[fluid][cell];
    }

  private:
    const NodeSpace<dim>              *nodes = nullptr;
    const Fluids                      *names = nullptr;
    std::array<std::vector<double>, 2> values;
  };
} // namespace Thalweg

#endif
