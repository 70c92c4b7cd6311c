// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_dem_grain_insertions_h
#define thalweg_dem_grain_insertions_h

#include <thalweg/dem/grain_insertion.h>

#include <string>
#include <vector>

namespace Thalweg
{
  /// All ways in which grains of a method come in: the section "Insertion"
  /// itself, or those in it that have names, one after the other.
  template <int dim>
  class GrainInsertions
  {
  public:
    /// @throws dealii::ExcMessage for names that cannot be
    void
    declare_parameters(const Section &section);

    /// @throws dealii::ExcMessage for what cannot be
    void
    check(const GrainMaterials &materials) const;

    /// The same for what is seen on the mesh.
    void
    check_on_mesh(const Mesh<dim> &mesh) const;

    const std::vector<GrainInsertion<dim>> &
    all() const
    {
      return insertions;
    }

    /// As the user wrote them.
    const std::string &
    names() const
    {
      return list;
    }

  private:
    std::string                      list;
    std::vector<GrainInsertion<dim>> insertions;
  };
} // namespace Thalweg

#endif
