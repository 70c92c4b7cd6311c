// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_interface_interface_force_h
#define thalweg_interface_interface_force_h

#include <thalweg/core/registry.h>
#include <thalweg/fields/boundary_conditions.h>
#include <thalweg/interface/curvature.h>
#include <thalweg/interface/phase_field.h>

#include <deal.II/base/function_parser.h>

#include <array>
#include <memory>
#include <vector>

namespace Thalweg
{
  /**
   * @brief What surface tension does to the flow: registered under
   * "Interface/Surface tension".
   *
   * Models say what acts in each cell in the form of pressures, of which the
   * force is the gradient: the flow's own pressure balances that exactly,
   * with whatever densities and enrichment, and a drop is at rest to round-off
   * as far as its curvature is right.
   */
  template <int dim>
  class InterfaceForce
  {
  public:
    /// At the vertices of a cell, Pa.
    using Pressures = std::array<double, (1 << dim)>;

    /// What acts in a cell.
    struct CellForce
    {
      Pressures              pressures{}; ///< its gradient, everywhere
      dealii::Tensor<1, dim> density;     ///< in the denser fluid's part, N/m^3
    };

    virtual ~InterfaceForce() = default;

    virtual void
    declare_parameters(const Section &section) = 0;

    /// Sets up for the present mesh. What it refers to must outlive the object,
    /// or the next initialize(). @throws dealii::ExcMessage
    void
    initialize(const NodeSpace<dim>           &space,
               const BoundaryConditions<dim>  &conditions,
               const PhaseField<dim>          &phase,
               const SurfaceTensionParameters &parameters);

    /// Finds the forces for the present phases. Collective.
    void
    update();

    /// What acts in an owned cell; nullptr: nothing.
    const CellForce *
    force(const unsigned int cell) const
    {
      return index.empty() || index[cell] < 0 ? nullptr : &list[index[cell]];
    }

    /// Whether the pressure that balances the forces is not the whole one.
    virtual bool
    hides_pressure() const
    {
      return false;
    }

    /// Adds what it lacks to the owned values of a pressure, Pa.
    virtual void
    add_hidden_pressure(Vector &) const
    {}

  protected:
    /// Adds what acts in owned cells.
    virtual void
    find_forces() = 0;

    void
    add(const unsigned int cell, const CellForce &force);

    /// Finds the curvature of the interface near it, unless it is given.
    /// Collective.
    void
    find_curvature();

    const NodeSpace<dim>           *space      = nullptr;
    const PhaseField<dim>          *phase      = nullptr;
    const SurfaceTensionParameters *parameters = nullptr;
    std::unique_ptr<Curvature<dim>> finder;

    /// Positive where the first fluid is convex, 1/m; and 1 where it is known.
    Vector curvature, is_known;

  private:
    /// The function that is given at nodes near the interface.
    void
    evaluate_given_curvature();

    std::vector<int>                             index;
    std::vector<CellForce>                       list;
    std::unique_ptr<dealii::FunctionParser<dim>> given;
  };
} // namespace Thalweg

#endif
