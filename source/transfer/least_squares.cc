#include <thalweg/fields/q1_cell.h>
#include <thalweg/transfer/plane_fit.h>
#include <thalweg/transfer/projection.h>

namespace Thalweg
{
  namespace
  {
    /// A node that a cell's particles speak to: its weight is a combination
    /// of the shape functions of the cell's vertices.
    template <int dim>
    struct Target
    {
      unsigned int                   node;
      dealii::Point<dim>             position;
      std::array<double, (1 << dim)> coefficients;
    };



    /// Sums of weight times products of (1, r_1, ...), and of weight times
    /// value times (1, r_1, ...).
    template <int dim>
    struct Moments
    {
      static constexpr unsigned int n = dim + 1;

      explicit Moments(const NodeSpace<dim> &space)
      {
        for (auto &row : matrix)
          for (unsigned int j = 0; j < n; ++j)
            space.initialize_scalar(row[j]);
        for (auto &entry : load)
          space.initialize_scalar(entry);
      }

      void
      fold(const NodeSpace<dim> &space)
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            for (unsigned int j = 0; j <= i; ++j)
              space.fold(matrix[i][j], 1);
            space.fold(load[i], 1);
          }
      }

      std::array<std::array<Vector, n>, n> matrix; ///< lower triangle
      std::array<Vector, n>                load;
    };
  } // namespace



  /**
   * @brief The level set by least squares: around each node the plane is
   * sought that fits the particles best, with the shape function as weight.
   * A plane stays a plane on any mesh and with any particles. Velocities are
   * averaged (Eq. 69 with densities).
   */
  template <int dim>
  class LeastSquares : public Projection<dim>
  {
  public:
    LeastSquares()
      : average(
          Registry<Projection<dim>>::entries().at("weighted average").make())
    {}

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
    void
    accumulate(const Population<dim> &population,
               const NodeSpace<dim>  &space,
               const unsigned int     cell,
               const double           length,
               Moments<dim>          &moments) const;

    std::vector<Target<dim>>
    targets(const NodeSpace<dim> &space, const unsigned int cell) const;

    std::unique_ptr<Projection<dim>> average;
  };



  template <int dim>
  std::vector<Target<dim>>
  LeastSquares<dim>::targets(const NodeSpace<dim> &space,
                             const unsigned int    cell) const
  {
    const auto              &geometry = space.mesh().graph().cell(cell);
    const auto              &nodes    = space.nodes(cell);
    std::vector<Target<dim>> result;
    const auto               add = [&result, &geometry](const unsigned int        node,
                                          const dealii::Point<dim> &position,
                                          const unsigned int        vertex,
                                          const double              weight) {
      for (Target<dim> &target : result)
        if (target.node == node && (target.position - position).norm() <=
                                     1e-6 * geometry.extent.norm())
          {
            target.coefficients[vertex] += weight;
            return;
          }
      Target<dim> target{node, position, {}};
      target.coefficients[vertex] = weight;
      result.push_back(target);
    };
    for (unsigned int v = 0; v < nodes.size(); ++v)
      {
        const auto hanging = space.hanging_masters(nodes[v]);
        if (hanging.first == hanging.second)
          add(nodes[v], geometry.vertices[v], v, 1.);
        for (unsigned int k = hanging.first; k < hanging.second; ++k)
          {
            const auto &entry    = space.dependences().all()[k];
            auto        position = space.position(entry.master);
            // The nearest image of a master behind a periodic boundary.
            for (const auto &offset : space.mesh().graph().periodic_offsets())
              if ((position + offset).distance(geometry.vertices[v]) <
                  position.distance(geometry.vertices[v]))
                position += offset;
            add(entry.master, position, v, entry.weight);
          }
      }
    return result;
  }



  template <int dim>
  void
  LeastSquares<dim>::accumulate(const Population<dim> &population,
                                const NodeSpace<dim>  &space,
                                const unsigned int     cell,
                                const double           length,
                                Moments<dim>          &moments) const
  {
    constexpr unsigned int                 n    = dim + 1;
    const auto                             list = targets(space, cell);
    std::vector<std::array<double, n * n>> matrix(list.size());
    std::vector<std::array<double, n>>     load(list.size());
    for (unsigned int t = 0; t < list.size(); ++t)
      {
        matrix[t].fill(0.);
        load[t].fill(0.);
      }
    for (const auto &particle : population.handler().particles_in_cell(
           population.mesh().graph().iterator(cell)))
      {
        const auto   shape = Q1::values<dim>(particle.get_reference_location());
        const auto  &x     = particle.get_location();
        const double phi =
          particle.get_properties()[Population<dim>::level_set_offset];
        for (unsigned int t = 0; t < list.size(); ++t)
          {
            double weight = 0;
            for (unsigned int v = 0; v < shape.size(); ++v)
              weight += list[t].coefficients[v] * shape[v];
            std::array<double, n> basis;
            basis[0] = 1.;
            for (unsigned int d = 0; d < dim; ++d)
              basis[d + 1] = (x[d] - list[t].position[d]) / length;
            for (unsigned int i = 0; i < n; ++i)
              {
                for (unsigned int j = 0; j <= i; ++j)
                  matrix[t][i * n + j] += weight * basis[i] * basis[j];
                load[t][i] += weight * basis[i] * phi;
              }
          }
      }
    for (unsigned int t = 0; t < list.size(); ++t)
      for (unsigned int i = 0; i < n; ++i)
        {
          for (unsigned int j = 0; j <= i; ++j)
            moments.matrix[i][j].local_element(list[t].node) +=
              matrix[t][i * n + j];
          moments.load[i].local_element(list[t].node) += load[t][i];
        }
  }



  template <int dim>
  void
  LeastSquares<dim>::project(const Population<dim> &population,
                             const NodeSpace<dim>  &space,
                             const Fluids          &fluids,
                             Vector                &velocity,
                             Vector                &level_set) const
  {
    average->project(population, space, fluids, velocity, level_set);

    constexpr unsigned int n = dim + 1;
    // One length on all processes, since they add up their moments.
    const double length = dealii::Utilities::MPI::min(
      space.mesh().graph().minimal_extent(),
      space.mesh().triangulation().get_communicator());
    Moments<dim> moments(space);
    for (unsigned int c = 0; c < space.mesh().graph().n_owned_cells(); ++c)
      accumulate(population, space, c, length, moments);
    moments.fold(space);

    level_set.zero_out_ghost_values();
    for (unsigned int node = 0; node < level_set.locally_owned_size(); ++node)
      {
        dealii::Tensor<2, n> matrix;
        dealii::Tensor<1, n> load;
        for (unsigned int i = 0; i < n; ++i)
          {
            for (unsigned int j = 0; j <= i; ++j)
              matrix[i][j] = matrix[j][i] =
                moments.matrix[i][j].local_element(node);
            load[i] = moments.load[i].local_element(node);
          }
        if (const auto value = solve_for_first(matrix, load))
          level_set.local_element(node) = *value;
      }
    space.interpolate(level_set, 1);
  }



  THALWEG_INSTANTIATE(LeastSquares)
  THALWEG_REGISTER(Projection,
                   LeastSquares,
                   "least squares",
                   "the level set by fitting a plane around each node, "
                   "velocities as by 'weighted average'")
} // namespace Thalweg
