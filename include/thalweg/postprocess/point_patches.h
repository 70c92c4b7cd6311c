// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_point_patches_h
#define thalweg_postprocess_point_patches_h

#include <deal.II/base/data_out_base.h>

#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace Thalweg
{
  /// Points with numbers as deal.II writes them for ParaView.
  template <int dim>
  class PointPatches : public dealii::DataOutInterface<0, dim>
  {
  public:
    using Patch = dealii::DataOutBase::Patch<0, dim>;

    /**
     * @param names of the numbers; dim of one name that follow each other are
     *   a vector
     * @param n points
     */
    PointPatches(const std::vector<std::string> &names, const std::size_t n)
      : names(names)
      , patches(n)
    {}

    /// Says where the i-th point is.
    /// @return its numbers, to be filled with `numbers(k, 0) = `
    dealii::Table<2, float> &
    set(const std::size_t i, const dealii::Point<dim> &place)
    {
      Patch &patch      = patches[i];
      patch.patch_index = i;
      patch.vertices[0] = place;
      patch.data.reinit(names.size(), 1);
      return patch.data;
    }

  private:
    const std::vector<Patch> &
    get_patches() const override
    {
      return patches;
    }

    std::vector<std::string>
    get_dataset_names() const override
    {
      return names;
    }

    std::vector<std::tuple<
      unsigned int,
      unsigned int,
      std::string,
      dealii::DataComponentInterpretation::DataComponentInterpretation>>
    get_nonscalar_data_ranges() const override
    {
      using namespace dealii::DataComponentInterpretation;
      std::vector<std::tuple<unsigned int,
                             unsigned int,
                             std::string,
                             DataComponentInterpretation>>
        vectors;
      for (unsigned int k = 0; k + dim <= names.size(); ++k)
        if (k + 1 < names.size() && names[k] == names[k + 1])
          {
            vectors.emplace_back(k,
                                 k + dim - 1,
                                 names[k],
                                 component_is_part_of_vector);
            k += dim - 1;
          }
      return vectors;
    }

    const std::vector<std::string> names;
    std::vector<Patch>             patches;
  };
} // namespace Thalweg

#endif
