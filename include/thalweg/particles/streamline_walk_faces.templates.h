// SPDX-License-Identifier: LGPL-2.1-or-later
// What StreamlineWalk does at the faces of cells; a part of
// streamline_walk.templates.h.
#ifndef thalweg_particles_streamline_walk_faces_templates_h
#define thalweg_particles_streamline_walk_faces_templates_h

#include <thalweg/particles/streamline_walk.h>

#include <algorithm>
#include <cmath>

namespace Thalweg
{
  template <int dim, typename Field>
  typename StreamlineWalk<dim, Field>::Exit
  StreamlineWalk<dim, Field>::find_exit(const Coordinates &begin,
                                        Coordinates       &end)
  {
    Exit exit{Exit::none, 2.};
    for (unsigned int d = 0; d < dim; ++d)
      {
        if (end[d] >= 0. && end[d] <= 1.)
          continue;
        const double bound = end[d] > 1. ? 1. : 0.;
        if (std::abs(end[d] - bound) <= WalkDetails::snap)
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


  template <int dim, typename Field>
  void
  StreamlineWalk<dim, Field>::cross(WalkerType &walker,
                                    WalkEffort &effort) const
  {
    for (unsigned int i = 0; i < WalkDetails::max_faces_a_piece; ++i)
      {
        if (!CellPolynomial::is_finite<dim>(walker.reference))
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
            shorten_piece(walker, 1. - exit.fraction);
            undo_piece(walker);
            walker.boundary = face.boundary_id;
            walker.face     = exit.face;
            walker.fate     = Fate::left;
            return;
          }
        else
          meet_wall(walker, exit.face);
      }
    walker.fate = Fate::lost;
  }


  template <int dim, typename Field>
  void
  StreamlineWalk<dim, Field>::meet_wall(WalkerType        &walker,
                                        const unsigned int face) const
  {
    const unsigned int direction = face / 2;
    const auto         beyond    = walker.reference;
    walker.reference[direction]  = face % 2;
    if constexpr (Field::disperses)
      {
        const Coordinates n = normal(walker, direction);
        field_.hit(walker, n);
        if (walker.is_bubble || cell_graph.cell(walker.cell).axis_parallel)
          return;
        // Back along the normal, not along the cell's coordinate.
        const auto way   = maps.place(walker.cell, beyond).way;
        auto       place = maps.place(walker.cell, walker.reference);
        double     part = 0, square = 0;
        for (unsigned int d = 0; d < dim; ++d)
          {
            part += (way[d] - place.way[d]) * n[d];
            square += n[d] * n[d];
          }
        for (unsigned int d = 0; d < dim; ++d)
          place.way[d] = way[d] - part / square * n[d];
        if (maps.to_reference(walker.cell, place, walker.reference))
          walker.reference[direction] = face % 2;
      }
  }


  template <int dim, typename Field>
  typename StreamlineWalk<dim, Field>::Coordinates
  StreamlineWalk<dim, Field>::normal(const WalkerType  &walker,
                                     const unsigned int direction) const
  {
    Coordinates unit{};
    unit[direction] = 1;
    return cell_graph.cell(walker.cell).axis_parallel
             ? unit
             : CellPolynomial::solve<dim>(
                 transpose(maps.jacobian(walker.cell, walker.reference)), unit);
  }


  template <int dim, typename Field>
  bool
  StreamlineWalk<dim, Field>::enter(const typename CellGraph<dim>::Face &face,
                                    const double fraction,
                                    WalkerType  &walker) const
  {
    Coordinates crossing;
    for (unsigned int d = 0; d < dim; ++d)
      crossing[d] = walker.piece_begin[d] +
                    fraction * (walker.reference[d] - walker.piece_begin[d]);
    auto passage = maps.place(walker.cell, crossing);
    auto end     = maps.place(walker.cell, walker.reference);
    if (face.periodic >= 0)
      passage.offset = end.offset =
        cell_graph.periodic_offsets()[face.periodic];

    if (face.behind == CellGraph<dim>::Behind::cell)
      walker.cell = face.index;
    else
      walker.cell =
        maps.nearest_child(cell_graph.face_children(face.index), passage);

    if (!maps.to_reference(walker.cell, passage, walker.piece_begin))
      return false;
    shorten_piece(walker, 1. - fraction);
    if (!maps.to_reference(walker.cell, end, walker.reference))
      {
        // The end is too far outside the new cell to be expressed in its
        // coordinates: go on from the face with the time that this leaves.
        for (unsigned int d = 0; d < dim; ++d)
          walker.reference[d] = std::clamp(walker.piece_begin[d], 0., 1.);
        undo_piece(walker);
      }
    return true;
  }


  template <int dim, typename Field>
  inline void
  StreamlineWalk<dim, Field>::shorten_piece(WalkerType  &walker,
                                            const double factor)
  {
    walker.piece_time *= factor;
    if constexpr (Field::accelerates)
      for (unsigned int d = 0; d < dim; ++d)
        walker.piece_integral[d] *= factor;
  }


  template <int dim, typename Field>
  inline void
  StreamlineWalk<dim, Field>::undo_piece(WalkerType &walker)
  {
    walker.time += walker.piece_time;
    walker.piece_time = 0;
    if constexpr (Field::accelerates)
      {
        for (unsigned int d = 0; d < dim; ++d)
          walker.integral[d] -= walker.piece_integral[d];
        walker.piece_integral.fill(0);
      }
  }
} // namespace Thalweg

#endif
