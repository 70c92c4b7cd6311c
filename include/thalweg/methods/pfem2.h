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

    double
    velocity_time(const double time) const override
    {
      return time + lead;
    }

    const Vector &
    velocity() const override
    {
      return convecting_velocity;
    }

  private:
    /// The velocity along whose streamlines the particles go in the next
    /// @p dt.
    void
    choose_convecting_velocity(const double dt);

    /// The mesh solves for what acts on the convected velocity, and the
    /// particles take the increment: afterwards they are at @p time, and
    /// their velocities at @p time + @p new_lead.
    void
    accelerate(const double time, const double new_lead);

    std::string streamline_velocity = "staggered";

    std::unique_ptr<Parts<dim>> parts;
    Vector                      convecting_velocity;
    Vector                      old_velocity;
    Vector                      velocity_star;
    Vector                      level_set;
    CellVelocity<dim>           cell_velocity;
    CellField<dim, 1>           cell_level_set;
    /// The time of the flow's velocity, and by how much it is ahead of the
    /// particles' positions: half a step if velocities are staggered.
    double flow_time = 0;
    double lead      = 0;
    /// How long the last acceleration took, 0 before the first.
    double acceleration_time = 0;
  };
} // namespace Thalweg

#endif
