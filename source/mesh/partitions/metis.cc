// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/mesh_plan.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/fully_distributed_tria.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <map>

namespace Thalweg
{
  namespace
  {
    template <int dim>
    using Description = dealii::TriangulationDescription::Description<dim, dim>;


    /**
     * @brief All cells, as each rank makes them before it keeps its own.
     *
     * p4est refines them, so that they are those of the other partition;
     * deal.II alone would allow larger jumps of the level across the edges of
     * periodic boundaries.
     */
    template <int dim>
    struct Whole
    {
      explicit Whole(MeshPlan<dim> &plan)
        : tria(dealii::Triangulation<dim>::limit_level_difference_at_vertices)
      {
        const auto forest = MeshPlan<dim>::empty_forest(MPI_COMM_SELF);
        plan.create_coarse(*forest);
        plan.refine(*forest);
        tria.copy_triangulation(*forest);
        plan.join_periodic_boundaries(tria);
        tree_of_coarse = forest->get_coarse_cell_to_p4est_tree_permutation();
      }


      /// The cells of this rank among those of @p communicator, and their
      /// neighbours. Coarse cells have the numbers and the order of p4est's
      /// trees, whatever their order in a file.
      Description<dim>
      part(const MPI_Comm communicator)
      {
        dealii::GridTools::partition_triangulation(
          dealii::Utilities::MPI::n_mpi_processes(communicator), tria);
        auto part = dealii::TriangulationDescription::Utilities::
          create_description_from_triangulation(tria, communicator);

        std::map<dealii::types::coarse_cell_id, dealii::CellData<dim>> trees;
        auto &ids = part.coarse_cell_index_to_coarse_cell_id;
        for (unsigned int i = 0; i < ids.size(); ++i)
          trees[tree_of_coarse[ids[i]]] = part.coarse_cells[i];
        unsigned int i = 0;
        for (const auto &[tree, cell] : trees)
          {
            ids[i]               = tree;
            part.coarse_cells[i] = cell;
            ++i;
          }
        for (auto &level : part.cell_infos)
          for (auto &info : level)
            {
              const dealii::CellId id(info.id);
              const auto           children = id.get_child_indices();
              info.id = dealii::CellId(tree_of_coarse[id.get_coarse_cell_id()],
                                       children.size(),
                                       children.data())
                          .template to_binary<dim>();
            }
        return part;
      }

      dealii::Triangulation<dim>                   tria;
      std::vector<dealii::types::global_dof_index> tree_of_coarse;
    };



    /**
     * @brief Faces of ghost cells behind which a cell is missing look like
     * boundaries; lets them have an id of their own.
     * @param description what @p tria was made of: it names all boundary faces
     */
    template <int dim>
    void
    mark_unknown_neighbors(
      dealii::Triangulation<dim> &tria,
      const dealii::TriangulationDescription::Description<dim, dim>
        &description)
    {
      for (const auto &level : description.cell_infos)
        for (const auto &info : level)
          {
            const auto cell =
              tria.create_cell_iterator(dealii::CellId(info.id));
            for (const unsigned int f : cell->face_indices())
              if (cell->face(f)->at_boundary() &&
                  std::none_of(info.boundary_ids.begin(),
                               info.boundary_ids.end(),
                               [&](const auto &id) { return id.first == f; }))
                cell->face(f)->set_boundary_id(unknown_neighbor);
          }
    }


    /// The same for faces of ghost cells at periodic boundaries, when these
    /// are joined.
    template <int dim>
    void
    mark_unknown_neighbors(dealii::Triangulation<dim> &tria,
                           const MeshPlan<dim>        &plan)
    {
      for (const auto &cell : tria.active_cell_iterators())
        if (cell->is_ghost())
          for (const unsigned int f : cell->face_indices())
            if (cell->at_boundary(f) && !cell->has_periodic_neighbor(f))
              for (const PeriodicPair &pair : plan.periodic_pairs())
                if (cell->face(f)->boundary_id() == pair.first ||
                    cell->face(f)->boundary_id() == pair.second)
                  cell->face(f)->set_boundary_id(unknown_neighbor);
    }



    template <int dim>
    class Metis : public MeshPartition<dim>
    {
    public:
      using typename MeshPartition<dim>::Triangulation;

      void
      check() const override
      {
#ifndef DEAL_II_WITH_METIS
        AssertThrow(false,
                    dealii::ExcMessage(
                      "'Partition/Model' is 'metis', but this deal.II was "
                      "built without METIS. Use 'p4est', or another deal.II."));
#endif
      }


      bool
      can_change() const override
      {
        return false;
      }


      std::unique_ptr<Triangulation>
      create(const MPI_Comm communicator, MeshPlan<dim> &plan) const override
      {
        check();
        Whole<dim>         whole(plan);
        const unsigned int n_cells = whole.tria.n_active_cells();
        const unsigned int n_ranks =
          dealii::Utilities::MPI::n_mpi_processes(communicator);
        AssertThrow(n_cells >= n_ranks,
                    dealii::ExcMessage(
                      "The mesh has " + std::to_string(n_cells) +
                      " cells, too few for METIS to give one to each of the " +
                      std::to_string(n_ranks) +
                      " processes. Use fewer processes, or refine the mesh."));
        return part_of(communicator, whole, plan);
      }


      std::unique_ptr<Triangulation>
      create_to_load(const MPI_Comm communicator,
                     MeshPlan<dim> &plan) const override
      {
        return create(communicator, plan);
      }


      /// The cells were made anew: they must be those that were saved.
      void
      load(Triangulation &mesh, const SavedCells &saved) const override
      {
        AssertThrow(saved.n_old_ranks == saved.n_ranks,
                    dealii::ExcMessage(
                      "With 'Partition/Model = metis' a run goes on only on as "
                      "many processes as before: '" +
                      saved.place + "' was written by " +
                      std::to_string(saved.n_old_ranks) + ", and these are " +
                      std::to_string(saved.n_ranks) + "."));
        CellGraph<dim> graph;
        graph.build(mesh);
        const unsigned int differ = curve_cells(graph) == saved.own ? 0 : 1;
        AssertThrow(dealii::Utilities::MPI::max(differ,
                                                mesh.get_communicator()) == 0,
                    dealii::ExcMessage(
                      "The cells of this run, or the processes that have them, "
                      "are not those of '" +
                      saved.place +
                      "'. With 'Partition/Model = metis' a run goes on only "
                      "with the same 'Refinement', and with the same METIS."));
      }

    private:
      /// The cells that belong to this rank and their neighbours.
      static std::unique_ptr<Triangulation>
      part_of(const MPI_Comm       communicator,
              Whole<dim>          &whole,
              const MeshPlan<dim> &plan)
      {
        auto part = std::make_unique<
          dealii::parallel::fullydistributed::Triangulation<dim>>(communicator);
        for (const auto id : whole.tria.get_manifold_ids())
          if (id != dealii::numbers::flat_manifold_id)
            part->set_manifold(id, whole.tria.get_manifold(id));
        const auto description = whole.part(part->get_communicator());
        part->create_triangulation(description);
        mark_unknown_neighbors(*part, description);
        plan.join_periodic_boundaries(*part);
        mark_unknown_neighbors(*part, plan);
        return part;
      }
    };
  } // namespace

  THALWEG_REGISTER(MeshPartition,
                   Metis,
                   "metis",
                   "compact parts of equal size with short borders, for "
                   "unstructured meshes that do not change during the run; "
                   "each process holds its part only.")
} // namespace Thalweg
