// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/compat.h>
#include <thalweg/fields/q1_integrals.h>
#include <thalweg/methods/flow_quantities.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// What is summed, and what is maximized, over the cells.
    template <int dim>
    struct Quantities
    {
      double                 kinetic_energy   = 0.;
      double                 potential_energy = 0.;
      dealii::Tensor<1, dim> momentum;
      double                 fastest[2] = {0., 0.};
    };


    /// Lumped at the vertices, cut where the fluids meet.
    template <int dim>
    Quantities<dim>
    sum_at_nodes(const FlowView<dim>          &solution,
                 const PhaseField<dim>        &phase,
                 const dealii::Tensor<1, dim> &gravity)
    {
      static const Q1Integrals<dim> integrals;
      const NodeSpace<dim>         &space     = solution.space;
      const CellGraph<dim>         &graph     = solution.mesh.graph();
      const dealii::Point<dim>     &reference = solution.mesh.box().first;
      Quantities<dim>               sums;
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        {
          const int cut_index = phase.cut_index(c);
          auto mass = cut_index < 0 ? integrals.node_measures(graph.cell(c))
                                    : phase.cut_cells()[cut_index].mass;
          if (cut_index < 0)
            for (double &value : mass)
              value *= phase.fluid(c).density;
          for (unsigned int v = 0; v < mass.size(); ++v)
            {
              const unsigned int     node = space.nodes(c)[v];
              dealii::Tensor<1, dim> velocity;
              for (unsigned int d = 0; d < dim; ++d)
                velocity[d] = solution.velocity.local_element(dim * node + d);
              sums.kinetic_energy += .5 * mass[v] * velocity.norm_square();
              sums.potential_energy -=
                mass[v] * (gravity * (graph.cell(c).vertices[v] - reference));
              sums.momentum += mass[v] * velocity;
              const unsigned int fluid =
                solution.fluids.size() == 2 &&
                    solution.level_set.local_element(node) > 0
                  ? 1
                  : 0;
              sums.fastest[fluid] =
                std::max(sums.fastest[fluid], velocity.norm());
            }
        }
      return sums;
    }


    /// The greatest speed at a cell's nodes.
    template <int dim>
    double
    fastest_at_nodes(const dealii::FiniteElement<dim> &fe,
                     const dealii::Vector<double>     &values)
    {
      double fastest = 0.;
      for (unsigned int n = 0; n < fe.dofs_per_cell / dim; ++n)
        {
          double square = 0.;
          for (unsigned int d = 0; d < dim; ++d)
            square += std::pow(values[fe.component_to_system_index(d, n)], 2);
          fastest = std::max(fastest, std::sqrt(square));
        }
      return fastest;
    }


    /// Integrals in the flow's own space; speeds at its nodes.
    template <int dim>
    Quantities<dim>
    integrate(const Mesh<dim>              &mesh,
              const FlowFields<dim>        &flow,
              const dealii::Tensor<1, dim> &gravity)
    {
      const CellGraph<dim>               &graph = mesh.graph();
      const auto                         &fe    = flow.velocity_dofs.get_fe();
      const dealii::QGauss<dim>           quadrature(fe.degree + 2);
      dealii::FEValues<dim>               values(flow.mapping,
                                   fe,
                                   quadrature,
                                   dealii::update_values |
                                     dealii::update_JxW_values |
                                     dealii::update_quadrature_points);
      dealii::Vector<double>              nodal_values(fe.dofs_per_cell);
      std::vector<dealii::Tensor<1, dim>> velocities(quadrature.size());
      Quantities<dim>                     sums;
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        {
          const auto cell =
            Compat::on_dof_handler(graph.iterator(c), flow.velocity_dofs);
          values.reinit(cell);
          values[dealii::FEValuesExtractors::Vector(0)].get_function_values(
            flow.velocity, velocities);
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              const double mass = flow.density * values.JxW(q);
              sums.kinetic_energy += .5 * mass * velocities[q].norm_square();
              sums.potential_energy -=
                mass *
                (gravity * (values.quadrature_point(q) - mesh.box().first));
              sums.momentum += mass * velocities[q];
            }
          cell->get_dof_values(flow.velocity, nodal_values);
          sums.fastest[0] =
            std::max(sums.fastest[0], fastest_at_nodes(fe, nodal_values));
        }
      return sums;
    }
  } // namespace


  template <int dim>
  std::vector<std::pair<std::string, double>>
  flow_quantities(const FlowView<dim>          &solution,
                  const PhaseField<dim>        &phase,
                  const dealii::Tensor<1, dim> &gravity)
  {
    Quantities<dim> sums =
      solution.flow == nullptr
        ? sum_at_nodes(solution, phase, gravity)
        : integrate(solution.mesh, *solution.flow, gravity);
    const MPI_Comm communicator =
      solution.mesh.triangulation().get_communicator();
    const auto sum = [&](const double value) {
      return dealii::Utilities::MPI::sum(value, communicator);
    };
    dealii::Utilities::MPI::max(sums.fastest, communicator, sums.fastest);
    std::vector<std::pair<std::string, double>> quantities{
      {"kinetic energy [J]", sum(sums.kinetic_energy)},
      {"potential energy [J]", sum(sums.potential_energy)}};
    for (unsigned int d = 0; d < dim; ++d)
      quantities.emplace_back(std::string("momentum ") + "xyz"[d] + " [kg m/s]",
                              sum(sums.momentum[d]));
    quantities.emplace_back("max velocity 1 [m/s]", sums.fastest[0]);
    quantities.emplace_back("max velocity 2 [m/s]", sums.fastest[1]);
    return quantities;
  }



  template std::vector<std::pair<std::string, double>>
  flow_quantities<2>(const FlowView<2> &,
                     const PhaseField<2> &,
                     const dealii::Tensor<1, 2> &);
  template std::vector<std::pair<std::string, double>>
  flow_quantities<3>(const FlowView<3> &,
                     const PhaseField<3> &,
                     const dealii::Tensor<1, 3> &);
} // namespace Thalweg
