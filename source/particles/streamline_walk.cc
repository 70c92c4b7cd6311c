#include <thalweg/core/registry.h>
#include <thalweg/particles/cell_polynomial.h>
#include <thalweg/particles/streamline_walk.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Thalweg
{
  using namespace CellPolynomial;

  namespace
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
    std::array<double, dim>
    along(const std::array<double, dim> &begin,
          const double                   factor,
          const std::array<double, dim> &rate)
    {
      std::array<double, dim> point;
      for (unsigned int d = 0; d < dim; ++d)
        point[d] = begin[d] + factor * rate[d];
      return point;
    }
  } // namespace


  template <int dim>
  template <bool axis_parallel>
  inline typename StreamlineWalk<dim>::Coordinates
  StreamlineWalk<dim>::rate(const unsigned int cell,
                            const Coordinates &reference) const
  {
    const Coordinates velocity = evaluate(flow[cell].velocity, reference);
    if constexpr (axis_parallel)
      return velocity;
    else
      return solve<dim>(gradient<dim>(shape[cell], reference), velocity);
  }


  template <int dim>
  template <StreamlineScheme scheme, bool axis_parallel>
  inline typename StreamlineWalk<dim>::Coordinates
  StreamlineWalk<dim>::substep(const unsigned int cell,
                               const Coordinates &begin,
                               const double       time) const
  {
    const Coordinates k1 = rate<axis_parallel>(cell, begin);
    const Coordinates k2 =
      rate<axis_parallel>(cell, along<dim>(begin, 0.5 * time, k1));
    if constexpr (scheme == StreamlineScheme::rk2)
      return along<dim>(begin, time, k2);
    else
      {
        const Coordinates k3 =
          rate<axis_parallel>(cell, along<dim>(begin, 0.5 * time, k2));
        const Coordinates k4 =
          rate<axis_parallel>(cell, along<dim>(begin, time, k3));
        Coordinates end;
        for (unsigned int d = 0; d < dim; ++d)
          end[d] =
            begin[d] + time / 6. * (k1[d] + 2. * (k2[d] + k3[d]) + k4[d]);
        return end;
      }
  }


  template <int dim>
  template <StreamlineScheme scheme>
  typename StreamlineWalk<dim>::Coordinates
  StreamlineWalk<dim>::careful_substep(const unsigned int cell,
                                       const Coordinates &begin,
                                       double            &time) const
  {
    // Outside a strongly distorted cell its map may be folded: shorter
    // substeps keep the stages nearer.
    Coordinates end = substep<scheme, false>(cell, begin, time);
    for (unsigned int i = 0; i < 6 && !is_finite<dim>(end); ++i)
      {
        time *= 0.5;
        end = substep<scheme, false>(cell, begin, time);
      }
    return end;
  }


  template <int dim>
  template <StreamlineScheme scheme>
  void
  StreamlineWalk<dim>::walk_with(Walker<dim> &walker, WalkEffort &effort) const
  {
    if (!is_inside<dim>(walker.reference))
      cross(walker, effort);

    unsigned int n_substeps = 0;
    while (walker.time > 0 && walker.fate == Fate::under_way)
      {
        double time = std::min(walker.time, flow[walker.cell].longest_substep);
        Coordinates end;
        if (cell_graph.cell(walker.cell).axis_parallel)
          end = substep<scheme, true>(walker.cell, walker.reference, time);
        else
          end = careful_substep<scheme>(walker.cell, walker.reference, time);
        walker.time -= time;

        if (is_inside<dim>(end))
          walker.reference = end;
        else
          {
            walker.piece_begin = walker.reference;
            walker.piece_time  = time;
            walker.reference   = end;
            cross(walker, effort);
          }

        if (++n_substeps == max_substeps_a_way)
          walker.fate = Fate::lost;
      }
    effort.n_substeps += n_substeps;
    if (walker.fate == Fate::under_way)
      walker.fate = Fate::arrived;
  }


  template <int dim>
  void
  StreamlineWalk<dim>::walk(Walker<dim> &walker, WalkEffort &effort) const
  {
    Assert(walker.cell < cell_graph.n_owned_cells(),
           dealii::ExcMessage("A walker can only start in an owned cell."));
    if (scheme == StreamlineScheme::rk2)
      walk_with<StreamlineScheme::rk2>(walker, effort);
    else
      walk_with<StreamlineScheme::rk4>(walker, effort);
  }


  template <int dim>
  typename StreamlineWalk<dim>::Exit
  StreamlineWalk<dim>::find_exit(const Coordinates &begin, Coordinates &end)
  {
    Exit exit{Exit::none, 2.};
    for (unsigned int d = 0; d < dim; ++d)
      {
        if (end[d] >= 0. && end[d] <= 1.)
          continue;
        const double bound = end[d] > 1. ? 1. : 0.;
        if (std::abs(end[d] - bound) <= snap)
          {
            end[d] = bound;
            continue;
          }
        double fraction = (bound - begin[d]) / (end[d] - begin[d]);
        // the piece may begin outside, by round-off or on the other side
        fraction = fraction > 0. ? std::min(fraction, 1.) : 0.;
        if (fraction < exit.fraction)
          exit = {2 * d + (end[d] > 1. ? 1 : 0), fraction};
      }
    return exit;
  }


  template <int dim>
  void
  StreamlineWalk<dim>::cross(Walker<dim> &walker, WalkEffort &effort) const
  {
    for (unsigned int i = 0; i < max_faces_a_piece; ++i)
      {
        if (!is_finite<dim>(walker.reference))
          break;
        const Exit exit = find_exit(walker.piece_begin, walker.reference);
        if (exit.face == Exit::none)
          return;

        using Graph      = CellGraph<dim>;
        const auto &face = cell_graph.cell(walker.cell).faces[exit.face];
        if (face.behind != Graph::Behind::boundary)
          {
            ++effort.n_cells_crossed;
            if (!enter(face, exit.fraction, walker))
              break;
            if (walker.cell >= cell_graph.n_owned_cells())
              {
                walker.fate = Fate::elsewhere;
                return;
              }
          }
        else if (is_open(face.boundary_id))
          {
            for (unsigned int d = 0; d < dim; ++d)
              walker.reference[d] =
                walker.piece_begin[d] +
                exit.fraction * (walker.reference[d] - walker.piece_begin[d]);
            walker.boundary = face.boundary_id;
            walker.fate     = Fate::left;
            return;
          }
        else
          walker.reference[exit.face / 2] = exit.face % 2;
      }
    walker.fate = Fate::lost;
  }


  template <int dim>
  bool
  StreamlineWalk<dim>::enter(const typename CellGraph<dim>::Face &face,
                             const double                         fraction,
                             Walker<dim>                         &walker) const
  {
    Coordinates crossing;
    for (unsigned int d = 0; d < dim; ++d)
      crossing[d] = walker.piece_begin[d] +
                    fraction * (walker.reference[d] - walker.piece_begin[d]);
    crossing        = to_space(walker.cell, crossing);
    Coordinates end = to_space(walker.cell, walker.reference);
    if (face.periodic >= 0)
      {
        const auto &offset = cell_graph.periodic_offsets()[face.periodic];
        for (unsigned int d = 0; d < dim; ++d)
          {
            crossing[d] += offset[d];
            end[d] += offset[d];
          }
      }

    if (face.behind == CellGraph<dim>::Behind::cell)
      walker.cell = face.index;
    else
      walker.cell =
        nearest_child(cell_graph.face_children(face.index), crossing);

    if (!to_reference(walker.cell, crossing, walker.piece_begin))
      return false;
    walker.piece_time *= 1. - fraction;
    if (!to_reference(walker.cell, end, walker.reference))
      {
        // The end is too far outside the new cell to be expressed in its
        // coordinates: go on from the face with the time that this leaves.
        for (unsigned int d = 0; d < dim; ++d)
          walker.reference[d] = std::clamp(walker.piece_begin[d], 0., 1.);
        walker.time += walker.piece_time;
        walker.piece_time = 0;
      }
    return true;
  }


  template <int dim>
  inline typename StreamlineWalk<dim>::Coordinates
  StreamlineWalk<dim>::to_space(const unsigned int cell,
                                const Coordinates &reference) const
  {
    const auto &geometry = cell_graph.cell(cell);
    if (!geometry.axis_parallel)
      return evaluate(shape[cell], reference);
    Coordinates position;
    for (unsigned int d = 0; d < dim; ++d)
      position[d] = geometry.vertices[0][d] + reference[d] * geometry.extent[d];
    return position;
  }


  template <int dim>
  inline bool
  StreamlineWalk<dim>::to_reference(const unsigned int cell,
                                    const Coordinates &position,
                                    Coordinates       &reference) const
  {
    const auto &geometry = cell_graph.cell(cell);
    if (!geometry.axis_parallel)
      return find_reference(cell, position, reference);
    for (unsigned int d = 0; d < dim; ++d)
      reference[d] =
        (position[d] - geometry.vertices[0][d]) * geometry.inverse_extent[d];
    return true;
  }


  template <int dim>
  unsigned int
  StreamlineWalk<dim>::nearest_child(
    const std::array<int, CellGraph<dim>::n_face_children> &children,
    const Coordinates                                      &position) const
  {
    int    nearest          = children[0];
    double nearest_distance = std::numeric_limits<double>::max();
    for (const int child : children)
      {
        Coordinates reference;
        if (!to_reference(child, position, reference))
          continue;
        double outside = 0;
        for (unsigned int d = 0; d < dim; ++d)
          outside = std::max({outside, -reference[d], reference[d] - 1.});
        if (outside < nearest_distance)
          {
            nearest          = child;
            nearest_distance = outside;
          }
      }
    return nearest;
  }


  template <int dim>
  dealii::Point<dim>
  StreamlineWalk<dim>::position(const Walker<dim> &walker) const
  {
    const Coordinates  coordinates = to_space(walker.cell, walker.reference);
    dealii::Point<dim> position;
    for (unsigned int d = 0; d < dim; ++d)
      position[d] = coordinates[d];
    return position;
  }
} // namespace Thalweg

THALWEG_INSTANTIATE(Thalweg::StreamlineWalk)
