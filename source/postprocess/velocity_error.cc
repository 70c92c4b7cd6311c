// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/compat.h>
#include <thalweg/fields/expression.h>
#include <thalweg/postprocess/flow_access.h>
#include <thalweg/postprocess/scheduled_output.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// The difference between an exact flow and the computed one.
    template <int dim>
    class VelocityError : public TableOutput<dim>
    {
    public:
      VelocityError()
        : TableOutput<dim>("velocity_error.csv")
      {}


      void
      check_for_flow(const FlowOutline<dim> &) const override
      {
        parse_velocity();
        if (!pressure_expression.empty())
          parse_pressure();
      }

    private:
      void
      declare_own_parameters(const Section &section) override
      {
        section.add("Velocity",
                    velocity_expression,
                    "m/s",
                    "The exact velocity as a function of x, y, z and t, the "
                    "components separated by semicolons.",
                    dealii::Patterns::Anything());
        section.add("Pressure",
                    pressure_expression,
                    "Pa",
                    "The exact pressure as a function of x, y, z and t; empty: "
                    "no errors of the pressure. Constants do not count: the "
                    "mean of the difference is always subtracted from it.",
                    dealii::Patterns::Anything());
      }


      std::vector<std::string>
      columns(const FlowView<dim> &) override
      {
        exact_velocity = parse_velocity();
        std::vector<std::string> names{"velocity time [s]",
                                       "L2 error [m/s]",
                                       "relative L2 error",
                                       "maximal error [m/s]",
                                       "relative kinetic energy"};
        if (!pressure_expression.empty())
          {
            exact_pressure = parse_pressure();
            names.insert(names.end(),
                         {"pressure time [s]",
                          "pressure L2 error [Pa]",
                          "relative pressure L2 error",
                          "maximal pressure error [Pa]"});
          }
        return names;
      }


      std::vector<double>
      row(const FlowView<dim> &solution) override
      {
        const FlowFields<dim> flow = flow_of(solution);
        // Two points for the bilinear velocities of the older methods.
        const unsigned int n_points =
          solution.flow == nullptr ? 2 : flow.velocity_dofs.get_fe().degree + 2;
        exact_velocity->set_time(solution.velocity_time);
        const Sums          sums = compare_velocities(flow, n_points);
        std::vector<double> values{solution.velocity_time,
                                   std::sqrt(sums.error / sums.volume),
                                   std::sqrt(sums.error / sums.exact),
                                   sums.largest,
                                   sums.computed / sums.exact};
        if (exact_pressure)
          {
            exact_pressure->set_time(flow.pressure_time);
            const Sums p = compare_pressures(flow, n_points);
            values.insert(values.end(),
                          {flow.pressure_time,
                           std::sqrt(p.error / p.volume),
                           std::sqrt(p.error / p.exact),
                           p.largest});
          }
        return values;
      }


      /// Integrals of squares over the domain, and the largest error.
      struct Sums
      {
        double error = 0, exact = 0, computed = 0, volume = 0, largest = 0;

        void
        add_up(const MPI_Comm communicator)
        {
          for (double *sum : {&error, &exact, &computed, &volume})
            *sum = dealii::Utilities::MPI::sum(*sum, communicator);
          largest = dealii::Utilities::MPI::max(largest, communicator);
        }
      };


      Sums
      compare_velocities(const FlowFields<dim> &flow,
                         const unsigned int     n_points) const
      {
        const dealii::QGauss<dim>           quadrature(n_points);
        dealii::FEValues<dim>               values(flow.mapping,
                                     flow.velocity_dofs.get_fe(),
                                     quadrature,
                                     dealii::update_values |
                                       dealii::update_quadrature_points |
                                       dealii::update_JxW_values);
        std::vector<dealii::Tensor<1, dim>> velocities(quadrature.size());
        dealii::Vector<double>              wanted(dim);
        Sums                                sums;
        for (const auto &cell : flow.velocity_dofs.active_cell_iterators())
          {
            if (!cell->is_locally_owned())
              continue;
            values.reinit(cell);
            values[dealii::FEValuesExtractors::Vector(0)].get_function_values(
              flow.velocity, velocities);
            for (unsigned int q = 0; q < quadrature.size(); ++q)
              {
                exact_velocity->vector_value(values.quadrature_point(q),
                                             wanted);
                dealii::Tensor<1, dim> difference = velocities[q];
                for (unsigned int d = 0; d < dim; ++d)
                  difference[d] -= wanted[d];
                const double weight = values.JxW(q);
                sums.error += weight * difference.norm_square();
                sums.exact += weight * wanted.norm_sqr();
                sums.computed += weight * velocities[q].norm_square();
                sums.volume += weight;
                sums.largest = std::max(sums.largest, difference.norm());
              }
          }
        sums.add_up(flow.velocity_dofs.get_communicator());
        return sums;
      }


      /// Calls @p visit(computed, exact, weight) at all points.
      template <typename Visitor>
      void
      visit_pressures(const FlowFields<dim> &flow,
                      const unsigned int     n_points,
                      const Visitor         &visit) const
      {
        const dealii::QGauss<dim> quadrature(n_points);
        dealii::FEValues<dim>     values(flow.mapping,
                                     flow.pressure_dofs.get_fe(),
                                     quadrature,
                                     dealii::update_values |
                                       dealii::update_quadrature_points |
                                       dealii::update_JxW_values);
        std::vector<double>       pressures(quadrature.size());
        for (const auto &cell : flow.pressure_dofs.active_cell_iterators())
          if (cell->is_locally_owned())
            {
              values.reinit(cell);
              values.get_function_values(flow.pressure, pressures);
              for (unsigned int q = 0; q < quadrature.size(); ++q)
                visit(pressures[q],
                      exact_pressure->value(values.quadrature_point(q)),
                      values.JxW(q));
            }
      }


      Sums
      compare_pressures(const FlowFields<dim> &flow,
                        const unsigned int     n_points) const
      {
        const MPI_Comm communicator = flow.pressure_dofs.get_communicator();
        Sums           means;
        visit_pressures(flow,
                        n_points,
                        [&](const double computed,
                            const double wanted,
                            const double weight) {
                          means.computed += weight * computed;
                          means.exact += weight * wanted;
                          means.volume += weight;
                        });
        means.add_up(communicator);
        const double mean_computed = means.computed / means.volume;
        const double mean_exact    = means.exact / means.volume;
        Sums         sums;
        visit_pressures(
          flow,
          n_points,
          [&](const double computed, const double wanted, const double weight) {
            const double error =
              (computed - mean_computed) - (wanted - mean_exact);
            sums.error += weight * error * error;
            sums.exact += weight * std::pow(wanted - mean_exact, 2);
            sums.volume += weight;
            sums.largest = std::max(sums.largest, std::abs(error));
          });
        sums.add_up(communicator);
        return sums;
      }


      std::unique_ptr<dealii::FunctionParser<dim>>
      parse_velocity() const
      {
        return parse_expression<dim>(velocity_expression,
                                     dim,
                                     "Postprocess/velocity error/Velocity");
      }


      std::unique_ptr<dealii::FunctionParser<dim>>
      parse_pressure() const
      {
        return parse_expression<dim>(pressure_expression,
                                     1,
                                     "Postprocess/velocity error/Pressure");
      }


      std::string velocity_expression = dim == 2 ? "0; 0" : "0; 0; 0";
      std::string pressure_expression;
      std::unique_ptr<dealii::FunctionParser<dim>> exact_velocity;
      std::unique_ptr<dealii::FunctionParser<dim>> exact_pressure;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   VelocityError,
                   "velocity error",
                   "the difference from an exact velocity at the time to "
                   "which the computed one belongs, and the kinetic energy "
                   "relative to the exact one, on demand also the difference "
                   "from an exact pressure; writes velocity_error.csv.")
} // namespace Thalweg
