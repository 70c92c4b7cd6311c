// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/compat_forest.h>
#include <thalweg/mesh/mesh_plan.h>

#include <limits>

namespace Thalweg
{
  namespace
  {
    template <int dim>
    using Types = dealii::internal::p4est::types<dim>;

    template <int dim>
    using P4estFunctions = dealii::internal::p4est::functions<dim>;



    /// An array of p4est that goes with this object.
    struct ScArray
    {
      ScArray(const std::size_t size_of_entry, const std::size_t size)
        : array(sc_array_new_count(size_of_entry, size))
      {}

      ScArray(const ScArray &) = delete;

      ~ScArray()
      {
        sc_array_destroy(array);
      }

      sc_array_t *array;
    };



    /// How many cells the trees before each one have, and all at the end.
    template <int dim>
    std::vector<typename Types<dim>::gloidx>
    cells_before_trees(const MPI_Comm                communicator,
                       const std::vector<CurveCell> &cells,
                       const std::size_t             n_trees)
    {
      std::vector<unsigned int> counts(n_trees, 0);
      for (const CurveCell &cell : cells)
        ++counts[cell.tree];
      dealii::Utilities::MPI::sum(counts, communicator, counts);
      std::vector<typename Types<dim>::gloidx> before(n_trees + 1, 0);
      for (std::size_t t = 0; t < n_trees; ++t)
        before[t + 1] = before[t] + counts[t];
      return before;
    }



    /// A forest with the saved cells of each rank.
    template <int dim>
    typename Types<dim>::forest *
    make_forest(const typename Types<dim>::forest &coarse,
                const SavedCells                  &saved)
    {
      const std::vector<typename Types<dim>::gloidx> first(
        saved.first_of_rank.begin(), saved.first_of_rank.end());
      const auto before = cells_before_trees<dim>(coarse.mpicomm,
                                                  saved.own,
                                                  coarse.trees->elem_count);
      // p4est wants coordinates and level of one cell behind those of the
      // other.
      const ScArray quadrants(sizeof(typename Types<dim>::quadrant_coord),
                              (dim + 1) * saved.own.size());
      auto *next = reinterpret_cast<typename Types<dim>::quadrant_coord *>(
        quadrants.array->array);
      for (const CurveCell &cell : saved.own)
        {
          typename Types<dim>::quadrant quadrant;
          P4estFunctions<dim>::quadrant_set_morton(&quadrant,
                                                   cell.level,
                                                   cell.path);
          for (unsigned int d = 0; d < dim; ++d)
            *next++ = Compat::coordinate(quadrant, d);
          *next++ = cell.level;
        }
      return Compat::inflate(coarse.mpicomm,
                             coarse.connectivity,
                             first.data(),
                             before.data(),
                             quadrants.array);
    }



    template <int dim>
    class P4est : public MeshPartition<dim>
    {
    public:
      using typename MeshPartition<dim>::Triangulation;

      bool
      can_change() const override
      {
        return true;
      }


      std::unique_ptr<Triangulation>
      create(const MPI_Comm communicator, MeshPlan<dim> &plan) const override
      {
        auto forest = MeshPlan<dim>::empty_forest(communicator);
        plan.create_coarse(*forest);
        plan.refine(*forest);
        return forest;
      }


      std::unique_ptr<Triangulation>
      create_to_load(const MPI_Comm communicator,
                     MeshPlan<dim> &plan) const override
      {
        auto forest = MeshPlan<dim>::empty_forest(communicator);
        plan.create_coarse(*forest);
        return forest;
      }


      void
      load(Triangulation &mesh, const SavedCells &saved) const override
      {
        auto &forest = dynamic_cast<typename MeshPlan<dim>::Forest &>(mesh);
        const std::string fault = fault_of<dim>(forest.get_communicator(),
                                                saved.own,
                                                forest.n_global_coarse_cells());
        AssertThrow(fault.empty(),
                    dealii::ExcMessage("The checkpoint '" + saved.place +
                                       "' cannot be used: " + fault + "."));
        auto      *made = make_forest<dim>(*forest.get_p4est(), saved);
        const auto n    = made->global_num_quadrants;
        Compat::balance(made);
        const bool fits = made->global_num_quadrants == n;
        // Siblings can vanish into their parent only where they are together;
        // on the old number of ranks they are.
        if (fits && saved.n_ranks != saved.n_old_ranks)
          P4estFunctions<dim>::partition(made, 1, nullptr);
        if (fits)
          forest.load(made);
        P4estFunctions<dim>::destroy(made);
        AssertThrow(fits,
                    dealii::ExcMessage("The checkpoint '" + saved.place +
                                       "' cannot be used: levels of "
                                       "neighbouring cells differ by more than "
                                       "one."));
      }
    };
  } // namespace

  THALWEG_REGISTER(MeshPartition,
                   P4est,
                   "p4est",
                   "equal parts of a curve through all cells, for meshes that "
                   "stay or change; each process holds the whole coarse mesh.")
} // namespace Thalweg
