// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/plain_text.h>
#include <thalweg/core/spelling.h>
#include <thalweg/simulation/coupling_list.h>

#include <algorithm>

namespace Thalweg
{
  namespace
  {
    std::string
    section_of(const std::string &coupling)
    {
      return "'Couplings/" + coupling + "'";
    }



    /// That the methods between which a coupling stands can be those.
    void
    check_between(const std::string              &name,
                  const std::vector<std::string> &between,
                  const std::size_t               n_wanted,
                  const std::vector<std::string> &methods)
    {
      const std::string where = "'Couplings/" + name + "/Between'";
      AssertThrow(methods != std::vector<std::string>{""},
                  dealii::ExcMessage(
                    section_of(name) +
                    " stands between methods with names: give them such in "
                    "'Methods/Names', instead of 'Method/Model'."));
      AssertThrow(between.size() == n_wanted,
                  dealii::ExcMessage(
                    where + " has " + std::to_string(between.size()) +
                    " names and must have " + std::to_string(n_wanted) +
                    ", those of methods in 'Methods/Names' with a comma "
                    "between them."));
      for (auto method = between.begin(); method != between.end(); ++method)
        {
          AssertThrow(
            std::find(methods.begin(), methods.end(), *method) != methods.end(),
            dealii::ExcMessage(where + " has '" + excerpt(*method) +
                               "', and the methods in 'Methods/Names' are '" +
                               joined(methods, "', '") + "'" +
                               did_you_mean(nearest(*method, methods))));
          AssertThrow(std::find(between.begin(), method, *method) == method,
                      dealii::ExcMessage(where + " has '" + *method +
                                         "' twice; write the name of another "
                                         "method."));
        }
    }
  } // namespace



  template <int dim>
  void
  CouplingList<dim>::declare(const Section &root, const ParameterFile &input)
  {
    const Section section = root.enter("Couplings");
    section.add("Names",
                names,
                "",
                "Couplings between the methods of `Methods/Names`, with names "
                "of your own: `lift: boussinesq`. Each has a section of its "
                "name in here, and its name stands before its columns in "
                "`statistics.csv`." +
                  Registry<Coupling<dim>>::description(),
                dealii::Patterns::Anything());
    named.make(input.value("Couplings/Names", ""), "Couplings/Names");
    const auto declare_one = [&](const std::string &name,
                                 Coupling<dim>     &coupling) {
      const Section own = section.enter(name);
      own.add("Between",
              between[name],
              "",
              "The names of the methods between which it stands, in the order "
              "in which the description of the coupling has them.");
      coupling.declare_parameters(own);
    };
    for (const auto &instance : named)
      declare_one(instance.name, *instance.object);
    if (!input.is_empty())
      return;
    for (const auto &[model, entry] : Registry<Coupling<dim>>::entries())
      {
        shown.push_back(entry.make());
        declare_one(model, *shown.back());
      }
  }



  template <int dim>
  std::vector<typename CouplingList<dim>::Entry>
  CouplingList<dim>::used() const
  {
    std::vector<Entry> entries;
    for (const auto &instance : named)
      entries.push_back(
        {instance.name, instance.object.get(), between.at(instance.name)});
    return entries;
  }



  template <int dim>
  void
  CouplingList<dim>::check(const std::vector<std::string> &methods,
                           std::vector<std::string>       &faults) const
  {
    for (const Entry &entry : used())
      {
        if (std::find(methods.begin(), methods.end(), entry.name) !=
            methods.end())
          faults.push_back("'Couplings/Names' has the name '" + entry.name +
                           "', which a method in 'Methods/Names' has, too. "
                           "Give the coupling another one.");
        collect_fault(faults, [&]() {
          check_between(entry.name,
                        entry.between,
                        entry.coupling->needs().size(),
                        methods);
        });
        std::vector<std::string> own;
        entry.coupling->check(own);
        for (const std::string &fault : own)
          faults.push_back(entry.name + ": " + fault);
      }
  }



  template <int dim>
  void
  CouplingList<dim>::check_needs(const std::vector<std::string> &methods,
                                 const Offers                   &offers,
                                 std::vector<std::string>       &faults) const
  {
    for (const Entry &entry : used())
      {
        const auto needs = entry.coupling->needs();
        // What is wrong with the names was told already.
        for (std::size_t i = 0;
             i < std::min(needs.size(), entry.between.size());
             ++i)
          if (std::find(methods.begin(), methods.end(), entry.between[i]) !=
              methods.end())
            for (const std::string &thing : needs[i])
              collect_fault(faults, [&]() {
                offers.check({entry.between[i], thing}, section_of(entry.name));
              });
      }
  }



  template <int dim>
  void
  CouplingList<dim>::create(Context         &context_,
                            Mesh<dim>       &mesh,
                            BodyForces<dim> &forces,
                            Ports           &ports)
  {
    context = &context_;
    for (const Entry &entry : used())
      entry.coupling->create({entry.name, *context, mesh, forces, ports},
                             entry.between);
  }



  template <int dim>
  void
  CouplingList<dim>::release()
  {
    for (const Entry &entry : used())
      entry.coupling->release();
  }



  template <int dim>
  void
  CouplingList<dim>::attach()
  {
    for (const Entry &entry : used())
      entry.coupling->attach();
  }



  template <int dim>
  void
  CouplingList<dim>::initialize()
  {
    attach();
    for (const Entry &entry : used())
      entry.coupling->initialize();
  }



  template <int dim>
  void
  CouplingList<dim>::keep(const State<dim> &state)
  {
    for (const Entry &entry : used())
      entry.coupling->keep(state.enter(entry.name + ": coupling"));
  }



  template <int dim>
  void
  CouplingList<dim>::update()
  {
    for (const Entry &entry : used())
      entry.coupling->update();
  }



  template <int dim>
  double
  CouplingList<dim>::change() const
  {
    double largest = 0.;
    for (const Entry &entry : used())
      largest = std::max(largest, entry.coupling->change());
    return largest;
  }



  template <int dim>
  std::vector<std::string>
  CouplingList<dim>::columns() const
  {
    std::vector<std::string> all;
    for (const Entry &entry : used())
      for (const std::string &column : entry.coupling->columns())
        all.push_back(entry.name + ": " + column);
    return all;
  }



  template <int dim>
  void
  CouplingList<dim>::record(const double time)
  {
    for (const Entry &entry : used())
      {
        const Statistics::Group group(context->statistics, entry.name);
        entry.coupling->record(time);
      }
  }



  THALWEG_INSTANTIATE(CouplingList)
} // namespace Thalweg
