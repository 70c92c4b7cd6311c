// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/send_plain.h>
#include <thalweg/postprocess/averaging_window.h>
#include <thalweg/postprocess/csv_file.h>
#include <thalweg/postprocess/flow_means.h>
#include <thalweg/postprocess/postprocessor.h>
#include <thalweg/postprocess/schedule.h>
#include <thalweg/postprocess/snapshot_table.h>
#include <thalweg/postprocess/surface_samples.h>

#include <cmath>
#include <limits>

namespace Thalweg
{
  namespace
  {
    /// The rows of the table of places without wall shear.
    std::vector<std::vector<double>>
    zero_rows(const std::vector<LineSample> &line, const double time)
    {
      std::vector<std::vector<double>> rows;
      for (const bool mean : {false, true})
        for (const ZeroShear &zero : find_zero_shear(line, mean))
          rows.push_back({time,
                          double(zero.boundary),
                          double(zero.chain),
                          mean ? 1. : 0.,
                          zero.arc_length,
                          zero.position[0],
                          zero.position[1],
                          zero.sign_behind});
      return rows;
    }



    /// c_p and c_f along boundaries, at times and on average.
    template <int dim>
    class SurfaceCoefficients : public FlowPostprocessor<dim>
    {
    public:
      SurfaceCoefficients()
        : schedule(1e30)
        , means(/* with_stresses */ false)
      {}

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
      mesh_changed_for_flow(const FlowView<dim> &solution) override;

      void
      keep(const State<dim> &state) override;

    private:
      using Faces = std::vector<FaceSamples<dim>>;
      using Row   = std::vector<double>;

      /// The flow and its means at the owned faces.
      Faces
      sample(const FlowFields<dim> &flow) const;

      /// Writes the tables out of the root's @p faces. Collective.
      void
      write(const Context &context,
            const Faces   &faces,
            const double   time,
            const double   density);

      /// Appends position, normal and both sets of coefficients.
      void
      append(const SurfaceSample<dim>  &sample,
             const std::vector<double> &shear,
             const std::vector<double> &mean_shear,
             const double               density,
             Row                       &row) const;

      std::vector<std::string> names;
      double                   velocity = 1., reference_density = 0.;
      double                   reference_pressure = 0.;
      AveragingWindow          window;
      Schedule                 schedule;

      std::map<dealii::types::boundary_id, unsigned int> numbers;
      SnapshotTable                                      table;
      CsvFile                                            zero_file;

      /// Of the flow, since samples are linear in it.
      FlowMeans<dim> means;
    };


    template <int dim>
    void
    SurfaceCoefficients<dim>::declare_for_flow(const Section &section)
    {
      section.add("Boundaries",
                  names,
                  "",
                  "Names of boundaries, separated by commas.");
      section.add("Reference velocity",
                  velocity,
                  "m/s",
                  "U in c_p = (p - p_ref) / (1/2 rho U^2) and c_f.",
                  dealii::Patterns::Double(std::numeric_limits<double>::min()));
      section.add("Reference density",
                  reference_density,
                  "kg/m^3",
                  "rho in the coefficients; 0: the fluid's.",
                  dealii::Patterns::Double(0.));
      section.add("Reference pressure",
                  reference_pressure,
                  "Pa",
                  "p_ref in c_p, usually that of the oncoming flow.");
      window.declare_parameters(section);
      schedule.declare_parameters(section, "tables");
    }


    template <int dim>
    void
    SurfaceCoefficients<dim>::check_for_flow(
      const FlowOutline<dim> &outline) const
    {
      AssertThrow(!names.empty(),
                  dealii::ExcMessage("'surface coefficients' has no "
                                     "'Boundaries'; name some or take it off "
                                     "the list."));
      for (const std::string &name : names)
        outline.mesh.boundary_id(name);
      AssertThrow(outline.fluids.size() == 1,
                  dealii::ExcMessage("'surface coefficients' needs a single "
                                     "fluid; take it off the list of "
                                     "'Postprocess/Models'."));
      window.check("surface coefficients");
    }


    template <int dim>
    void
    SurfaceCoefficients<dim>::initialize_for_flow(Context             &context,
                                                  const FlowView<dim> &solution)
    {
      for (unsigned int n = 0; n < names.size(); ++n)
        numbers[solution.mesh.boundary_id(names[n])] = n;
      std::vector<std::string> columns{"time [s]", "boundary"};
      if (dim == 2)
        columns.insert(columns.end(), {"chain", "arc length [m]"});
      for (const std::string what : {"", "normal "})
        for (unsigned int d = 0; d < dim; ++d)
          columns.push_back(what + "xyz"[d] + (what.empty() ? " [m]" : ""));
      for (const std::string mean : {"", "mean "})
        {
          columns.insert(columns.end(), {mean + "pressure [Pa]", mean + "c_p"});
          if (dim == 2)
            columns.push_back(mean + "wall shear stress [Pa]");
          else
            for (const char axis : std::string("xyz"))
              columns.push_back(mean + "wall shear stress " + axis + " [Pa]");
          columns.push_back(mean + "c_f");
        }
      mesh_changed_for_flow(solution);
      table.open(context, "surface_coefficients", columns);
      if (dim == 2)
        zero_file.open(context,
                       "surface_coefficients_zero_shear.csv",
                       {"time [s]",
                        "boundary",
                        "chain",
                        "averaged",
                        "arc length [m]",
                        "x [m]",
                        "y [m]",
                        "sign behind"});
    }


    template <int dim>
    void
    SurfaceCoefficients<dim>::execute_for_flow(Context             &context,
                                               const FlowView<dim> &solution)
    {
      const bool   is_due = schedule.is_due(solution.time, solution.last_step);
      const double weight = window.overlap(solution.time, solution.time_step);
      if (!is_due && weight == 0.)
        return;
      const FlowFields<dim> flow = flow_of(solution);
      if (weight > 0.)
        means.add(flow, weight);
      if (!is_due)
        return;
      Faces all;
      for (const auto &[rank, list] :
           send_plain<FaceSamples<dim>>(context.communicator,
                                        {{0, sample(flow)}}))
        all.insert(all.end(), list.begin(), list.end());
      write(context, all, solution.time, flow.density);
    }


    template <int dim>
    void
    SurfaceCoefficients<dim>::mesh_changed_for_flow(
      const FlowView<dim> &solution)
    {
      means.initialize(solution.mesh, flow_of(solution));
    }


    template <int dim>
    void
    SurfaceCoefficients<dim>::keep(const State<dim> &state)
    {
      const Archive &archive      = state.values();
      const bool     without_last = schedule.was_due_for_the_end();
      schedule.keep(archive);
      table.keep(archive.enter("table"), without_last);
      if (dim == 2)
        zero_file.keep(archive.enter("zeros"), without_last);
      means.keep(state);
    }


    template <int dim>
    typename SurfaceCoefficients<dim>::Faces
    SurfaceCoefficients<dim>::sample(const FlowFields<dim> &flow) const
    {
      Faces        faces        = sample_surface(flow, numbers);
      const Faces  mean_samples = sample_surface(means.flow(flow), numbers);
      const double none         = means.averaged_time() > 0.
                                    ? 0.
                                    : std::numeric_limits<double>::quiet_NaN();
      for (std::size_t f = 0; f < faces.size(); ++f)
        for (unsigned int q = 0; q < faces[f].n_samples; ++q)
          {
            const SurfaceSample<dim> &mean = mean_samples[f].samples[q];
            SurfaceSample<dim>       &now  = faces[f].samples[q];
            now.mean_pressure              = mean.pressure + none;
            for (unsigned int d = 0; d < dim; ++d)
              now.mean_shear[d] = mean.shear[d] + none;
          }
      return faces;
    }


    template <int dim>
    void
    SurfaceCoefficients<dim>::append(const SurfaceSample<dim>  &sample,
                                     const std::vector<double> &shear,
                                     const std::vector<double> &mean_shear,
                                     const double               density,
                                     Row                       &row) const
    {
      row.insert(row.end(), sample.position.begin(), sample.position.end());
      row.insert(row.end(), sample.normal.begin(), sample.normal.end());
      const double dynamic_pressure =
        .5 * (reference_density > 0. ? reference_density : density) * velocity *
        velocity;
      for (const bool mean : {false, true})
        {
          const double pressure = mean ? sample.mean_pressure : sample.pressure;
          const auto  &stress   = mean ? mean_shear : shear;
          row.insert(row.end(),
                     {pressure,
                      (pressure - reference_pressure) / dynamic_pressure});
          double square = 0.;
          for (const double component : stress)
            {
              row.push_back(component);
              square += component * component;
            }
          row.push_back((dim == 2 ? stress[0] : std::sqrt(square)) /
                        dynamic_pressure);
        }
    }


    template <int dim>
    void
    SurfaceCoefficients<dim>::write(const Context &context,
                                    const Faces   &faces,
                                    const double   time,
                                    const double   density)
    {
      std::vector<Row> rows;
      if constexpr (dim == 2)
        {
          const auto line = order_along_lines(faces);
          for (const auto &[place, sample] : line)
            {
              rows.push_back({time,
                              double(place.boundary),
                              double(place.chain),
                              place.arc_length});
              append(sample,
                     {place.shear},
                     {place.mean_shear},
                     density,
                     rows.back());
            }
          zero_file.write_rows(context, zero_rows(line, time));
        }
      else
        for (const auto &face : faces)
          for (unsigned int q = 0; q < face.n_samples; ++q)
            {
              const auto &sample = face.samples[q];
              rows.push_back({time, double(face.boundary)});
              append(sample,
                     {sample.shear.begin(), sample.shear.end()},
                     {sample.mean_shear.begin(), sample.mean_shear.end()},
                     density,
                     rows.back());
            }
      table.write(context, rows);
    }
  } // namespace

  THALWEG_REGISTER(Postprocessor,
                   SurfaceCoefficients,
                   "surface coefficients",
                   "pressure, wall shear stress and their coefficients along "
                   "boundaries, also averaged over time, in the order along "
                   "the surface in 2D; writes surface_coefficients.csv and, "
                   "in 2D, where the wall shear changes its sign, "
                   "surface_coefficients_zero_shear.csv.")
} // namespace Thalweg
