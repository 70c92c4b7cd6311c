// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_tracer_cloud_h
#define thalweg_particles_tracer_cloud_h

#include <thalweg/fields/carried.h>
#include <thalweg/mesh/mesh.h>
#include <thalweg/particles/journey.h>
#include <thalweg/particles/streamline_walk.h>

#include <vector>

namespace Thalweg
{
  /// What a tracer knows of itself.
  template <int dim>
  struct Tracer
  {
    std::uint64_t           id;
    double                  released; ///< when, s
    std::array<double, dim> origin;   ///< where, m
  };

  /// A tracer that came to an open boundary.
  template <int dim>
  struct TracerExit
  {
    Tracer<dim>                tracer;
    double                     time; ///< s
    std::array<double, dim>    place;
    dealii::types::boundary_id boundary;
  };

  /**
   * @brief Points that follow a velocity and change nothing: flat memory in
   * the order of the cells, for millions of them.
   */
  template <int dim>
  class TracerCloud : public Carried<dim>
  {
  public:
    using typename Carried<dim>::CellIterator;
    using Member = Traveller<Walker<dim>, Tracer<dim>>;

    /// What became of those that did not arrive, on this rank.
    struct Report
    {
      std::vector<TracerExit<dim>> exits;
      std::uint64_t                n_lost = 0;
    };

    /// @param mesh must outlive the object
    explicit TracerCloud(const Mesh<dim> &mesh);

    /// Adds one at a point of an owned cell, which goes @p time seconds of
    /// the next move(), less than all of them if it appears during the step.
    void
    add(const unsigned int        cell,
        const dealii::Point<dim> &reference,
        const double              time,
        const Tracer<dim>        &tracer);

    /// Those that were added are there from now on, whatever add() said of
    /// their time.
    void
    settle();

    /**
     * @brief Moves all by @p dt seconds, and those that were added since the
     * last time by what add() said. Collective.
     * @param end of the step, s
     */
    Report
    move(const StreamlineWalk<dim> &walk, const double dt, const double end);

    /// Those of this rank, in the order of the cells after move().
    const std::vector<Member> &
    members() const
    {
      return cloud;
    }

    const Mesh<dim> &
    mesh() const
    {
      return mesh_;
    }

    /// On all ranks. Collective.
    std::uint64_t
    n_global() const;

    void
    save() override;

    void
    restore() override;

    void
    clear() override;

    void
    pack(const CellIterator    &cell,
         const Compat::CellFate fate,
         std::vector<char>     &bytes) const override;

    void
    begin_to_unpack() override;

    void
    unpack(const CellIterator    &cell,
           const Compat::CellFate fate,
           PlainReader           &reader) override;

    void
    check_unpacked() const override;

    void
    end_to_unpack() override;

  private:
    /// Takes those out that are not in a cell, and puts the others into the
    /// order of the cells, with the numbers of the first one of each.
    void
    sort(std::vector<unsigned int> &begin);

    const Mesh<dim>    &mesh_;
    std::vector<Member> cloud;
    /// Those behind were added since the last move().
    std::size_t               n_old = 0;
    std::vector<Member>       saved, received;
    std::vector<unsigned int> saved_begin;
  };
} // namespace Thalweg

#endif
