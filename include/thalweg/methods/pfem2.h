#ifndef thalweg_methods_pfem2_h
#define thalweg_methods_pfem2_h

#include <thalweg/methods/method.h>

namespace Thalweg
{
  /**
   * @brief PFEM-2 for one or two fluids (Eq. 87): particles carry velocity
   * and phase along the streamlines, the mesh solves what remains.
   */
  template <int dim>
  class Pfem2 : public Method<dim>
  {
  public:
    void
    declare_parameters(const Section &section) override;

    void
    initialize(const Parts<dim> &parts,
               const Vector     &initial_velocity,
               const Vector     &initial_level_set) override;

    void
    advance(const double time, const double dt) override;

    const Vector &
    velocity() const override
    {
      return convecting_velocity;
    }

  private:
    /// The velocity along whose streamlines the particles go from @p time
    /// to @p time + @p dt.
    void
    choose_convecting_velocity(const double time, const double dt);

    /// The mesh solves for what acts on the convected velocity during
    /// @p dt, and the particles take the increment.
    void
    accelerate(const double dt);

    std::string streamline_velocity = "staggered";

    std::unique_ptr<Parts<dim>> parts;
    Vector                      convecting_velocity;
    Vector                      old_velocity;
    Vector                      velocity_star;
    Vector                      level_set;
    CellVelocity<dim>           cell_velocity;
    CellField<dim, 1>           cell_level_set;
    /// When the flow has its present velocity. Between the times of the
    /// steps if that is staggered.
    double velocity_time = 0;
    /// How long the last acceleration took, 0 before the first.
    double old_dt = 0;
  };
} // namespace Thalweg

#endif
