// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_particles_face_accounts_h
#define thalweg_particles_face_accounts_h

#include <thalweg/core/archive.h>
#include <thalweg/fields/boundary_nodes.h>
#include <thalweg/particles/volume_books.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Thalweg
{
  /// What a face at the boundary has of its own from step to step.
  struct FaceAccount
  {
    /// Has come in, but not yet filled a particle, m^dim.
    FluidVolumes waiting{};
    /// Has gone out, but was not yet taken from particles; negative if they
    /// took more with them. In m^dim.
    FluidVolumes owed{};
  };

  /**
   * @brief An account for each face of this rank where fluid can pass, which
   * survives changes of the mesh: the faces of new cells share what their
   * parent's face had, and a coarser one has what its parts had.
   */
  template <int dim>
  class FaceAccounts
  {
  public:
    FaceAccounts(const CellGraph<dim>     &graph,
                 const BoundaryNodes<dim> &boundary);

    FaceAccount &
    operator[](const unsigned int face)
    {
      return accounts[face];
    }

    const FaceAccount &
    operator[](const unsigned int face) const
    {
      return accounts[face];
    }

    /// The number of a cell's face among the passable ones.
    unsigned int
    index(const unsigned int cell, const unsigned int face_no) const
    {
      return numbers.at({cell, face_no});
    }

    /// Collective.
    void
    keep(const Archive &archive, const MPI_Comm communicator);

  private:
    void
    distribute(const std::vector<std::string>  &cells,
               const std::vector<unsigned int> &faces,
               const std::vector<double>       &values);

    void
    add_to_relatives(const std::string &cell,
                     const unsigned int face_no,
                     const FaceAccount &account);

    const CellGraph<dim>                                         &graph;
    const BoundaryNodes<dim>                                     &boundary;
    std::vector<FaceAccount>                                      accounts;
    std::map<std::pair<unsigned int, unsigned int>, unsigned int> numbers;
  };
} // namespace Thalweg

#endif
