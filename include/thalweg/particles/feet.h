// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_feet_h
#define thalweg_particles_feet_h

#include <thalweg/core/send_plain.h>
#include <thalweg/particles/journey.h>
#include <thalweg/particles/streamline_convection.h>
#include <thalweg/particles/streamline_walk.h>

#include <array>
#include <map>
#include <vector>

namespace Thalweg
{
  /// What a walker meets at the end of its way back.
  template <int dim>
  struct Sight
  {
    std::array<double, dim> velocity;
    double                  level_set;
  };

  /// Who wants to know.
  struct Question
  {
    unsigned int rank;
    unsigned int index;
  };

  /// An answer on its way to the rank that asked.
  template <int dim>
  struct Answer
  {
    unsigned int               index;
    dealii::types::boundary_id boundary;
    double                     way; ///< s
    std::array<double, dim>    position;
    Sight<dim>                 sight;
  };

  /// The foot that an answer tells.
  template <int dim>
  Foot<dim>
  to_foot(const Answer<dim> &answer, const bool found)
  {
    Foot<dim> foot;
    for (unsigned int d = 0; d < dim; ++d)
      foot.position[d] = answer.position[d];
    foot.velocity  = answer.sight.velocity;
    foot.level_set = answer.sight.level_set;
    foot.boundary  = answer.boundary;
    foot.way       = answer.way;
    foot.found     = found;
    return foot;
  }

  /**
   * @brief Follows a walk that leads backwards in time from given points.
   * Collective; ranks may ask for any number of points.
   *
   * @param walk backwards
   * @param communicator the ranks that share the mesh
   * @param cells numbers of owned cells in the cell graph, one a point
   * @param reference_points coordinates in these cells
   * @param dt in s
   * @param look called with a walker in an owned cell for the Sight there
   * @return one foot a point; those that were not found are the points
   *   themselves
   */
  template <int dim, typename Field, typename Look>
  std::vector<Foot<dim>>
  find_feet(const StreamlineWalk<dim, Field>      &walk,
            const MPI_Comm                         communicator,
            const std::vector<unsigned int>       &cells,
            const std::vector<dealii::Point<dim>> &reference_points,
            const double                           dt,
            const Look                            &look)
  {
    AssertDimension(cells.size(), reference_points.size());
    using WalkerType = typename Field::WalkerType;
    const auto start = [&](const unsigned int i) {
      return WalkerType::start(cells[i], reference_points[i], dt);
    };
    const auto answer_to = [&](const WalkerType  &walker,
                               const unsigned int index) {
      const dealii::Point<dim> position = walk.position(walker);
      Answer<dim>              answer;
      answer.index    = index;
      answer.boundary = walker.fate == Fate::left
                          ? walker.boundary
                          : dealii::numbers::invalid_boundary_id;
      answer.way      = dt - walker.time;
      for (unsigned int d = 0; d < dim; ++d)
        answer.position[d] = position[d];
      answer.sight = look(walker);
      return answer;
    };

    std::vector<Traveller<WalkerType, Question>> travellers;
    travellers.reserve(cells.size());
    WalkEffort effort;
    for (unsigned int i = 0; i < cells.size(); ++i)
      {
        travellers.push_back(
          {start(i),
           {dealii::Utilities::MPI::this_mpi_process(communicator), i}});
        walk.walk(travellers.back().walker, effort);
      }
    walk_on_other_ranks(walk, communicator, travellers, effort);

    std::map<unsigned int, std::vector<Answer<dim>>> answers;
    for (const auto &[walker, question] : travellers)
      if (walker.fate != Fate::lost)
        answers[question.rank].push_back(answer_to(walker, question.index));

    std::vector<Foot<dim>> feet;
    feet.reserve(cells.size());
    for (unsigned int i = 0; i < cells.size(); ++i)
      feet.push_back(to_foot(answer_to(start(i), i), false));
    for (const auto &[rank, list] : send_plain(communicator, answers))
      for (const Answer<dim> &answer : list)
        feet[answer.index] = to_foot(answer, true);
    return feet;
  }
} // namespace Thalweg

#endif
