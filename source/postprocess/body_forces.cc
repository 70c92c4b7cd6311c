// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/postprocess/averaging_window.h>
#include <thalweg/postprocess/csv_file.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/postprocess/schedule.h>
#include <thalweg/postprocess/surface.h>
#include <thalweg/postprocess/time_series.h>

#include <cmath>
#include <limits>

namespace Thalweg
{
  namespace
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();


    template <int dim>
    Load<dim>
    unknown_load()
    {
      Load<dim> load;
      for (unsigned int d = 0; d < dim; ++d)
        load.force[d] = nan;
      for (unsigned int d = 0; d < Load<dim>::n_moments; ++d)
        load.moment[d] = nan;
      return load;
    }



    /// Drag, lift and moment of a body, and how they vary.
    template <int dim>
    class ForcesOnBody : public FlowPostprocessor<dim>
    {
    public:
      void
      declare_for_flow(const Section &section) override;

      void
      check_for_flow(const FlowOutline<dim> &outline) const override;

      void
      initialize_for_flow(Context             &context,
                          const FlowView<dim> &solution) override;

      void
      execute_for_flow(Context             &context,
                       const FlowView<dim> &solution) override;

      void
      keep(const State<dim> &state) override;

    private:
      /// Drag, lift, moment(s).
      static constexpr unsigned int n_numbers = 2 + Load<dim>::n_moments;
      using Numbers                           = std::array<double, n_numbers>;

      Numbers
      dimensional(const Load<dim> &load) const;

      /// What a number is divided by to become a coefficient.
      double
      divisor(const unsigned int number, const double fluid_density) const;

      void
      declare_directions(const Section &section);

      /// Frequencies in Hz.
      struct Oscillation
      {
        double periods      = 0.;
        double by_crossings = nan;
        double by_spectrum  = nan;
      };

      Oscillation
      find_oscillation(Context &context) const;

      void
      write_summary(Context &context) const;

      /// "c_D", "c_L", "c_M" or "c_Mx" ...
      static std::string
      coefficient_name(const unsigned int number);

      std::vector<std::string> names;
      double                   velocity = 1., length = 1., area = 0.;
      double                   reference_density = 0.;
      dealii::Point<dim>       center;
      dealii::Tensor<1, dim>   drag_direction =
        dealii::Point<dim>::unit_vector(0);
      dealii::Tensor<1, dim> lift_direction =
        dealii::Point<dim>::unit_vector(1);
      AveragingWindow window;
      Schedule        schedule;

      std::set<dealii::types::boundary_id> ids;
      bool                                 by_residual = false;
      CsvFile                              file;
      /// The coefficients in the window, by direct integration and, where it
      /// is available, by the residual.
      std::vector<double>              times;
      std::vector<std::vector<double>> series;
    };


    template <int dim>
    void
    ForcesOnBody<dim>::declare_for_flow(const Section &section)
    {
      section.add("Boundaries",
                  names,
                  "",
                  "Names of the boundaries that form the body, separated by "
                  "commas.");
      section.add("Reference velocity",
                  velocity,
                  "m/s",
                  "U in the coefficients, for example c_D = D / (1/2 rho U^2 "
                  "A).",
                  dealii::Patterns::Double(std::numeric_limits<double>::min()));
      section.add("Reference length",
                  length,
                  "m",
                  "The body's diameter or chord: A in the coefficients in 2D, "
                  "the lever in those of moments, and L in the Strouhal number "
                  "f L / U.",
                  dealii::Patterns::Double(std::numeric_limits<double>::min()));
      section.add("Reference area",
                  area,
                  "m^2",
                  "A in the coefficients in 3D; 0: the square of the length. "
                  "Not used in 2D.",
                  dealii::Patterns::Double(0.));
      section.add("Reference density",
                  reference_density,
                  "kg/m^3",
                  "rho in the coefficients; 0: the fluid's.",
                  dealii::Patterns::Double(0.));
      declare_directions(section);
      window.declare_parameters(section);
      schedule.declare_parameters(section, "rows");
    }


    template <int dim>
    void
    ForcesOnBody<dim>::declare_directions(const Section &section)
    {
      section.add("Moment centre",
                  center,
                  "m",
                  "The point about which moments are taken.");
      section.add("Drag direction",
                  drag_direction,
                  "",
                  "The direction in which drag is positive, of any length; for "
                  "an angle of attack that of the oncoming flow.");
      section.add("Lift direction",
                  lift_direction,
                  "",
                  "The direction in which lift is positive, normal to that of "
                  "drag.");
    }


    template <int dim>
    void
    ForcesOnBody<dim>::check_for_flow(const FlowOutline<dim> &outline) const
    {
      AssertThrow(!names.empty(),
                  dealii::ExcMessage("'body forces' has no 'Boundaries'; name "
                                     "those that form the body."));
      for (const std::string &name : names)
        outline.mesh.boundary_id(name);
      AssertThrow(outline.fluids.size() == 1,
                  dealii::ExcMessage("'body forces' needs a single fluid; with "
                                     "two use 'boundary forces'."));
      AssertThrow(drag_direction.norm() > 0. && lift_direction.norm() > 0. &&
                    std::abs(drag_direction * lift_direction) <=
                      1e-3 * drag_direction.norm() * lift_direction.norm(),
                  dealii::ExcMessage("'Drag direction' and 'Lift direction' of "
                                     "'body forces' must not be zero and must "
                                     "be normal to each other; write, for "
                                     "example, '0.8, 0.6' and '-0.6, 0.8'."));
      window.check("body forces");
    }


    template <int dim>
    std::string
    ForcesOnBody<dim>::coefficient_name(const unsigned int number)
    {
      if (number < 2)
        return number == 0 ? "c_D" : "c_L";
      return dim == 2 ? "c_M" : std::string("c_M") + "xyz"[number - 2];
    }


    template <int dim>
    void
    ForcesOnBody<dim>::initialize_for_flow(Context             &context,
                                           const FlowView<dim> &solution)
    {
      for (const std::string &name : names)
        ids.insert(solution.mesh.boundary_id(name));
      drag_direction /= drag_direction.norm();
      lift_direction /= lift_direction.norm();
      by_residual = solution.flow != nullptr;
      series.resize((by_residual ? 2 : 1) * n_numbers);

      std::vector<std::string> parts{"direct pressure",
                                     "direct viscous",
                                     "direct"};
      if (by_residual)
        parts.emplace_back("residual");
      std::vector<std::string> columns{"time [s]"};
      for (const std::string &part : parts)
        {
          for (const std::string force : {" drag", " lift"})
            columns.push_back(part + force + (dim == 2 ? " [N/m]" : " [N]"));
          for (const char axis : std::string(dim == 2 ? "z" : "xyz"))
            columns.push_back(part + " moment " + axis +
                              (dim == 2 ? " [N]" : " [N m]"));
          for (unsigned int n = 0; n < n_numbers; ++n)
            columns.push_back(part + " " + coefficient_name(n));
        }
      file.open(context, "body_forces.csv", columns);
    }


    template <int dim>
    typename ForcesOnBody<dim>::Numbers
    ForcesOnBody<dim>::dimensional(const Load<dim> &load) const
    {
      Numbers numbers;
      numbers[0] = load.force * drag_direction;
      numbers[1] = load.force * lift_direction;
      for (unsigned int n = 2; n < n_numbers; ++n)
        numbers[n] = load.moment[n - 2];
      return numbers;
    }


    template <int dim>
    double
    ForcesOnBody<dim>::divisor(const unsigned int number,
                               const double       fluid_density) const
    {
      const double density =
        reference_density > 0. ? reference_density : fluid_density;
      const double size =
        dim == 2 ? length : (area > 0. ? area : length * length);
      return .5 * density * velocity * velocity * size *
             (number < 2 ? 1. : length);
    }


    template <int dim>
    void
    ForcesOnBody<dim>::execute_for_flow(Context             &context,
                                        const FlowView<dim> &solution)
    {
      const FlowFields<dim>  flow   = flow_of(solution);
      const StressLoads<dim> stress = integrate_stresses(flow, ids, center);
      Load<dim>              total  = stress.pressure;
      total += stress.viscous;
      std::vector<Load<dim>> loads{stress.pressure, stress.viscous, total};
      if (by_residual)
        loads.push_back(has_reaction(flow) ? sum_reactions(flow, ids, center)
                                           : unknown_load<dim>());

      // There is no residual before the first step.
      const bool record = solution.step > 0 && window.contains(solution.time);
      if (record)
        times.push_back(solution.time);
      std::vector<double> row{solution.time};
      for (unsigned int part = 0; part < loads.size(); ++part)
        {
          const Numbers numbers = dimensional(loads[part]);
          row.insert(row.end(), numbers.begin(), numbers.end());
          for (unsigned int n = 0; n < n_numbers; ++n)
            {
              const double coefficient = numbers[n] / divisor(n, flow.density);
              row.push_back(coefficient);
              if (record && part >= 2)
                series[(part - 2) * n_numbers + n].push_back(coefficient);
            }
        }
      if (schedule.is_due(solution.time, solution.last_step))
        file.write_row(context, row);
      if (solution.last_step)
        write_summary(context);
    }


    template <int dim>
    void
    ForcesOnBody<dim>::keep(const State<dim> &state)
    {
      const Archive &archive = state.values();
      schedule.keep(archive);
      file.keep(archive, schedule.was_due_for_the_end());
      archive.value("times", times);
      for (unsigned int s = 0; s < series.size(); ++s)
        archive.value("series " + std::to_string(s), series[s]);
    }


    template <int dim>
    typename ForcesOnBody<dim>::Oscillation
    ForcesOnBody<dim>::find_oscillation(Context &context) const
    {
      // Those of the more accurate way stand last.
      const auto &drag = series[series.size() - n_numbers];
      const auto &lift = series[series.size() - n_numbers + 1];
      // What solvers leave in a steady flow is no oscillation.
      const auto summary = TimeSeries::summarize(times, lift);
      const bool is_steady =
        !(summary.rms >
          1e-6 * std::max(std::abs(summary.mean),
                          std::abs(TimeSeries::summarize(times, drag).mean)));
      const auto  crossings = is_steady
                                ? std::vector<double>()
                                : TimeSeries::upward_crossings(times, lift);
      Oscillation oscillation;
      if (!crossings.empty())
        oscillation.periods = crossings.size() - 1.;
      if (oscillation.periods >= 2)
        {
          oscillation.by_crossings = TimeSeries::crossing_frequency(crossings);
          oscillation.by_spectrum  = TimeSeries::spectral_peak(times, lift);
        }
      else
        context.log.line("body forces: the lift has fewer than two periods "
                         "between 'Average from' and 'Average until'; no "
                         "Strouhal number is written.");
      return oscillation;
    }


    template <int dim>
    void
    ForcesOnBody<dim>::write_summary(Context &context) const
    {
      std::vector<std::string> columns{"from [s]", "until [s]", "records"};
      std::vector<double>      row{times.empty() ? nan : times.front(),
                              times.empty() ? nan : times.back(),
                              double(times.size())};
      for (unsigned int s = 0; s < series.size(); ++s)
        {
          const std::string name = (s < n_numbers ? "direct " : "residual ") +
                                   coefficient_name(s % n_numbers);
          const auto summary = TimeSeries::summarize(times, series[s]);
          for (const char *const kind :
               {" mean", " minimum", " maximum", " rms"})
            columns.push_back(name + kind);
          row.insert(
            row.end(),
            {summary.mean, summary.minimum, summary.maximum, summary.rms});
        }

      const Oscillation oscillation = find_oscillation(context);
      columns.insert(columns.end(),
                     {"periods",
                      "Strouhal number by zero crossings",
                      "Strouhal number by spectrum"});
      row.insert(row.end(),
                 {oscillation.periods,
                  oscillation.by_crossings * length / velocity,
                  oscillation.by_spectrum * length / velocity});
      CsvFile summary_file;
      summary_file.open(context, "body_forces_summary.csv", columns);
      summary_file.write_row(context, row);
    }
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   ForcesOnBody,
                   "body forces",
                   "drag, lift and moment of a body in a single fluid with "
                   "their coefficients, by integrating stresses and, with "
                   "methods that provide it, by the residual of the momentum "
                   "equation; writes body_forces.csv and, at the end, means, "
                   "extremes and Strouhal numbers in body_forces_summary.csv.")
} // namespace Thalweg
