#include <thalweg/fields/q1_integrals.h>
#include <thalweg/simulation/flow_quantities.h>

#include <cmath>

namespace Thalweg
{
  template <int dim>
  std::vector<std::pair<std::string, double>>
  flow_quantities(const SolutionView<dim>      &solution,
                  const PhaseField<dim>        &phase,
                  const dealii::Tensor<1, dim> &gravity)
  {
    static const Q1Integrals<dim> integrals;
    const NodeSpace<dim>         &space = solution.space;
    const CellGraph<dim>         &graph = solution.mesh.graph();

    double energy[2]  = {0., 0.};
    double fastest[2] = {0., 0.};
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      {
        const int cut_index = phase.cut_index(c);
        auto      mass = cut_index < 0 ? integrals.node_measures(graph.cell(c))
                                       : phase.cut_cells()[cut_index].mass;
        if (cut_index < 0)
          for (double &value : mass)
            value *= phase.fluid(c).density;
        for (unsigned int v = 0; v < mass.size(); ++v)
          {
            const unsigned int node   = space.nodes(c)[v];
            double             square = 0, height = 0;
            for (unsigned int d = 0; d < dim; ++d)
              {
                square +=
                  std::pow(solution.velocity.local_element(dim * node + d), 2);
                height -= gravity[d] * graph.cell(c).vertices[v][d];
              }
            energy[0] += .5 * mass[v] * square;
            energy[1] += mass[v] * height;
            const unsigned int fluid =
              solution.fluids.size() == 2 &&
                  solution.level_set.local_element(node) > 0
                ? 1
                : 0;
            fastest[fluid] = std::max(fastest[fluid], std::sqrt(square));
          }
      }
    const MPI_Comm communicator =
      solution.mesh.triangulation().get_communicator();
    dealii::Utilities::MPI::sum(energy, communicator, energy);
    dealii::Utilities::MPI::max(fastest, communicator, fastest);
    return {{"kinetic energy [J]", energy[0]},
            {"potential energy [J]", energy[1]},
            {"max velocity 1 [m/s]", fastest[0]},
            {"max velocity 2 [m/s]", fastest[1]}};
  }



  template std::vector<std::pair<std::string, double>>
  flow_quantities<2>(const SolutionView<2> &,
                     const PhaseField<2> &,
                     const dealii::Tensor<1, 2> &);
  template std::vector<std::pair<std::string, double>>
  flow_quantities<3>(const SolutionView<3> &,
                     const PhaseField<3> &,
                     const dealii::Tensor<1, 3> &);
} // namespace Thalweg
