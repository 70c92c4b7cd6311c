// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/plain_text.h>
#include <thalweg/coupling/coupling.h>
#include <thalweg/fluid/fluid_viscosities.h>
#include <thalweg/fluid/scalar_view.h>

#include <deal.II/base/function_parser.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace Thalweg
{
  namespace
  {
    /// A viscosity given at some values of a scalar, Pa s: between them its
    /// logarithm is linear, beyond them it stays.
    class ViscosityTable
    {
    public:
      ViscosityTable() = default;

      /// @param text "300: 1, 320: 0.1" @throws dealii::ExcMessage
      explicit ViscosityTable(const std::string &text)
      {
        for (const std::string &entry :
             dealii::Utilities::split_string_list(text, ','))
          {
            const auto words = dealii::Utilities::split_string_list(entry, ':');
            const auto value =
              words.size() == 2 ? finite_number(words[0]) : std::nullopt;
            const auto viscosity =
              words.size() == 2 ? finite_number(words[1]) : std::nullopt;
            AssertThrow(value && viscosity && *viscosity > 0. &&
                          (rows.empty() || *value > rows.back().first),
                        dealii::ExcMessage(
                          "'Table' has '" + excerpt(entry) +
                          "', but it is a list of values of the scalar, each "
                          "larger than the one before, and positive "
                          "viscosities: '300: 1, 320: 0.1'."));
            rows.emplace_back(*value, std::log(*viscosity));
          }
      }

      double
      operator()(const double value) const
      {
        const auto above = std::lower_bound(
          rows.begin(), rows.end(), value, [](const auto &row, const double x) {
            return row.first < x;
          });
        if (above == rows.begin())
          return std::exp(above->second);
        const auto below = above - 1;
        if (above == rows.end())
          return std::exp(below->second);
        const double part =
          (value - below->first) / (above->first - below->first);
        return std::exp(below->second + part * (above->second - below->second));
      }

    private:
      std::vector<std::pair<double, double>> rows; ///< value, logarithm
    };



    /// A scalar says how viscous a fluid is.
    template <int dim>
    class ViscosityLaw : public Coupling<dim>
    {
    public:
      void
      declare_parameters(const Section &section) override
      {
        using dealii::Patterns::Anything;
        section.add("Fluid",
                    fluid,
                    "",
                    "Whose viscosity it is; empty: that of the first fluid.",
                    Anything());
        section.add("Viscosity",
                    expression,
                    "Pa s",
                    "A function of the scalar s and its molten part f: "
                    "`1e-4*exp(2500/s)` (Arrhenius), `1e-3*exp(800/(s-200))` "
                    "(Vogel, Fulcher and Tammann), `if(f < 0.5, 1e3, 1e-2)`.",
                    Anything());
        section.add("Table",
                    table_text,
                    "Pa s",
                    "Instead, at some values of the scalar: `300: 1, 320: "
                    "0.1`; between them the logarithm is linear, beyond them "
                    "it stays.",
                    Anything());
      }

      void
      check(std::vector<std::string> &faults) const override
      {
        collect_fault(faults, [this]() {
          AssertThrow(expression.empty() != table_text.empty(),
                      dealii::ExcMessage("Give either 'Viscosity', as a "
                                         "function of s, or a 'Table'."));
          read();
        });
      }

      std::vector<std::vector<std::string>>
      needs() const override
      {
        return {{FluidViscosities<dim>::port}, {"scalars"}};
      }

      void
      create(const Host<dim>                &host_,
             const std::vector<std::string> &methods_) override
      {
        host    = std::make_unique<Host<dim>>(host_);
        methods = methods_;
        law     = read();
      }

      void
      attach() override
      {
        number = fluid.empty() ? 0 : viscosities().fluids().index(fluid);
      }

      void
      initialize() override
      {
        update();
      }

      /// In all cells, from the scalar in their middles. @throws StepFailure
      void
      update() override;

      void
      transfer(const double, const double) override
      {
        update();
      }

      std::vector<std::string>
      columns() const override
      {
        return {"least viscosity [Pa s]", "greatest viscosity [Pa s]"};
      }

      void
      record(const double) override
      {
        host->context.statistics.set("least viscosity [Pa s]", least);
        host->context.statistics.set("greatest viscosity [Pa s]", greatest);
      }

    private:
      /// Pa s, of a scalar and its molten part.
      using Law = std::function<double(const double, const double)>;

      std::string
      who() const
      {
        return "'Couplings/" + host->name + "'";
      }

      FluidViscosities<dim> &
      viscosities() const
      {
        return host->ports.template get<FluidViscosities<dim>>(
          methods[0], FluidViscosities<dim>::port, who());
      }

      /// @throws dealii::ExcMessage
      Law
      read() const
      {
        if (!table_text.empty())
          return [table = ViscosityTable(table_text)](const double s, double) {
            return table(s);
          };
        const auto function = std::make_shared<dealii::FunctionParser<2>>(1);
        try
          {
            function->initialize("s,f", expression, {});
            function->value(dealii::Point<2>(1., 1.));
          }
        catch (const dealii::ExceptionBase &)
          {
            AssertThrow(false,
                        dealii::ExcMessage(
                          "'Viscosity' is '" + excerpt(expression) +
                          "', which cannot be understood as a function of s "
                          "and f, like '1e-4*exp(2500/s)'."));
          }
        return [function](const double s, const double f) {
          return function->value(dealii::Point<2>(s, f));
        };
      }

      std::string                fluid, expression, table_text;
      Law                        law;
      unsigned int               number = 0;
      double                     least = 0., greatest = 0.; ///< Pa s
      std::unique_ptr<Host<dim>> host;
      std::vector<std::string>   methods;
    };



    template <int dim>
    void
    ViscosityLaw<dim>::update()
    {
      const auto &scalar =
        host->ports.template get<const ScalarView<dim>>(methods[1],
                                                        "scalars",
                                                        who());
      const NodeSpace<dim> &space = viscosities().space();
      constexpr double      part  = 1. / NodeSpace<dim>::n_vertices;
      const bool            melts = scalar.molten.size() > 0;
      std::vector<double>   of_cells(space.mesh().graph().n_owned_cells());
      least         = std::numeric_limits<double>::max();
      greatest      = 0.;
      bool is_right = true;
      for (unsigned int c = 0; c < of_cells.size(); ++c)
        {
          double s = 0., f = 0.;
          for (const unsigned int node : space.nodes(c))
            {
              s += part * scalar.field.local_element(node);
              if (melts)
                f += part * scalar.molten.local_element(node);
            }
          of_cells[c] = law(s, f);
          is_right =
            is_right && of_cells[c] >= 0. && std::isfinite(of_cells[c]);
          least    = std::min(least, of_cells[c]);
          greatest = std::max(greatest, of_cells[c]);
        }
      const MPI_Comm communicator = host->context.communicator;
      if (dealii::Utilities::MPI::min(static_cast<int>(is_right),
                                      communicator) == 0)
        throw StepFailure(who() + " says of some cells a viscosity that is "
                                  "negative or no finite number.");
      least    = dealii::Utilities::MPI::min(least, communicator);
      greatest = dealii::Utilities::MPI::max(greatest, communicator);
      viscosities().set(number, std::move(of_cells));
    }
  } // namespace

  THALWEG_REGISTER(Coupling,
                   ViscosityLaw,
                   "viscosity",
                   "a scalar, the second of the two methods, says how viscous "
                   "a fluid of the first one is in the next step")
} // namespace Thalweg
