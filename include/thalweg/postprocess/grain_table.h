// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_postprocess_grain_table_h
#define thalweg_postprocess_grain_table_h

#include <thalweg/methods/grain_view.h>
#include <thalweg/postprocess/offered_output.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace Thalweg
{
  /// The grains of all methods that have some, by the methods' names.
  template <int dim>
  std::map<std::string, const GrainView *>
  all_grains(const SolutionView<dim> &solution)
  {
    return solution.ports->template all<const GrainView>("grains");
  }



  /// A table of grains for each method that has some.
  template <int dim>
  class GrainTable : public Postprocessor<dim>
  {
  public:
    /// @param model its name
    explicit GrainTable(const std::string &model)
      : model(model)
    {}

    void
    check(const RunOutline<dim> &outline) const override
    {
      check_offered(outline.offered, "grains", model, "sand: grains");
    }

  protected:
    /// Begins the table of a method.
    void
    open(Context                        &context,
         const std::string              &method,
         const std::vector<std::string> &columns)
    {
      std::string name = file_name_of(method, "grains") + "_" + model;
      std::replace(name.begin(), name.end(), ' ', '_');
      tables[method].open(context, name + ".csv", columns);
    }

    TablesOfMethods tables;

  private:
    const std::string model;
  };
} // namespace Thalweg

#endif
