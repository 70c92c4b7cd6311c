// SPDX-License-Identifier: LGPL-2.1-or-later
// The definitions of StreamlineWalk's functions, for the files that
// instantiate it.
#ifndef thalweg_particles_streamline_walk_templates_h
#define thalweg_particles_streamline_walk_templates_h

#include <thalweg/particles/streamline_walk.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Thalweg
{
  namespace WalkDetails
  {
    /// A coordinate that is outside [0,1] by less counts as inside: far above
    /// the round-off between neighbours, far below everything else.
    constexpr double snap = 1e-10;

    /// No piece of way of half a cell crosses as many faces, and no sensible
    /// time step needs as many substeps.
    constexpr unsigned int max_faces_a_piece  = 64;
    constexpr unsigned int max_substeps_a_way = 100000;

    template <int dim>
    inline bool
    is_inside(const std::array<double, dim> &x)
    {
      bool inside = true;
      for (unsigned int d = 0; d < dim; ++d)
        inside &= (x[d] >= 0.) & (x[d] <= 1.);
      return inside;
    }

    template <int dim>
    inline std::array<double, dim>
    along(const std::array<double, dim> &begin,
          const double                   factor,
          const std::array<double, dim> &rate)
    {
      std::array<double, dim> point;
      for (unsigned int d = 0; d < dim; ++d)
        point[d] = begin[d] + factor * rate[d];
      return point;
    }

    /// A step of the classical Runge-Kutta scheme with its four rates.
    template <int dim>
    inline std::array<double, dim>
    classical(const std::array<double, dim> &begin,
              const double                   time,
              const std::array<double, dim> &k1,
              const std::array<double, dim> &k2,
              const std::array<double, dim> &k3,
              const std::array<double, dim> &k4)
    {
      std::array<double, dim> end;
      for (unsigned int d = 0; d < dim; ++d)
        end[d] = begin[d] + time / 6. * (k1[d] + 2. * (k2[d] + k3[d]) + k4[d]);
      return end;
    }
  } // namespace WalkDetails


  template <int dim, typename Field>
  StreamlineWalk<dim, Field>::StreamlineWalk(const CellGraph<dim> &graph,
                                             Field                 field,
                                             const WalkSettings   &settings)
    : cell_graph(graph)
    , maps(graph)
    , field_(std::move(field))
    , scheme(settings.scheme)
  {
    for (const auto &[boundary, kind] : settings.walls)
      if (kind == WallKind::open)
        {
          open.resize(std::max<std::size_t>(open.size(), boundary + 1), false);
          open[boundary] = true;
        }
  }


  template <int dim, typename Field>
  template <bool axis_parallel>
  inline typename StreamlineWalk<dim, Field>::Coordinates
  StreamlineWalk<dim, Field>::rate(const WalkerType  &walker,
                                   const Coordinates &reference,
                                   const double       time_left) const
  {
    Coordinates result  = field_.velocity(walker, reference, time_left);
    double      stretch = 1;
    if constexpr (!axis_parallel)
      {
        const auto jacobian = maps.jacobian(walker.cell, reference);
        result              = CellPolynomial::solve<dim>(jacobian, result);
        stretch             = determinant(jacobian);
      }
    if constexpr (Field::has_bubbles)
      field_.add_bubbles(walker, reference, stretch, result);
    return result;
  }


  template <int dim, typename Field>
  template <StreamlineScheme scheme, bool axis_parallel>
  inline typename StreamlineWalk<dim, Field>::Coordinates
  StreamlineWalk<dim, Field>::substep(const WalkerType &walker,
                                      const double      time,
                                      Coordinates      &gain) const
  {
    using WalkDetails::along;
    const Coordinates begin       = walker.reference;
    const double      time_left   = walker.time;
    const double      half        = 0.5 * time;
    const double      left_middle = time_left - half;
    const Coordinates k1 = rate<axis_parallel>(walker, begin, time_left);
    const Coordinates p2 = along<dim>(begin, half, k1);
    const Coordinates k2 = rate<axis_parallel>(walker, p2, left_middle);
    if constexpr (scheme == StreamlineScheme::rk2)
      {
        if constexpr (Field::accelerates)
          gain =
            along<dim>({}, time, field_.acceleration(walker, p2, left_middle));
        return along<dim>(begin, time, k2);
      }
    else
      {
        const double      left_end = time_left - time;
        const Coordinates p3       = along<dim>(begin, half, k2);
        const Coordinates k3 = rate<axis_parallel>(walker, p3, left_middle);
        const Coordinates p4 = along<dim>(begin, time, k3);
        const Coordinates k4 = rate<axis_parallel>(walker, p4, left_end);
        if constexpr (Field::accelerates)
          gain = WalkDetails::classical<dim>(
            {},
            time,
            field_.acceleration(walker, begin, time_left),
            field_.acceleration(walker, p2, left_middle),
            field_.acceleration(walker, p3, left_middle),
            field_.acceleration(walker, p4, left_end));
        return WalkDetails::classical<dim>(begin, time, k1, k2, k3, k4);
      }
  }


  template <int dim, typename Field>
  template <StreamlineScheme scheme>
  typename StreamlineWalk<dim, Field>::Coordinates
  StreamlineWalk<dim, Field>::careful_substep(const WalkerType &walker,
                                              double           &time,
                                              Coordinates      &gain) const
  {
    if constexpr (Field::disperses)
      if (!walker.is_bubble)
        return flight(walker, time, gain);
    // Outside a strongly distorted cell its map may be folded: shorter
    // substeps keep the stages nearer.
    Coordinates end = substep<scheme, false>(walker, time, gain);
    for (unsigned int i = 0; i < 6 && !CellPolynomial::is_finite<dim>(end); ++i)
      {
        time *= 0.5;
        end = substep<scheme, false>(walker, time, gain);
      }
    return end;
  }


  template <int dim, typename Field>
  template <StreamlineScheme scheme>
  void
  StreamlineWalk<dim, Field>::walk_with(WalkerType &walker,
                                        WalkEffort &effort) const
  {
    using WalkDetails::is_inside;
    if (!is_inside<dim>(walker.reference))
      cross(walker, effort);

    unsigned int n_substeps = 0;
    while (walker.time > 0 && walker.fate == Fate::under_way)
      {
        double time = std::min(walker.time, field_.longest_substep(walker));
        Coordinates end, gain;
        if (cell_graph.cell(walker.cell).axis_parallel)
          end = substep<scheme, true>(walker, time, gain);
        else
          end = careful_substep<scheme>(walker, time, gain);
        walker.time -= time;
        if constexpr (Field::accelerates)
          for (unsigned int d = 0; d < dim; ++d)
            walker.integral[d] += gain[d];

        if (is_inside<dim>(end))
          walker.reference = end;
        else
          {
            walker.piece_begin = walker.reference;
            walker.piece_time  = time;
            if constexpr (Field::accelerates)
              walker.piece_integral = gain;
            walker.reference = end;
            cross(walker, effort);
          }

        if (++n_substeps == WalkDetails::max_substeps_a_way)
          walker.fate = Fate::lost;
        if constexpr (Field::disperses)
          if (walker.fate == Fate::under_way && field_.lands(walker))
            walker.fate = Fate::landed;
      }
    effort.n_substeps += n_substeps;
    if (walker.fate == Fate::under_way)
      walker.fate = Fate::arrived;
    if constexpr (Field::accelerates)
      if (!CellPolynomial::is_finite<dim>(walker.integral))
        walker.fate = Fate::lost;
  }


  template <int dim, typename Field>
  typename StreamlineWalk<dim, Field>::Coordinates
  StreamlineWalk<dim, Field>::flight(const WalkerType &walker,
                                     double           &time,
                                     Coordinates      &gain) const
  {
    // What is a parabola in space is none in the cell's coordinates.
    Coordinates end;
    end.fill(std::numeric_limits<double>::quiet_NaN());
    if constexpr (Field::disperses)
      for (unsigned int i = 0; i < 7; ++i, time *= .5)
        {
          auto              place = maps.place(walker.cell, walker.reference);
          const Coordinates way   = field_.way(walker, time);
          place.way               = WalkDetails::along<dim>(place.way, 1., way);
          gain = WalkDetails::along<dim>({}, time, walker.acceleration);
          if (maps.to_reference(walker.cell, place, end))
            return end;
        }
    return end;
  }


  template <int dim, typename Field>
  void
  StreamlineWalk<dim, Field>::walk(WalkerType &walker, WalkEffort &effort) const
  {
    Assert(walker.cell < cell_graph.n_owned_cells(),
           dealii::ExcMessage("A walker can only start in an owned cell."));
    if (scheme == StreamlineScheme::rk2)
      walk_with<StreamlineScheme::rk2>(walker, effort);
    else
      walk_with<StreamlineScheme::rk4>(walker, effort);
  }


  template <int dim, typename Field>
  dealii::Point<dim>
  StreamlineWalk<dim, Field>::position(const Walker<dim> &walker) const
  {
    const Coordinates coordinates =
      maps.to_space(walker.cell, walker.reference);
    dealii::Point<dim> position;
    for (unsigned int d = 0; d < dim; ++d)
      position[d] = coordinates[d];
    return position;
  }
} // namespace Thalweg

#include <thalweg/particles/streamline_walk_faces.templates.h>

#endif
