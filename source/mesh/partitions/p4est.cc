#include <thalweg/mesh/mesh_plan.h>

namespace Thalweg
{
  namespace
  {
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
    };
  } // namespace

  THALWEG_REGISTER(MeshPartition,
                   P4est,
                   "p4est",
                   "equal parts of a curve through all cells, for meshes that "
                   "stay or change; each process holds the whole coarse mesh.")
} // namespace Thalweg
