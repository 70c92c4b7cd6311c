// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_point_patches_h
#define thalweg_postprocess_point_patches_h

#include <deal.II/base/data_out_base.h>

#include <array>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace Thalweg
{
  /**
   * @brief Points or lines with numbers as deal.II writes them for ParaView.
   * @tparam n_corners 1 of a point, 2 of a line
   */
  template <int dim, int n_corners>
  class ShapePatches : public dealii::DataOutInterface<n_corners - 1, dim>
  {
  public:
    using Patch = dealii::DataOutBase::Patch<n_corners - 1, dim>;

    /**
     * @param names of the numbers; dim of one name that follow each other are
     *   a vector
     * @param n points or lines
     */
    ShapePatches(const std::vector<std::string> &names, const std::size_t n)
      : names(names)
      , patches(n)
    {}

  protected:
    /// Says where the i-th of them is.
    /// @return its numbers, of each corner a column
    dealii::Table<2, float> &
    set_corners(const std::size_t                                i,
                const std::array<dealii::Point<dim>, n_corners> &corners)
    {
      Patch &patch      = patches[i];
      patch.patch_index = i;
      for (unsigned int c = 0; c < n_corners; ++c)
        patch.vertices[c] = corners[c];
      patch.data.reinit(names.size(), n_corners);
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



  template <int dim>
  class PointPatches : public ShapePatches<dim, 1>
  {
  public:
    using ShapePatches<dim, 1>::ShapePatches;

    /// Says where the i-th point is.
    /// @return its numbers, to be filled with `numbers(k, 0) = `
    dealii::Table<2, float> &
    set(const std::size_t i, const dealii::Point<dim> &place)
    {
      return this->set_corners(i, {{place}});
    }
  };



  /// Straight lines, each with numbers that are the same along it.
  template <int dim>
  class LinePatches : public ShapePatches<dim, 2>
  {
  public:
    using ShapePatches<dim, 2>::ShapePatches;

    /// Says where the i-th line is, and its numbers.
    void
    set(const std::size_t          i,
        const dealii::Point<dim>  &begin,
        const dealii::Point<dim>  &end,
        const std::vector<double> &numbers)
    {
      auto &table = this->set_corners(i, {{begin, end}});
      for (unsigned int k = 0; k < numbers.size(); ++k)
        table(k, 0) = table(k, 1) = numbers[k];
    }
  };
} // namespace Thalweg

#endif
