// SPDX-License-Identifier: LGPL-2.1-or-later
// Projections that find each node's velocity from the particles around it.
#include <thalweg/fields/q1_cell.h>
#include <thalweg/linear_algebra/plane_fit.h>
#include <thalweg/transfer/negligible_weight.h>
#include <thalweg/transfer/velocity_projection.h>

#include <algorithm>
#include <limits>

namespace Thalweg
{
  namespace
  {
    /**
     * @brief Around each node the polynomial of order 0 or 1 that fits the
     * particles best, with the hat function of the node in the lattice of all
     * nodes as weight.
     */
    template <int dim, unsigned int order>
    class NodalProjection : public VelocityProjection<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        if (order > 0)
          section.add("Limiter",
                      limiter,
                      "",
                      "Whether a node's velocity stays between those of the "
                      "particles around it, component by component.");
      }


      unsigned int
      project(const Population<dim>    &population,
              const LagrangeSpace<dim> &space,
              Vector                   &velocity) const override
      {
        Sums         sums(space, limiter);
        const double length = dealii::Utilities::MPI::min(
          space.mesh().graph().minimal_extent(),
          space.mesh().triangulation().get_communicator());
        for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
          add_cell(population, space, c, length, sums);
        sums.join(space);

        velocity.zero_out_ghost_values();
        for (unsigned int node = 0; node < space.n_owned_nodes(); ++node)
          if (sums.moments[0].local_element(node) > negligible_weight)
            for (unsigned int d = 0; d < dim; ++d)
              velocity.local_element(dim * node + d) = sums.value(node, d);
        space.interpolate(velocity, dim);
        return 0;
      }

    private:
      /// 1, and the offset from the node.
      static constexpr unsigned int n = order == 0 ? 1 : dim + 1;

      /// The sums over the particles around all nodes.
      struct Sums
      {
        Sums(const LagrangeSpace<dim> &space, const bool limited)
          : limited(limited)
        {
          for (Vector &moment : moments)
            space.initialize(moment, 1);
          for (Vector &load : loads)
            space.initialize(load, dim);
          if (!limited)
            return;
          for (Vector *vector : {&least, &greatest})
            space.initialize(*vector, dim);
          for (unsigned int i = 0; i < dim * space.dependences().n_nodes(); ++i)
            {
              least.local_element(i)    = std::numeric_limits<double>::max();
              greatest.local_element(i) = std::numeric_limits<double>::lowest();
            }
        }

        void
        join(const LagrangeSpace<dim> &space)
        {
          using Operation         = dealii::VectorOperation;
          const auto &dependences = space.dependences();
          for (Vector &moment : moments)
            dependences.join_copies(moment, 1, Operation::add);
          for (Vector &load : loads)
            dependences.join_copies(load, dim, Operation::add);
          if (!limited)
            return;
          dependences.join_copies(least, dim, Operation::min);
          dependences.join_copies(greatest, dim, Operation::max);
        }

        /// The fitted component @p d at an owned node.
        double
        value(const unsigned int node, const unsigned int d) const
        {
          const unsigned int i = dim * node + d;
          const double       mean =
            loads[0].local_element(i) / moments[0].local_element(node);
          if constexpr (order == 0)
            return mean;
          dealii::Tensor<2, n> matrix;
          dealii::Tensor<1, n> load;
          for (unsigned int j = 0, entry = 0; j < n; ++j)
            {
              for (unsigned int k = 0; k <= j; ++k, ++entry)
                matrix[j][k] = matrix[k][j] =
                  moments[entry].local_element(node);
              load[j] = loads[j].local_element(i);
            }
          const double fitted = solve_for_first(matrix, load).value_or(mean);
          return limited ? std::clamp(fitted,
                                      least.local_element(i),
                                      greatest.local_element(i))
                         : fitted;
        }

        const bool limited;
        /// The lower triangle, row by row, of products of the basis.
        std::array<Vector, n *(n + 1) / 2> moments;
        std::array<Vector, n>              loads;
        Vector                             least, greatest;
      };


      /// Adds the particles of a cell to the nodes around each.
      static void
      add_cell(const Population<dim>    &population,
               const LagrangeSpace<dim> &space,
               const unsigned int        cell,
               const double              length,
               Sums                     &sums)
      {
        const auto        &graph  = space.mesh().graph();
        const unsigned int degree = space.degree();
        std::array<dealii::Point<dim>, (dim == 2 ? 9 : 27)> positions;
        for (unsigned int i = 0; i < space.n_nodes_per_cell(); ++i)
          positions[i] =
            Q1::position<dim>(graph.cell(cell).vertices, space.unit_nodes()[i]);
        for (const auto &particle : population.in_cell(cell))
          {
            // The cell of the nodes' lattice where the particle is.
            dealii::Point<dim> local;
            unsigned int       first = 0, stride = 1;
            for (unsigned int d = 0; d < dim; ++d, stride *= degree + 1)
              {
                const double       x = degree * particle.reference()[d];
                const unsigned int index =
                  std::min<double>(degree - 1, std::max(0., std::floor(x)));
                local[d] = x - index;
                first += index * stride;
              }
            const auto shape = Q1::values<dim>(local);
            for (unsigned int v = 0; v < shape.size(); ++v)
              {
                unsigned int place = first;
                stride             = 1;
                for (unsigned int d = 0; d < dim; ++d, stride *= degree + 1)
                  place += ((v >> d) & 1u) * stride;
                add(particle,
                    shape[v],
                    (particle.position() - positions[place]) / length,
                    space.nodes(cell)[place],
                    sums);
              }
          }
      }


      /// Adds a particle with a weight to a node.
      template <typename Accessor>
      static void
      add(const Accessor               &particle,
          const double                  weight,
          const dealii::Tensor<1, dim> &offset,
          const unsigned int            node,
          Sums                         &sums)
      {
        std::array<double, n> basis;
        basis[0] = 1.;
        for (unsigned int i = 1; i < n; ++i)
          basis[i] = offset[i - 1];
        const auto properties = particle.properties();
        for (unsigned int i = 0, entry = 0; i < n; ++i)
          {
            for (unsigned int j = 0; j <= i; ++j, ++entry)
              sums.moments[entry].local_element(node) +=
                weight * basis[i] * basis[j];
            for (unsigned int d = 0; d < dim; ++d)
              sums.loads[i].local_element(dim * node + d) +=
                weight * basis[i] *
                properties[Population<dim>::velocity_offset + d];
          }
        if (sums.limited && weight > 0.)
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double value =
                properties[Population<dim>::velocity_offset + d];
              double &low  = sums.least.local_element(dim * node + d);
              double &high = sums.greatest.local_element(dim * node + d);
              low          = std::min(low, value);
              high         = std::max(high, value);
            }
      }


      bool limiter = false;
    };

    template <int dim>
    using NodalMean = NodalProjection<dim, 0>;
    template <int dim>
    using MovingLeastSquares = NodalProjection<dim, 1>;
  } // namespace

  THALWEG_REGISTER(VelocityProjection,
                   NodalMean,
                   "weighted average",
                   "means with the hat functions as weights (Eq. 69): first "
                   "order where particles stand unevenly, second elsewhere, "
                   "and diffusive")
  THALWEG_REGISTER(VelocityProjection,
                   MovingLeastSquares,
                   "moving least squares",
                   "a linear function fitted around each node: second order")
} // namespace Thalweg
