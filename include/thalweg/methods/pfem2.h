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
    /// V^n, or V^n + dt/2 (V^n - V^{n-1}) / dt_old.
    void
    choose_convecting_velocity(const double dt);

    std::string streamline_velocity = "extrapolated";

    std::unique_ptr<Parts<dim>> parts;
    Vector                      convecting_velocity;
    Vector                      old_velocity;
    Vector                      velocity_star;
    Vector                      level_set;
    CellVelocity<dim>           cell_velocity;
    CellField<dim, 1>           cell_level_set;
    double                      old_dt = 0;
  };
} // namespace Thalweg

#endif
