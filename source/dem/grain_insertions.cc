// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/instances.h>
#include <thalweg/core/registry.h>
#include <thalweg/dem/grain_insertions.h>

#include <deal.II/base/utilities.h>

namespace Thalweg
{
  namespace
  {
    /// "coarse, fine", checked as names of sections.
    std::vector<std::string>
    names_in(const std::string &list)
    {
      const std::string what = "grains";
      std::string       instances;
      for (const std::string &name :
           dealii::Utilities::split_string_list(list, ','))
        instances += (instances.empty() ? "" : ", ") + name + ": " + what;
      std::vector<std::string> names;
      for (const auto &[name, model] :
           parse_instances(instances, "Insertion/Names", {what}))
        names.push_back(name);
      return names;
    }
  } // namespace



  template <int dim>
  void
  GrainInsertions<dim>::declare_parameters(const Section &section)
  {
    section.add("Names",
                list,
                "",
                "Where grains come in in several ways, of several materials or "
                "sizes: names of your own, `coarse, fine`. Each has a section "
                "of its name in here, with what is said of this one, and one "
                "comes after the other.",
                dealii::Patterns::Anything());
    const std::vector<std::string> names = names_in(section.given("Names", ""));
    // Parameters stay where they are from now on.
    insertions.resize(std::max<std::size_t>(1, names.size()));
    if (names.empty())
      insertions[0].declare_parameters(section, "Insertion", 0);
    for (unsigned int i = 0; i < names.size(); ++i)
      insertions[i].declare_parameters(section.enter(names[i]),
                                       "Insertion/" + names[i],
                                       i);
  }



  template <int dim>
  void
  GrainInsertions<dim>::check(const GrainMaterials &materials) const
  {
    for (const GrainInsertion<dim> &insertion : insertions)
      insertion.check(materials);
  }



  template <int dim>
  void
  GrainInsertions<dim>::check_on_mesh(const Mesh<dim> &mesh) const
  {
    for (const GrainInsertion<dim> &insertion : insertions)
      insertion.check_on_mesh(mesh);
  }



  THALWEG_INSTANTIATE(GrainInsertions)
} // namespace Thalweg
