// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/fields/nodal_moments.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/linear_algebra/plane_fit.h>
#include <thalweg/transfer/negligible_weight.h>
#include <thalweg/transfer/node_targets.h>
#include <thalweg/transfer/projection.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    /// Where particles miss their plane by this part of their distance from
    /// the node, it and the plane of values that are cut off count alike.
    constexpr double middle_misfit_of_kept      = .5;
    constexpr double middle_misfit_of_distorted = .1;

    /// The square of a misfit that is nothing but round-off, in parts of the
    /// square of what is fitted.
    constexpr double round_off = 1e-12;



    /// Sums over the particles around a node, each with its weight w.
    template <int dim>
    struct Moments
    {
      static constexpr unsigned int n = dim + 1;
      /// w b_i b_j of the lower triangle, w b_i phi, and w b_i with phi cut
      /// off, where b = (1, r); and w phi^2.
      static constexpr unsigned int size = n * (n + 1) / 2 + 2 * n + 1;

      std::array<double, size> sums{};

      /// @param offset of the particle from the node
      void
      add(const double                  weight,
          const dealii::Tensor<1, dim> &offset,
          const double                  phi,
          const double                  cut_off_phi)
      {
        std::array<double, n> row;
        row[0] = weight;
        for (unsigned int d = 0; d < dim; ++d)
          row[d + 1] = weight * offset[d];
        unsigned int k = 0;
        for (unsigned int i = 0; i < n; ++i)
          {
            sums[k++] += row[i];
            for (unsigned int j = 1; j <= i; ++j)
              sums[k++] += row[i] * offset[j - 1];
          }
        for (unsigned int i = 0; i < n; ++i)
          sums[k++] += row[i] * phi;
        for (unsigned int i = 0; i < n; ++i)
          sums[k++] += row[i] * cut_off_phi;
        sums[k] += weight * phi * phi;
      }

      /// The level set at the node, or nothing if there are no particles.
      /// @param middle_misfit with which both planes count alike
      std::optional<double>
      value(const double middle_misfit) const;

    private:
      /// Where the values that are cut off begin.
      static constexpr unsigned int cut_off = size - 1 - n;

      /// What value() is where there are too few particles for a plane: the
      /// mean of the values that are cut off (Eq. 69).
      std::optional<double>
      mean() const;
    };



    template <int dim>
    std::optional<double>
    Moments<dim>::mean() const
    {
      if (sums[0] > negligible_weight)
        return sums[cut_off] / sums[0];
      return {};
    }



    template <int dim>
    std::optional<double>
    Moments<dim>::value(const double middle_misfit) const
    {
      dealii::Tensor<2, n> matrix;
      dealii::Tensor<1, n> load, cut_off_load;
      unsigned int         k = 0;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          matrix[i][j] = matrix[j][i] = sums[k++];
      for (unsigned int i = 0; i < n; ++i)
        load[i] = sums[k++];
      for (unsigned int i = 0; i < n; ++i)
        cut_off_load[i] = sums[k++];
      const PlaneFit<n> fit(matrix);
      if (!fit.is_determined())
        return mean();

      double spread = 0.;
      for (unsigned int i = 1; i < n; ++i)
        spread += matrix[i][i];
      const auto plane  = fit.solve(load);
      double     misfit = sums[k] - plane.explained;
      // Two layers of particles lie on a plane whatever they carry, but not on
      // that of a distance.
      double slope = 0.;
      for (unsigned int i = 1; i < n; ++i)
        slope += plane.unknowns[i] * plane.unknowns[i];
      slope = std::sqrt(slope);
      if (slope > 1.)
        misfit += spread * (slope - 1.) * (slope - 1.);
      if (misfit <= round_off * sums[k])
        return plane.unknowns[0];
      const double part =
        1. / (1. + misfit / (middle_misfit * middle_misfit * spread));
      return part * plane.unknowns[0] +
             (1. - part) * fit.solve(cut_off_load).unknowns[0];
    }
  } // namespace



  /**
   * @brief The level set by least squares: around each node the plane is
   * sought that fits the particles best, with the shape function as weight.
   * A plane stays a plane on any mesh and with any particles. Velocities are
   * averaged (Eq. 69 with densities).
   *
   * What the flow has distorted is no plane any more, and particles from deep
   * inside of a fluid would move the surface. The more the particles around a
   * node miss their plane, the more counts the one that fits their values cut
   * off at the band.
   */
  template <int dim>
  class LeastSquares : public Projection<dim>
  {
  public:
    void
    declare_parameters(const Section &) override
    {}

    void
    project(const Population<dim> &population,
            const NodeSpace<dim>  &space,
            const Fluids          &fluids,
            Vector                &velocity,
            Vector                &level_set) const override;

  private:
    using NodalMoments = std::vector<Moments<dim>>;

    /// Adds the particles of a cell to the nodes around them.
    void
    accumulate(const Population<dim>        &population,
               const NodeSpace<dim>         &space,
               const unsigned int            cell,
               const double                  length,
               std::vector<NodeTarget<dim>> &targets,
               NodalMoments                 &nodal) const;
  };



  template <int dim>
  void
  LeastSquares<dim>::accumulate(const Population<dim>        &population,
                                const NodeSpace<dim>         &space,
                                const unsigned int            cell,
                                const double                  length,
                                std::vector<NodeTarget<dim>> &targets,
                                NodalMoments                 &nodal) const
  {
    const CellGraph<dim> &graph   = space.mesh().graph();
    const auto           &nodes   = space.nodes(cell);
    const double          inverse = 1. / length;
    const double limit = this->band * graph.cell(cell).edges().first * inverse;
    const bool   is_hanging =
      std::any_of(nodes.begin(), nodes.end(), [&](const unsigned int node) {
        const auto masters = space.hanging_masters(node);
        return masters.first != masters.second;
      });
    if (is_hanging)
      find_node_targets(space, cell, targets);

    std::array<Moments<dim>, (1 << dim)> moments;
    for (const auto &particle : population.in_cell(cell))
      {
        const auto   shape = Q1::values<dim>(particle.reference());
        const auto  &x     = particle.position();
        const double phi =
          particle.properties()[Population<dim>::level_set_offset] * inverse;
        const double cut_off = std::clamp(phi, -limit, limit);
        if (!is_hanging)
          for (unsigned int v = 0; v < nodes.size(); ++v)
            moments[v].add(shape[v],
                           (x - graph.cell(cell).vertices[v]) * inverse,
                           phi,
                           cut_off);
        else
          for (const NodeTarget<dim> &target : targets)
            {
              nodal[target.node].add(target.weight(shape),
                                     (x - target.position) * inverse,
                                     phi,
                                     cut_off);
            }
      }
    if (!is_hanging)
      for (unsigned int v = 0; v < nodes.size(); ++v)
        for (unsigned int k = 0; k < Moments<dim>::size; ++k)
          nodal[nodes[v]].sums[k] += moments[v].sums[k];
  }



  template <int dim>
  void
  LeastSquares<dim>::project(const Population<dim> &population,
                             const NodeSpace<dim>  &space,
                             const Fluids          &fluids,
                             Vector                &velocity,
                             Vector                &level_set) const
  {
    project_momentum(population, space, fluids, velocity);

    // One length on all processes, since they add up their moments.
    const double length = dealii::Utilities::MPI::min(
      space.mesh().graph().minimal_extent(),
      space.mesh().triangulation().get_communicator());
    NodalMoments                 nodal(space.dependences().n_nodes());
    std::vector<NodeTarget<dim>> targets;
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      accumulate(population, space, c, length, targets, nodal);

    join_moments(space, nodal);

    const double middle_misfit = this->distances_are_kept
                                   ? middle_misfit_of_kept
                                   : middle_misfit_of_distorted;
    level_set.zero_out_ghost_values();
    for (unsigned int node = 0; node < space.n_owned_nodes(); ++node)
      if (const auto value = nodal[node].value(middle_misfit))
        level_set.local_element(node) = *value * length;
    space.interpolate(level_set, 1);
  }



  THALWEG_INSTANTIATE(LeastSquares)
  THALWEG_REGISTER(Projection,
                   LeastSquares,
                   "least squares",
                   "the level set by fitting a plane around each node, "
                   "velocities as by 'weighted average'")
} // namespace Thalweg
