// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_flow_terms_h
#define thalweg_fluid_flow_terms_h

#include <thalweg/fields/node_space.h>

#include <map>
#include <string>

namespace Thalweg
{
  /**
   * @brief An acceleration at the nodes of a flow that is linear in time, as
   * far as it is known: between two times, and for some steps behind them.
   */
  struct NodalAcceleration
  {
    Vector before, now; ///< on NodeSpace::velocity(), ghosted, m/s^2
    double time_before = 0., time_now = 0.; ///< s

    /// How much of `now` there is at @p time; the rest is `before`.
    double
    part_of_now(const double time) const;
  };



  /**
   * @brief What else acts in a flow than its own forces; methods of flows
   * offer it under "flow terms", couplings add to it.
   *
   * At first, and behind each attach(), nothing acts.
   */
  template <int dim>
  class FlowTerms
  {
  public:
    static constexpr const char *port = "flow terms";

    /// Forgets all that acts. @param space where accelerations are given; must
    /// outlive the object, or the next attach()
    void
    attach(const NodeSpace<dim> &space);

    /// Where accelerations are given.
    const NodeSpace<dim> &
    space() const
    {
      return *nodes;
    }

    /**
     * @brief Lets an acceleration act from now on, in place of what @p whose
     * was before.
     * @param whose the name of the coupling
     * @param acceleration must outlive the object, or the next attach(); may
     *   change between steps
     */
    void
    accelerate(const std::string &whose, const NodalAcceleration &acceleration);

    /// Whether anything acts.
    bool
    has_acceleration() const
    {
      return !accelerations.empty();
    }

    /// Everything is that at @p time from now on, in s.
    void
    set_time(const double time);

    /**
     * @brief Adds what acts to a field, in m/s^2; owned entries, ghosts are
     * not updated.
     * @param field on NodeSpace::velocity()
     */
    void
    add_acceleration(Vector &field) const;

    /// The same at the nodes of another space on the same mesh; of degree 2,
    /// those between vertices have what lies between.
    void
    add_acceleration(const LagrangeSpace<dim> &space, Vector &field) const;

  private:
    const NodeSpace<dim>                            *nodes = nullptr;
    std::map<std::string, const NodalAcceleration *> accelerations;
    double                                           time = 0.;
  };
} // namespace Thalweg

#endif
