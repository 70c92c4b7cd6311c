// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/expression.h>
#include <thalweg/fields/numerical_derivative.h>
#include <thalweg/fields/spline.h>
#include <thalweg/fluid/motion_table.h>
#include <thalweg/fluid/moving_frame.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    const std::string section_name = "Moving frame";


    /// The columns of a table that make the displacement's derivative of some
    /// order.
    template <int dim>
    std::vector<std::string>
    columns_of(const unsigned int order)
    {
      std::vector<std::string> names;
      for (unsigned int d = 0; d < dim; ++d)
        names.push_back(std::string(order == 0   ? ""
                                    : order == 1 ? "v"
                                                 : "a") +
                        "xyz"[d]);
      return names;
    }


    /// The components of an expression as functions of time.
    template <int dim>
    std::vector<FunctionOfTime>
    functions_of_time(const std::string &text,
                      const unsigned int n_components,
                      const std::string &where)
    {
      const std::shared_ptr<dealii::FunctionParser<dim>> parser =
        parse_expression<dim>(text, n_components, where);
      dealii::Point<dim> elsewhere;
      for (unsigned int d = 0; d < dim; ++d)
        elsewhere[d] = .3 + .17 * d;
      // What is no number somewhere is told as an acceleration, later.
      const auto value = [parser](const dealii::Point<dim> &place,
                                  const unsigned int        c) {
        try
          {
            return parser->value(place, c);
          }
        catch (const dealii::ExceptionBase &)
          {
            return std::numeric_limits<double>::quiet_NaN();
          }
      };
      std::vector<FunctionOfTime> functions;
      for (unsigned int c = 0; c < n_components; ++c)
        {
          for (const double t : {0., .37, 1.9})
            {
              parser->set_time(t);
              const double here  = value(dealii::Point<dim>(), c);
              const double there = value(elsewhere, c);
              AssertThrow(
                here == there || std::isnan(here) || std::isnan(there),
                dealii::ExcMessage("'" + where + " = " + text +
                                   "' depends on the place, but the tank "
                                   "moves as a whole: write a function of t "
                                   "alone."));
            }
          functions.push_back([parser, value, c](const double t) {
            parser->set_time(t);
            return value(dealii::Point<dim>(), c);
          });
        }
      return functions;
    }
  } // namespace



  template <int dim>
  void
  MovingFrame<dim>::declare_parameters(const Section &root)
  {
    const Section     section = root.enter(section_name);
    const auto        text    = dealii::Patterns::Anything();
    const std::string components =
      ", a function of t for each component, separated by semicolons, in the "
      "axes of space. ";
    section.add("Displacement",
                displacement,
                "m",
                "Where the tank's center is" + components +
                  "Mesh, fields, probes and forces are in axes that move and "
                  "turn with the tank.",
                text);
    section.add("Velocity",
                velocity,
                "m/s",
                "The velocity of the tank's center instead of its "
                "displacement" +
                  components + "Initial velocities are relative to the tank.",
                text);
    section.add("Acceleration",
                acceleration,
                "m/s^2",
                "The acceleration of the tank's center instead" + components,
                text);
    section.add("Angle",
                angle,
                "rad",
                "By how much the tank has turned about its center, counter-"
                "clockwise about the axis: a function of t. Gravity keeps its "
                "direction in space; `Gravity` is what it is at the angle 0.",
                text);
    section.add("Angular velocity",
                angular_velocity,
                "rad/s",
                "How fast the tank turns, instead of the angle, which is zero "
                "at t = 0 then: a function of t.",
                text);
    section.add("Center",
                center_components,
                "m",
                "The point of the tank about which it turns.",
                dealii::Patterns::List(dealii::Patterns::Double(), dim, dim));
    section.add("Axis",
                axis_components,
                "",
                "The direction about which the tank turns, of any length; in "
                "two dimensions it stays the third one.",
                dealii::Patterns::List(dealii::Patterns::Double(), 3, 3));
    section.add("Table",
                table,
                "",
                "A file with the motion against time. Its first line names "
                "the columns: t, then x, y, z [m] or vx, vy, vz [m/s] or ax, "
                "ay, az [m/s^2], and angle [rad] or omega [rad/s], as far as "
                "they are not zero. In between a cubic spline goes through "
                "the values.",
                text);
  }



  template <int dim>
  void
  MovingFrame<dim>::set_translation(const std::vector<Signal> &signals,
                                    const unsigned int         given_order,
                                    const std::string         &where)
  {
    AssertThrow(translation.empty(),
                dealii::ExcMessage("'" + translation_source + "' and '" +
                                   where +
                                   "' both say how the tank moves: keep one."));
    translation        = signals;
    translation_order  = given_order;
    translation_source = where;
  }



  template <int dim>
  void
  MovingFrame<dim>::set_rotation(const Signal      &signal,
                                 const unsigned int given_order,
                                 const std::string &where)
  {
    AssertThrow(!rotation,
                dealii::ExcMessage("'" + rotation_source + "' and '" + where +
                                   "' both say how the tank turns: keep one."));
    rotation        = signal;
    rotation_order  = given_order;
    rotation_source = where;
  }



  template <int dim>
  void
  MovingFrame<dim>::read_expressions()
  {
    const auto signals = [](const std::string &text,
                            const unsigned int n,
                            const std::string &where) {
      std::vector<Signal> result;
      for (const auto &f : functions_of_time<dim>(text, n, where))
        result.push_back([f](const double t, const unsigned int order) {
          return order == 0 ? f(t) : derivative(f, t, order);
        });
      return result;
    };
    unsigned int order = 0;
    for (const auto &[name, text] :
         {std::make_pair("Displacement", displacement),
          std::make_pair("Velocity", velocity),
          std::make_pair("Acceleration", acceleration)})
      {
        const std::string where = section_name + "/" + name;
        if (!text.empty())
          set_translation(signals(text, dim, where), order, where);
        ++order;
      }
    order = 0;
    for (const auto &[name, text] :
         {std::make_pair("Angle", angle),
          std::make_pair("Angular velocity", angular_velocity)})
      {
        const std::string where = section_name + "/" + name;
        if (!text.empty())
          set_rotation(signals(text, 1, where)[0], order, where);
        ++order;
      }
  }



  template <int dim>
  void
  MovingFrame<dim>::read_table(const double end)
  {
    if (table.empty())
      return;
    const std::vector<std::string> turns{"angle", "omega"};
    std::vector<std::string>       allowed;
    for (unsigned int order = 0; order < 3; ++order)
      for (const std::string &name : columns_of<dim>(order))
        allowed.push_back(name);
    allowed.insert(allowed.end(), turns.begin(), turns.end());
    const auto columns =
      read_motion_table(table, allowed, end, section_name + "/Table");
    const auto where = [&](const std::string &name) {
      return section_name + "/Table (" + name + ")";
    };
    const auto signal = [&](const std::string &name) -> Signal {
      if (columns.count(name) == 0)
        return [](const double, const unsigned int) { return 0.; };
      const Spline spline(columns.at("t"), columns.at(name));
      return [spline](const double t, const unsigned int order) {
        return spline.evaluate(t, order);
      };
    };
    for (unsigned int order = 0; order < 3; ++order)
      {
        std::vector<Signal> signals;
        std::string         found;
        for (const std::string &name : columns_of<dim>(order))
          {
            signals.push_back(signal(name));
            if (columns.count(name) > 0)
              found = name;
          }
        if (!found.empty())
          set_translation(signals, order, where(found));
      }
    for (unsigned int order = 0; order < 2; ++order)
      if (columns.count(turns[order]) > 0)
        set_rotation(signal(turns[order]), order, where(turns[order]));
  }



  template <int dim>
  void
  MovingFrame<dim>::initialize(const double end)
  {
    translation.clear();
    rotation = nullptr;
    dealii::Tensor<1, 3> axis;
    for (unsigned int d = 0; d < 3; ++d)
      axis[d] = axis_components[d];
    AssertThrow(axis.norm() > 0.,
                dealii::ExcMessage("'Moving frame/Axis' has no length; write "
                                   "the direction about which the tank turns, "
                                   "as in '0, 0, 1'."));
    axis /= axis.norm();
    AssertThrow(dim == 3 || axis[2] == 1.,
                dealii::ExcMessage("'Moving frame/Axis' is for three "
                                   "dimensions; in two the tank turns in its "
                                   "plane: leave it out."));
    for (unsigned int d = 0; d < dim; ++d)
      pivot[d] = center_components[d];
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        if (i != j)
          axis_cross[i][j] = (j == (i + 1) % 3 ? -1. : 1.) * axis[3 - i - j];
    read_expressions();
    read_table(end);
    at(0.);
    at(end);
  }



  template <int dim>
  typename MovingFrame<dim>::State
  MovingFrame<dim>::at(const double t) const
  {
    const auto finite = [t](const double value, const std::string &source) {
      std::ostringstream message;
      message << "'" << source << "' gives no acceleration at t = " << t
              << " s: it is not smooth or not defined there (functions of t "
                 "are differentiated by differences, which need times before "
                 "0, too). Change it, or give the velocity or the "
                 "acceleration itself.";
      AssertThrow(std::isfinite(value), dealii::ExcMessage(message.str()));
      return value;
    };
    State state;
    for (unsigned int d = 0; d < translation.size(); ++d)
      state.acceleration[d] =
        finite(translation[d](t, 2 - translation_order), translation_source);
    state.orientation = dealii::unit_symmetric_tensor<dim>();
    if (!is_rotating())
      return state;
    const Signal &turn = rotation;
    state.angle =
      finite(rotation_order == 0
               ? turn(t, 0)
               : integral([&](const double s) { return turn(s, 0); }, 0., t),
             rotation_source);
    state.spin =
      finite(turn(t, 1 - rotation_order), rotation_source) * axis_cross;
    state.spin_rate =
      finite(turn(t, 2 - rotation_order), rotation_source) * axis_cross;
    // Rodrigues' formula.
    state.orientation +=
      std::sin(state.angle) * axis_cross +
      (1. - std::cos(state.angle)) * (axis_cross * axis_cross);
    return state;
  }



  template <int dim>
  dealii::Tensor<1, dim>
  MovingFrame<dim>::velocity_of_space(const dealii::Point<dim> &x) const
  {
    const State            state = at(0.);
    dealii::Tensor<1, dim> v;
    if (translation_order < 2)
      for (unsigned int d = 0; d < translation.size(); ++d)
        v[d] = 0. - translation[d](0., 1 - translation_order);
    return dealii::transpose(state.orientation) * v - state.spin * (x - pivot);
  }



  template <int dim>
  bool
  MovingFrame<dim>::keeps_direction(const unsigned int direction) const
  {
    if (!is_rotating())
      return true;
    for (unsigned int d = 0; d < dim; ++d)
      if (std::abs(axis_cross[d][direction]) > 1e-12)
        return false;
    return true;
  }



  template <int dim>
  std::string
  MovingFrame<dim>::description() const
  {
    if (!is_active())
      return "";
    std::ostringstream text;
    text << "The frame moves with the tank ('Moving frame'): places, "
            "velocities, forces and gravity are in the axes of the tank.";
    const auto v = velocity_of_space(pivot);
    if (v.norm() > 0. || at(0.).spin.norm() > 0.)
      text << " At t = 0 the tank is in motion: fluid at rest in space has "
           << "the velocity " << v << " m/s at its center"
           << (is_rotating() ? ", and turns against it" : "") << ".";
    return text.str();
  }



  THALWEG_INSTANTIATE(MovingFrame)
} // namespace Thalweg
