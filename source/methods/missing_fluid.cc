// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/interface/sampled_volume.h>
#include <thalweg/methods/missing_fluid.h>

#include <deal.II/base/mpi.h>

#include <array>

namespace Thalweg
{
  namespace
  {
    template <int dim>
    std::string
    text(const Mesh<dim>   &mesh,
         const Fluids      &fluids,
         const unsigned int missing)
    {
      return "There is no '" + fluids[missing].name +
             "' at the start: 'Initial conditions/Level set' is " +
             (missing == 0 ? "positive" : "negative") +
             " everywhere or nearly so in the mesh, which reaches " +
             mesh.extent() + ". It must be " +
             (missing == 0 ? "negative" : "positive") +
             " where that fluid is. Does the mesh have the same unit, m, and "
             "the same origin?";
    }
  } // namespace



  template <int dim>
  std::string
  missing_fluid(const Population<dim> &population, const Fluids &fluids)
  {
    if (fluids.size() < 2)
      return "";
    std::array<unsigned int, 2> is_there{};
    for (const auto &particle : population.particles())
      is_there[Population<dim>::fluid_of(particle.properties())] = 1;
    const MPI_Comm communicator =
      population.mesh().triangulation().get_communicator();
    for (const unsigned int fluid : {0, 1})
      if (dealii::Utilities::MPI::max(is_there[fluid], communicator) == 0)
        return text(population.mesh(), fluids, fluid);
    return "";
  }



  template <int dim>
  std::string
  missing_fluid(const Mesh<dim>             &mesh,
                const Fluids                &fluids,
                const dealii::Function<dim> &level_set,
                const double                 n_particles)
  {
    if (fluids.size() < 2)
      return "";
    const CellGraph<dim> &graph = mesh.graph();
    double                all   = 0.;
    for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
      all += graph.cell(c).measure;
    const MPI_Comm communicator = mesh.triangulation().get_communicator();
    all = dealii::Utilities::MPI::sum(all, communicator);
    const double first =
      sampled_negative_volume<dim>(graph, level_set, communicator);
    for (const unsigned int fluid : {0, 1})
      if ((fluid == 0 ? first : all - first) * n_particles < all)
        return text(mesh, fluids, fluid);
    return "";
  }



#define THALWEG_INSTANTIATE_MISSING(dim)                                       \
  template std::string missing_fluid(const Population<dim> &, const Fluids &); \
  template std::string missing_fluid(const Mesh<dim> &,                        \
                                     const Fluids &,                           \
                                     const dealii::Function<dim> &,            \
                                     const double);
  THALWEG_INSTANTIATE_MISSING(2)
  THALWEG_INSTANTIATE_MISSING(3)
#undef THALWEG_INSTANTIATE_MISSING
} // namespace Thalweg
