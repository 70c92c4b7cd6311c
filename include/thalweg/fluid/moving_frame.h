// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_moving_frame_h
#define thalweg_fluid_moving_frame_h

#include <thalweg/core/section.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <functional>
#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief The motion of a tank: the parameters of the section "Moving
   * frame", and what follows from them.
   *
   * Mesh, fields and particles are in axes that move with the tank. A point x
   * of the tank is at c + d(t) + R(t) (x - c) in space, where c is the center
   * in the tank, d the displacement in the axes of space, and R a turn by the
   * angle about an axis that is the same in both.
   */
  template <int dim>
  class MovingFrame
  {
  public:
    /// Declares the section below @p root.
    void
    declare_parameters(const Section &root);

    /// Reads what is given. @param end the run's, s
    /// @throws dealii::ExcMessage
    void
    initialize(const double end);

    /// Whether the tank moves at all.
    bool
    is_active() const
    {
      return !translation.empty() || is_rotating();
    }

    bool
    is_rotating() const
    {
      return static_cast<bool>(rotation);
    }

    /// Whether turning makes no difference along the coordinate
    /// @p direction.
    bool
    keeps_direction(const unsigned int direction) const;

    /// What the log says of the frame; empty if the tank does not move.
    std::string
    description() const;

    /// The motion at some time.
    struct State
    {
      dealii::Tensor<1, dim> acceleration; ///< d'', axes of space, m/s^2
      double                 angle = 0.;   ///< rad
      dealii::Tensor<2, dim> orientation;  ///< R
      /// Omega x r = spin r, 1/s, and its derivative in time.
      dealii::Tensor<2, dim> spin, spin_rate;
    };

    /// @throws dealii::ExcMessage if what was given has no such derivative
    State
    at(const double t) const;

    /// What fluid at @p x of the tank has to have, seen in the tank, to be at
    /// rest in space at t = 0: zero where an acceleration is given. m/s
    dealii::Tensor<1, dim>
    velocity_of_space(const dealii::Point<dim> &x) const;

    /// The center, in the tank.
    const dealii::Point<dim> &
    center() const
    {
      return pivot;
    }

  private:
    /// A component of the motion: its value (0) or derivatives at a time.
    using Signal = std::function<double(const double, const unsigned int)>;

    void
    read_expressions();

    void
    read_table(const double end);

    /// Takes @p signals that were given as the @p given_order -th derivative
    /// of the displacement or the angle. @throws if there are others already
    void
    set_translation(const std::vector<Signal> &signals,
                    const unsigned int         given_order,
                    const std::string         &where);
    void
    set_rotation(const Signal      &signal,
                 const unsigned int given_order,
                 const std::string &where);

    std::string         displacement, velocity, acceleration;
    std::string         angle, angular_velocity, table;
    std::vector<double> center_components = std::vector<double>(dim, 0.);
    std::vector<double> axis_components{0., 0., 1.};

    dealii::Point<dim>     pivot;
    dealii::Tensor<2, dim> axis_cross; ///< e x r = axis_cross r
    std::vector<Signal>    translation;
    Signal                 rotation;
    unsigned int           translation_order = 0, rotation_order = 0;
    std::string            translation_source, rotation_source;
  };
} // namespace Thalweg

#endif
