#include <thalweg/fields/expression.h>
#include <thalweg/fields/q1_cell.h>
#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/scheduled_output.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// The difference between an exact velocity and the computed one.
    template <int dim>
    class VelocityError : public TableOutput<dim>
    {
    public:
      VelocityError()
        : TableOutput<dim>("velocity_error.csv")
      {}


      void
      check(const RunOutline<dim> &) const override
      {
        parse();
      }

    private:
      void
      declare_own_parameters(const Section &section) override
      {
        section.add("Velocity",
                    expression,
                    "m/s",
                    "The exact velocity as a function of x, y, z and t, the "
                    "components separated by semicolons.",
                    dealii::Patterns::Anything());
      }


      std::vector<std::string>
      columns(const SolutionView<dim> &) override
      {
        exact = parse();
        return {"velocity time [s]",
                "L2 error [m/s]",
                "relative L2 error",
                "maximal error [m/s]",
                "relative kinetic energy"};
      }


      std::vector<double>
      row(const SolutionView<dim> &solution) override
      {
        exact->set_time(solution.velocity_time);
        const MPI_Comm communicator =
          solution.mesh.triangulation().get_communicator();
        Sums sums;
        for (unsigned int c = 0; c < solution.mesh.graph().n_owned_cells(); ++c)
          add_cell(solution, c, sums);
        for (double *sum :
             {&sums.error, &sums.exact, &sums.computed, &sums.volume})
          *sum = dealii::Utilities::MPI::sum(*sum, communicator);
        sums.largest = dealii::Utilities::MPI::max(sums.largest, communicator);
        return {solution.velocity_time,
                std::sqrt(sums.error / sums.volume),
                std::sqrt(sums.error / sums.exact),
                sums.largest,
                sums.computed / sums.exact};
      }


      /// Integrals of squares over the domain, and the largest error.
      struct Sums
      {
        double error = 0, exact = 0, computed = 0, volume = 0, largest = 0;
      };


      void
      add_cell(const SolutionView<dim> &solution,
               const unsigned int       c,
               Sums                    &sums) const
      {
        static const Q1::Gauss<dim> gauss;
        const auto                 &cell  = solution.mesh.graph().cell(c);
        const auto                 &nodes = solution.space.nodes(c);
        dealii::Vector<double>      wanted(dim);
        for (unsigned int q = 0; q < gauss.n_points; ++q)
          {
            const auto             point = gauss.evaluate(cell, q);
            dealii::Tensor<1, dim> velocity, difference;
            exact->vector_value(Q1::position<dim>(cell.vertices,
                                                  gauss.points[q]),
                                wanted);
            for (unsigned int d = 0; d < dim; ++d)
              {
                for (unsigned int v = 0; v < nodes.size(); ++v)
                  velocity[d] +=
                    point.values[v] *
                    solution.velocity.local_element(dim * nodes[v] + d);
                difference[d] = velocity[d] - wanted[d];
              }
            const double weight = gauss.weight * point.determinant;
            sums.error += weight * difference.norm_square();
            sums.exact += weight * wanted.norm_sqr();
            sums.computed += weight * velocity.norm_square();
            sums.volume += weight;
            sums.largest = std::max(sums.largest, difference.norm());
          }
      }


      std::unique_ptr<dealii::FunctionParser<dim>>
      parse() const
      {
        return parse_expression<dim>(expression,
                                     dim,
                                     "Postprocess/velocity error/Velocity");
      }


      std::string expression = dim == 2 ? "0; 0" : "0; 0; 0";
      std::unique_ptr<dealii::FunctionParser<dim>> exact;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   VelocityError,
                   "velocity error",
                   "the difference from an exact velocity at the time to "
                   "which the computed one belongs, and the kinetic energy "
                   "relative to the exact one; writes velocity_error.csv.")
} // namespace Thalweg
