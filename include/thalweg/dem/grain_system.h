// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_grain_system_h
#define thalweg_dem_grain_system_h

#include <thalweg/dem/halo.h>
#include <thalweg/dem/law.h>
#include <thalweg/dem/wall_list.h>

#include <functional>
#include <memory>

namespace Thalweg
{
  /// Who owns a place.
  struct GrainOwner
  {
    static constexpr int left = -1; ///< behind an open boundary
    static constexpr int lost = -2; ///< outside of all
    /// Instead of a boundary: taken out.
    static constexpr std::uint32_t no_boundary = -1;

    int           rank;
    std::uint32_t cell; ///< on that rank
    /// Where a grain leaves.
    std::uint32_t boundary = 0;
  };

  /// Knows the mesh: says which rank and cell places belong to.
  class GrainLocator
  {
  public:
    virtual ~GrainLocator() = default;

    /// @param places of grains of this rank, with their radii. Collective.
    virtual std::vector<GrainOwner>
    locate(const std::vector<GrainPlace> &places) const = 0;

    /// By how much places are moved into the mesh that passed a periodic
    /// boundary, m.
    virtual Vec3
    wrap(const Vec3 &) const
    {
      return {0., 0., 0.};
    }
  };

  /// What does not change during a run.
  struct GrainSettings
  {
    int                 dim;
    std::vector<double> densities; ///< of the materials, kg/m^3
    RollingModel        rolling = RollingModel::none;
    bool                spins   = true; ///< whether grains turn
    bool                counts  = true; ///< whether energy is counted
    double              skin    = .25;  ///< of the smallest radius
    /// Of the skin: how far apart pairs are that the loop meets.
    double inner_margin = .1;
  };

  /// A grain that is no longer there.
  struct GoneGrain
  {
    GrainRecord   grain;
    std::uint32_t boundary;
    bool          is_lost;
  };

  /// What was done and counted since the start, on this rank.
  struct GrainCounts
  {
    std::uint64_t n_rebuilds = 0, n_prunes = 0;
    ContactWork   work;
    double        wall_work = 0.; ///< of moving walls on grains, J
    /// Of the last forces, which have acted for half of their step only.
    ContactWork last_work;
    double      last_wall_work = 0.; ///< J
  };

  /**
   * @brief Grains in motion: storage, lists, contacts and integration.
   *
   * The order of grains, and with it of all sums, follows from where they were
   * at the last rebuild and from their numbers; lists are made from these
   * references too, so that a state that is restored elsewhere goes on with the
   * same bits.
   */
  class GrainSystem
  {
  public:
    /// @param law prepared; like @p walls it must outlive the object
    GrainSystem(const MPI_Comm           communicator,
                const ContactLaw        &law,
                const GrainSettings     &settings,
                WallSet                 &walls,
                const std::vector<Vec3> &periods);

    /// Who says where grains belong, for each mesh anew.
    void
    set_locator(const GrainLocator &locator_)
    {
      locator = &locator_;
    }

    /// Makes these all that there is and the lists as they were. Collective.
    void
    restore(const GrainSet &set);

    /// Adds grains and makes all lists anew. Collective.
    void
    add(const std::vector<GrainRecord> &grains);

    /// Takes out the grains whose centers are where @p is_gone says; they are
    /// among those of take_gone(). Collective.
    void
    remove(const std::function<bool(const Vec3 &)> &is_gone);

    /// This rank's grains, in their order.
    GrainSet
    all() const;

    void
    clear();

    /**
     * @brief Makes so many steps of @p dt seconds. Collective.
     * @param acceleration of all grains, m/s^2
     * @param before_contacts is called with the number of the step when grains
     *   have moved, for what acts on them besides contacts
     * @param time at the beginning, for walls that move, s
     */
    void
    advance(const unsigned int                             n_steps,
            const double                                   dt,
            const Vec3                                    &acceleration,
            const std::function<void(const unsigned int)> &before_contacts,
            const double                                   time = 0.);

    /// Adds a force to each of this rank's grains: @p force is called with place,
    /// velocity and mass.
    template <typename Force>
    void
    add_forces(const Force &force)
    {
      for (const std::uint32_t i : own_places)
        arrays.load[i].force += force(arrays.place[i].x,
                                      arrays.motion[i].v,
                                      1. / arrays.motion[i].inverse_mass);
    }

    const GrainArrays &
    grains() const
    {
      return arrays;
    }

    const ContactList &
    contacts() const
    {
      return near;
    }

    const WallList &
    wall_contacts() const
    {
      return wall_list;
    }

    std::size_t
    n_own() const
    {
      return own_places.size();
    }

    /// Where this rank's grains are in grains().
    const std::vector<std::uint32_t> &
    own() const
    {
      return own_places;
    }

    /// The cells of the mesh of own grains.
    const std::vector<std::uint32_t> &
    cells() const
    {
      return own_cells;
    }

    double
    mass(const unsigned int material, const double r) const;

    double
    inertia_factor() const
    {
      return settings.dim == 3 ? .4 : .5;
    }

    /// That have gone since the last call, on this rank.
    std::vector<GoneGrain>
    take_gone();

    GrainCounts counts;
    /// How far grains may have come since the last rebuild, m, the same on all
    /// ranks; to be kept.
    double travelled = 0.;

  private:
    void
    rebuild();

    /// Lets all begin where they are, a period back where they have crossed
    /// the boundary.
    void
    begin_anew(GrainSet &set);

    /// Sends grains to the ranks that own their references, and takes those out
    /// that have gone.
    void
    distribute(GrainSet &set);

    /// Makes halo, order and lists of a set whose grains are all this rank's.
    void
    arrange(const GrainSet &set);

    /// Puts a grain of this rank at place @p i of the arrays.
    void
    set_own(const std::size_t  i,
            const GrainRecord &grain,
            const double       inverse_mass);

    /// The same for a grain of the halo.
    void
    set_halo(const std::size_t i, const HaloGrain &grain);

    /// Finds neighbours and walls at the references.
    void
    find_at_references(const std::vector<GrainCells::Key> &key);

    /// Finds what touches now, and gives it what the set remembers.
    /// @param row of each grain in the set, or -1
    /// @param order_of_own rows of own grains in their order
    void
    make_contacts(const GrainSet                   &set,
                  const std::vector<std::int32_t>  &row,
                  const std::vector<std::uint32_t> &order_of_own);

    void
    prune();

    /// Whether lists hold after a step, and what to do if not.
    /// @param way of the fastest grain of this rank and of walls, m
    void
    check_lists(const double way);

    void
    add_contacts(const double dt);

    /// How far grains and walls are from their references, m, at the most.
    double
    farthest() const;

    double
    maximum(double value) const;

    MPI_Comm                   communicator;
    int                        n_ranks;
    const ContactLaw          &law;
    const GrainSettings        settings;
    WallSet                   &walls;
    const GrainLocator        *locator = nullptr;
    GrainArrays                arrays;
    Halo                       halo;
    GrainCells                 linked_cells;
    PairList                   neighbours;
    ContactList                near;
    WallList                   wall_list;
    double                     skin = 0., inner_margin = 0.; ///< m
    double                     travelled_since_pruning = 0.; ///< m
    bool                       is_in_step              = false;
    std::vector<std::uint32_t> own_places, own_cells;
    std::vector<std::uint32_t> moving_facets; ///< that are near own grains
    std::vector<GoneGrain>     gone;
  };
} // namespace Thalweg

#endif
