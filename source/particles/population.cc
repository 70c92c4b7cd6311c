#include <thalweg/core/registry.h>
#include <thalweg/particles/population.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace Thalweg
{
  template <int dim>
  Population<dim>::Population(const Mesh<dim> &mesh)
    : mesh_(mesh)
    , particle_handler(mesh.triangulation(), mesh.mapping(), n_properties)
  {}


  template <int dim>
  dealii::types::particle_index
  Population<dim>::next_id()
  {
    using Index                 = dealii::types::particle_index;
    const MPI_Comm communicator = mesh_.triangulation().get_communicator();

    const std::uint64_t id =
      first_id +
      std::uint64_t(n_created) *
        dealii::Utilities::MPI::n_mpi_processes(communicator) +
      dealii::Utilities::MPI::this_mpi_process(communicator);
    AssertThrow(id < std::numeric_limits<Index>::max(),
                dealii::ExcMessage(
                  "The run has created more particles than this deal.II has "
                  "numbers for. Use a deal.II with 64-bit indices, or restart "
                  "with fewer particles a cell."));
    ++n_created;
    return id;
  }


  template <int dim>
  void
  Population<dim>::reserve_ids_below(
    const dealii::types::particle_index first_free)
  {
    first_id  = first_free;
    n_created = 0;
  }


  template <int dim>
  void
  Population<dim>::reserve_used_ids()
  {
    dealii::types::particle_index first_free = 0;
    for (const auto &particle : particle_handler)
      first_free = std::max(first_free, particle.get_id() + 1);
    reserve_ids_below(
      dealii::Utilities::MPI::max(first_free,
                                  mesh_.triangulation().get_communicator()));
  }


  template <int dim>
  dealii::types::particle_index
  Population<dim>::n_global_particles() const
  {
    return dealii::Utilities::MPI::sum(
      particle_handler.n_locally_owned_particles(),
      mesh_.triangulation().get_communicator());
  }
} // namespace Thalweg

THALWEG_INSTANTIATE(Thalweg::Population)
