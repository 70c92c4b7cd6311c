// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_scalar_diffusion_h
#define thalweg_fluid_scalar_diffusion_h

#include <thalweg/fields/boundary_faces.h>
#include <thalweg/fields/scalar_conditions.h>
#include <thalweg/fluid/melting_solver.h>
#include <thalweg/fluid/scalar_operator.h>
#include <thalweg/fluid/scalar_view.h>
#include <thalweg/linear_algebra/krylov.h>

#include <map>
#include <memory>
#include <vector>

namespace Thalweg
{
  /// What a scalar was given, in its unit times the capacity's times m^dim.
  struct ScalarSupply
  {
    double through = 0.; ///< boundaries
    double source  = 0.;

    double
    total() const
    {
      return through + source;
    }
  };

  /**
   * @brief C dh/dt = div(k grad s) + f with conditions at boundaries, on the
   * mesh, from one time to another, where h is the scalar s itself, or, where
   * something melts, its heat (see Melting).
   *
   * Two implicit stages (the SDIRK method of second order with gamma = 1 -
   * 1/sqrt(2); R. Alexander, SIAM J. Numer. Anal. 14, 1977, p. 1006): what is
   * rough is damped as by the implicit Euler method. Values that are given at
   * boundaries go to those at the end in a straight line. What melts makes a
   * stage nonlinear, see MeltingSolver.
   */
  template <int dim>
  class ScalarDiffusion
  {
  public:
    /**
     * @param space, conditions must outlive the object
     * @param source amount a volume and second, or nullptr; likewise
     * @param tolerance of the solver, a part of the first residual
     * @param law of what melts; its latent heat is said by update()
     */
    ScalarDiffusion(const NodeSpace<dim>  &space,
                    ScalarConditions<dim> &conditions,
                    dealii::Function<dim> *source,
                    const double           tolerance,
                    const Melting         &law = {});

    using Material = typename ScalarOperator<dim>::Material;

    /// See ScalarOperator::update(). @param latent_heat amount a volume
    void
    update(const PhaseField<dim> &phase,
           const Material        &capacity,
           const Material        &conductivity,
           const Material        &latent_heat = {});

    /// What melts at the nodes.
    const NodalMelting<dim> &
    melting() const
    {
      return melting_;
    }

    /**
     * @brief Advances a scalar by @p dt, s. Collective.
     * @param heat the scalar, or its heat where something melts; ghosted and
     *   consistent, in and out
     * @param time at which that begins, s
     * @param supply gets what comes in, of this rank
     * @return iterations of the solver. @throws StepFailure
     */
    unsigned int
    advance(Vector       &heat,
            const double  time,
            const double  dt,
            ScalarSupply &supply);

    /// Sets given nodes to their values at @p time, s. Collective.
    void
    set_given(Vector &scalar, const double time) const;

    /// The same for a heat.
    void
    set_given_heat(Vector &heat, const double time) const;

    /// Sets given nodes to 0; owned values.
    void
    clear_given(Vector &scalar) const;

    /// What there is of a scalar, or heat. Collective.
    double
    content(const Vector &heat) const;

    /// Lumped capacities, see ScalarOperator.
    const Vector &
    capacity() const
    {
      return matrix.capacity();
    }

    /**
     * @brief What diffuses out of the domain at each node of a boundary in a
     * second for each unit of its measure, at nodes where the value is given;
     * for pictures and tables. Collective.
     * @param scalar at @p time, ghosted and consistent
     * @return by boundary, of this rank: fluxes and the measures that belong
     *   to them
     */
    BoundaryFluxes
    fluxes(const Vector &scalar, const double time);

  private:
    /// A node where the value is given.
    struct GivenNode
    {
      unsigned int       node;
      dealii::Point<dim> position;
      /// The boundaries that give it, with the measures they have there.
      std::map<dealii::types::boundary_id, double> measures;
    };

    void
    collect_given_nodes();

    /// Calls @p visit(node, amount a second, rate a second and unit of the
    /// scalar) for what faces supply to nodes of owned cells.
    template <typename Visitor>
    void
    for_each_supply(const Visitor &visit) const;

    /// What given nodes have at @p time, s.
    std::vector<double>
    given_values(const double time) const;

    /// Sets them to it, one value a GivenNode. Collective.
    void
    set_given(Vector &scalar, const std::vector<double> &values) const;

    /// Finds load and exchange at @p time.
    void
    find_load(const double time);

    /// Finds what each node gets in a second by diffusion and from outside,
    /// into `residual`; after find_load().
    void
    find_gain(const Vector &scalar);

    /**
     * @brief One implicit stage of @p tau, s, to @p time.
     * @param heat from where it starts; afterwards what it comes to
     * @param given to what value given nodes come, one a GivenNode
     * @param weight with which its rate counts, s
     */
    unsigned int
    make_stage(Vector                    &heat,
               const double               time,
               const double               tau,
               const std::vector<double> &given,
               const double               weight,
               ScalarSupply              &supply);

    /// The implicit equation of a stage of @p tau, s, with the load that was
    /// found: where nothing melts, with @p scalar before and after it.
    unsigned int
    diffuse(Vector &scalar, const double tau);

    /// Where something does, with `before` before it.
    /// @param heat in: a guess with given nodes; out: the solution
    unsigned int
    melt(Vector &heat, const double tau);

    /// The scalar of a heat: the same vector where nothing melts.
    const Vector &
    value_of(const Vector &heat);

    /// The heat of values at given nodes.
    std::vector<double>
    heats_of(std::vector<double> values) const;

    /// Counts what a stage has supplied. @param rate of the heat, per s
    void
    count(const Vector &scalar,
          const Vector &rate,
          const double  weight,
          ScalarSupply &supply);

    const NodeSpace<dim>  &space;
    ScalarConditions<dim> &conditions;
    dealii::Function<dim> *source;
    const double           tolerance;
    ScalarOperator<dim>    matrix;
    NodalMelting<dim>      melting_;
    /// nullptr where nothing melts
    std::unique_ptr<MeltingSolver<dim>> melting_solver;
    std::vector<BoundaryFace<dim>>      faces; ///< with flux or exchange
    std::vector<GivenNode>              given_nodes;
    std::vector<bool>                   is_given;
    Vector                              load, exchange, source_load;
    Vector                              residual, increment, before, value;
  };
} // namespace Thalweg

#endif
