#ifndef thalweg_simulation_time_control_h
#define thalweg_simulation_time_control_h

#include <thalweg/core/section.h>

#include <limits>
#include <string>

namespace Thalweg
{
  /**
   * @brief The parameters of the section "Time", and the size of steps.
   */
  class TimeControl
  {
  public:
    /// Declares the section below @p root.
    void
    declare_parameters(const Section &root);

    /// @throws dealii::ExcMessage for impossible values
    void
    check() const;

    double
    end_time() const
    {
      return end;
    }

    /// Whether the run is over after @p step steps at @p time.
    bool
    is_over(const double time, const unsigned int step) const;

    /**
     * @brief What bounds the steps by the viscosity (Eq. 65).
     */
    struct Viscous
    {
      /// The Fourier number of a step of one second: the largest nu / h^2,
      /// 1/s.
      double rate = 0.;
      /// The largest Fourier number with which the method is stable.
      double limit = std::numeric_limits<double>::infinity();
    };

    /**
     * @brief The size of the next step, in s.
     * @param time now, s
     * @param rate the Courant number of a step of one second: the largest
     *   velocity over cell size, 1/s
     * @param old_dt size of the last step, 0 at the start
     * @param viscous does not bound steps of a given size
     * The step is shortened to hit the end and the multiples that the
     * parameter asks for.
     */
    double
    next_step(const double   time,
              const double   rate,
              const double   old_dt,
              const Viscous &viscous) const;

    /// What is to be said at the start about a given step that is too long
    /// for the method; empty: nothing.
    std::string
    warning(const Viscous &viscous) const;

  private:
    double       end            = 1.;
    double       fixed_step     = 0.;
    double       courant_number = 2.;
    double       fourier_number = 1e30;
    double       minimum        = 1e-9;
    double       maximum        = 1e-2;
    double       growth         = 1.5;
    double       first          = 1e-3;
    double       hit_multiples  = 0.;
    unsigned int maximal_steps  = 1000000000;
  };
} // namespace Thalweg

#endif
