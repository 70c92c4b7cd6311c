// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/particles/population.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

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
  Population<dim>::keep(const Archive &archive)
  {
    const MPI_Comm communicator = mesh_.triangulation().get_communicator();
    archive.value("first id", first_id);
    std::vector<dealii::types::particle_index> created =
      dealii::Utilities::MPI::all_gather(communicator, n_created);
    const auto n_ranks = created.size();
    archive.value("ids of ranks", created);
    AssertThrow(!created.empty(),
                dealii::ExcMessage("the numbers of its particles are "
                                   "damaged."));
    if (created.size() == n_ranks)
      n_created =
        created[dealii::Utilities::MPI::this_mpi_process(communicator)];
    else // other ranks than those that gave the ids
      reserve_ids_below(first_id +
                        *std::max_element(created.begin(), created.end()) *
                          created.size());
  }


  template <int dim>
  std::vector<std::array<double, 2>>
  Population<dim>::volumes_of_cells() const
  {
    const auto                        &graph = mesh_.graph();
    std::vector<std::array<double, 2>> volumes(graph.n_owned_cells());
    for (unsigned int c = 0; c < volumes.size(); ++c)
      for (const auto &particle :
           particle_handler.particles_in_cell(graph.iterator(c)))
        {
          const auto properties = particle.get_properties();
          volumes[c][fluid_of(properties)] += properties[volume_offset];
        }
    return volumes;
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
