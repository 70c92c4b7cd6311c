#include <thalweg/fields/expression.h>
#include <thalweg/interface/cut_cell.h>
#include <thalweg/interface/simplex_cut.h>
#include <thalweg/postprocess/cell_access.h>
#include <thalweg/postprocess/csv_file.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/postprocess/schedule.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  namespace
  {
    /// Samples of a function on a lattice of n^dim sub-cells of a cell.
    template <int dim>
    class Lattice
    {
    public:
      Lattice(const typename CellGraph<dim>::Cell &cell,
              const dealii::Function<dim> &function,
              const unsigned int n)
        : n(n)
        , values(dealii::Utilities::pow(n + 1, dim))
      {
        for (unsigned int i = 0; i < values.size(); ++i)
        {
          dealii::Point<dim> xi;
          for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= n + 1)
            xi[d] = static_cast<double>(rest % (n + 1)) / n;
          values[i] = function.value(real_point<dim>(cell, xi));
        }
      }

      /// Whether the function keeps away from zero by more than it varies.
      bool
      is_far_from_zero() const
      {
        const auto [least, most]
          = std::minmax_element(values.begin(), values.end());
        return std::max(*least, -*most) > *most - *least;
      }

      bool
      starts_negative() const
      {
        return values[0] < 0.;
      }

      /// The part of the cell where the function is negative, from a linear
      /// cut of each sub-cell.
      double
      negative_fraction() const
      {
        double sum = 0;
        for (unsigned int s = 0; s < dealii::Utilities::pow(n, dim); ++s)
          sum += SimplexCut::negative_fraction<dim>(corners(s));
        return sum / dealii::Utilities::pow(n, dim);
      }

    private:
      std::array<double, (1 << dim)>
      corners(const unsigned int sub_cell) const
      {
        std::array<double, (1 << dim)> phi;
        for (unsigned int v = 0; v < phi.size(); ++v)
        {
          unsigned int index = 0, stride = 1;
          for (unsigned int d = 0, rest = sub_cell; d < dim; ++d, rest /= n)
          {
            index += stride * (rest % n + ((v >> d) & 1));
            stride *= n + 1;
          }
          phi[v] = values[index];
        }
        return phi;
      }

      const unsigned int n;
      std::vector<double> values;
    };


    /// The part of a cell where @p function is negative, to about 1e-4.
    template <int dim>
    double
    exact_fraction(const typename CellGraph<dim>::Cell &cell,
                   const dealii::Function<dim> &function)
    {
      const Lattice<dim> coarse(cell, function, 2);
      if (coarse.is_far_from_zero())
        return coarse.starts_negative() ? 1. : 0.;
      return Lattice<dim>(cell, function, 10).negative_fraction();
    }


    /// The difference between the fluids' exact places and the computed ones.
    template <int dim>
    class InterfaceError : public Postprocessor<dim>
    {
    public:
      InterfaceError()
        : schedule(1e30)
      {}


      void
      declare_parameters(const Section &section) override
      {
        section.add("Level set",
                    expression,
                    "m",
                    "The exact level set as a function of x, y, z and t, "
                    "negative in the first fluid. Its values should vary no "
                    "faster than a distance would.",
                    dealii::Patterns::Anything());
        schedule.declare_parameters(section, "rows");
      }


      void
      initialize(Context &context, const SolutionView<dim> &solution) override
      {
        AssertThrow(solution.fluids.size() == 2,
                    dealii::ExcMessage(
                      "The postprocessor 'interface error' needs two fluids, "
                      "but the section 'Fluids' has one. Remove it from "
                      "'Postprocess/Models' or name a second fluid."));
        exact = parse_expression<dim>(expression,
                                      1,
                                      "Postprocess/interface error/Level set");
        file.open(context,
                  "interface_error.csv",
                  {"time [s]",
                   "error [" + length_unit(dim) + "]",
                   "relative error",
                   "relative volume error"});
      }


      void
      execute(Context &context, const SolutionView<dim> &solution) override
      {
        if (!schedule.is_due(solution.time, solution.last_step))
          return;
        exact->set_time(solution.time);
        const CellGraph<dim> &graph = solution.mesh.graph();
        double error = 0, volume = 0, exact_volume = 0;
        for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        {
          const auto &cell = graph.cell(c);
          const double computed
            = negative_volume<dim>(cell, cell_level_set(solution, c));
          const double wanted = exact_fraction<dim>(cell, *exact) * cell.measure;
          error += std::abs(computed - wanted);
          volume += computed;
          exact_volume += wanted;
        }
        const auto &communicator
          = solution.mesh.triangulation().get_communicator();
        for (double *sum : {&error, &volume, &exact_volume})
          *sum = dealii::Utilities::MPI::sum(*sum, communicator);
        file.write_row(context,
                       {solution.time,
                        error,
                        error / exact_volume,
                        volume / exact_volume - 1.});
      }

    private:
      std::string expression = "1";
      std::unique_ptr<dealii::FunctionParser<dim>> exact;
      Schedule schedule;
      CsvFile file;
    };
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   InterfaceError,
                   "interface error",
                   "how much of the volume is on the wrong side of an exact "
                   "interface: the sum over the cells of the difference in "
                   "the first fluid's volume, also relative to its exact "
                   "volume; writes interface_error.csv at the start and the "
                   "end, or more often.")
} // namespace Thalweg
