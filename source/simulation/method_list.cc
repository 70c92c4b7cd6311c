// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/simulation/method_list.h>

#include <utility>

namespace Thalweg
{
  namespace
  {
    const std::string usual_method = "pfem2";


    /// Appends texts with a prefix to a list.
    void
    append(const std::vector<std::string> &texts,
           const std::string              &prefix,
           std::vector<std::string>       &list)
    {
      for (const std::string &text : texts)
        list.push_back(prefix + text);
    }
  } // namespace



  template <int dim>
  std::vector<typename MethodList<dim>::Entry>
  MethodList<dim>::used() const
  {
    std::vector<Entry> entries;
    for (const auto &instance : named)
      entries.push_back({instance.name, instance.object.get()});
    if (entries.empty())
      entries.push_back({"", &*single});
    return entries;
  }



  template <int dim>
  std::vector<std::string>
  MethodList<dim>::names_of_used() const
  {
    std::vector<std::string> all;
    for (const Entry &entry : used())
      all.push_back(entry.name);
    return all;
  }



  template <int dim>
  void
  MethodList<dim>::declare_choice(const Section       &root,
                                  const ParameterFile &input)
  {
    single.declare_parameters(root.enter("Method"), usual_method, "algorithm");
    single_name = input.value("Method/Model", "");
    root.enter("Methods").add(
      "Names",
      names,
      "",
      "Several methods on one mesh, with names of your own: `water: pfem2, "
      "dye: tracers`. Each has a section of its name in here, with all that it "
      "would have at the top without names, `Fluids` for example, and what "
      "stands in its section of `Method`. They advance in this order, and "
      "their names stand before their columns in `statistics.csv`. Nothing: "
      "there is one method, that of `Method/Model`.",
      dealii::Patterns::Anything());
    named.make(input.value("Methods/Names", ""), "Methods/Names");
  }



  template <int dim>
  void
  MethodList<dim>::declare_sections(const Section &root)
  {
    if (named.empty())
      {
        // Names that are none are refused when the file is read.
        Method<dim> *method = single.find(single_name);
        (method != nullptr ? method : single.find(usual_method))
          ->declare_sections(root);
      }
    for (const auto &instance : named)
      {
        const Section own = root.enter("Methods").enter(instance.name);
        instance.object->declare_parameters(own);
        instance.object->declare_sections(own);
      }
  }



  template <int dim>
  void
  MethodList<dim>::check(std::vector<std::string> &faults) const
  {
    if (!named.empty() && !single_name.empty())
      faults.emplace_back(
        "'Method/Model' is for a run of one method, but "
        "'Methods/Names' is given, too. Leave one of them out.");
    for (const Entry &entry : used())
      {
        std::vector<std::string> own;
        entry.method->check(own);
        append(own, entry.prefix(), faults);
      }
  }



  template <int dim>
  void
  MethodList<dim>::check_on_mesh(const Mesh<dim>          &coarse,
                                 std::vector<std::string> &faults) const
  {
    for (const Entry &entry : used())
      {
        std::vector<std::string> own;
        entry.method->check_on_mesh(coarse, own);
        append(own, entry.prefix(), faults);
      }
  }



  template <int dim>
  void
  MethodList<dim>::check_on_outline(const RunOutline<dim>    &outline,
                                    std::vector<std::string> &faults) const
  {
    for (const Entry &entry : used())
      {
        const std::size_t before = faults.size();
        for (const Need &need : entry.method->needs())
          collect_fault(faults, [&]() {
            outline.offered.check(need,
                                  entry.name.empty()
                                    ? "'Method/Model = " + single.model_name() +
                                        "'"
                                    : "'Methods/" + entry.name + "'");
          });
        std::vector<std::string> own;
        // Without what it needs there is nothing to look at.
        if (faults.size() == before)
          entry.method->check_on_outline(outline, own);
        append(own, entry.prefix(), faults);
      }
  }



  template <int dim>
  std::vector<std::string>
  MethodList<dim>::warnings(const Mesh<dim> &coarse, const double n_cells) const
  {
    std::vector<std::string> all;
    for (const Entry &entry : used())
      for (const std::string &warning : entry.method->warnings(coarse, n_cells))
        if (!warning.empty())
          all.push_back(entry.prefix() + warning);
    return all;
  }



  template <int dim>
  double
  MethodList<dim>::particles_per_cell() const
  {
    double sum = 0.;
    for (const Entry &entry : used())
      sum += entry.method->particles_per_cell();
    return sum;
  }



  template <int dim>
  RunOutline<dim>
  MethodList<dim>::outline(const Mesh<dim> &mesh, const bool fills_domain) const
  {
    RunOutline<dim> outline{mesh, fills_domain, {}};
    for (const Entry &entry : used())
      entry.method->publish(entry.name, outline);
    return outline;
  }



  template <int dim>
  SolutionView<dim>
  MethodList<dim>::view(const Mesh<dim> &mesh, const Moment &moment) const
  {
    SolutionView<dim> solution{mesh, moment, {}, &ports};
    for (const Entry &entry : used())
      entry.method->publish(entry.name, solution);
    return solution;
  }



  template <int dim>
  std::vector<std::string>
  MethodList<dim>::columns() const
  {
    std::vector<std::string> all;
    for (const Entry &entry : used())
      append(entry.method->columns(), entry.prefix(), all);
    return all;
  }



  template <int dim>
  template <typename Words>
  std::string
  MethodList<dim>::say(const Words &words) const
  {
    std::string text;
    for (const Entry &entry : used())
      text +=
        (text.empty() ? "" : "; ") + entry.prefix() + words(*entry.method);
    return text;
  }



  template <int dim>
  std::string
  MethodList<dim>::size() const
  {
    return say([](const Method<dim> &method) { return method.size(); });
  }



  template <int dim>
  std::string
  MethodList<dim>::headline() const
  {
    return say([](const Method<dim> &method) { return method.headline(); });
  }



  THALWEG_INSTANTIATE(MethodList)
} // namespace Thalweg
