// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/plain_text.h>
#include <thalweg/core/spelling.h>
#include <thalweg/simulation/step_scheme.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <set>

namespace Thalweg
{
  namespace
  {
    /// More would be a step that is far too long, or a slip of the pen.
    constexpr unsigned int most_sub_steps = 100000;


    /// Refuses a name that is not among @p names. @param what they are
    void
    check_name(const std::string              &name,
               const std::string              &where,
               const std::vector<std::string> &names,
               const std::string              &what)
    {
      AssertThrow(names != std::vector<std::string>{""},
                  dealii::ExcMessage("'" + where + "' has '" + excerpt(name) +
                                     "', but the only method has no name: give "
                                     "it one in 'Methods/Names', or leave '" +
                                     where + "' out."));
      AssertThrow(std::find(names.begin(), names.end(), name) != names.end(),
                  dealii::ExcMessage("'" + where + "' has '" + excerpt(name) +
                                     "', and the " + what + " are '" +
                                     joined(names, "', '") + "'" +
                                     did_you_mean(nearest(name, names))));
    }



    template <typename List>
    std::vector<std::string>
    names_of(const List &list)
    {
      std::vector<std::string> names;
      names.reserve(list.size());
      for (const auto &item : list)
        names.push_back(item.name);
      return names;
    }
  } // namespace



  template <int dim>
  StepScheme<dim>::StepScheme(const MethodList<dim>   &methods,
                              const CouplingList<dim> &couplings)
    : methods(methods)
    , couplings(couplings)
  {}



  template <int dim>
  void
  StepScheme<dim>::declare_parameters(const Section &root)
  {
    const Section section = root.enter("Scheme");
    section.add("Order",
                order,
                "",
                "The names of all methods and couplings, in the order in which "
                "they make a step. Nothing: methods as `Methods/Names` has "
                "them, each coupling behind the last of its methods.");
    section.add("Sub-steps",
                sub_steps,
                "",
                "In how many equal parts methods make a step at the least: "
                "`sand: 10, water: 2`. Their Courant numbers and the like are "
                "those of a part.",
                dealii::Patterns::Anything());
    section.add("Iterations",
                iterations,
                "",
                "How often a step is made at the most: methods start again "
                "from its beginning, with what the couplings have carried in "
                "the last pass. 1: once.",
                dealii::Patterns::Integer(1, 1000));
    section.add("Tolerance",
                tolerance,
                "",
                "No further iteration is made when what the couplings carry "
                "has changed by less than this part of it.",
                dealii::Patterns::Double(0.));
  }



  template <int dim>
  std::vector<typename StepScheme<dim>::Stage>
  StepScheme<dim>::usual_stages() const
  {
    std::vector<Stage>    all;
    const auto            used = couplings.used();
    std::set<std::string> done;
    for (const auto &entry : methods.used())
      {
        all.push_back({entry.name, entry.method, nullptr});
        done.insert(entry.name);
        for (const auto &candidate : used)
          if (done.count(candidate.name) == 0 &&
              std::all_of(candidate.between.begin(),
                          candidate.between.end(),
                          [&done](const std::string &method) {
                            return done.count(method) > 0;
                          }))
            {
              all.push_back({candidate.name, nullptr, candidate.coupling});
              done.insert(candidate.name);
            }
      }
    return all;
  }



  template <int dim>
  std::vector<typename StepScheme<dim>::Stage>
  StepScheme<dim>::stages() const
  {
    std::vector<Stage> all = usual_stages();
    if (order.empty())
      return all;
    const auto place = [this](const Stage &stage) {
      return std::find(order.begin(), order.end(), stage.name);
    };
    std::sort(all.begin(), all.end(), [&](const Stage &a, const Stage &b) {
      return place(a) < place(b);
    });
    return all;
  }



  template <int dim>
  std::map<std::string, unsigned int>
  StepScheme<dim>::sub_steps_of_methods() const
  {
    std::map<std::string, unsigned int> numbers;
    for (const std::string &item :
         dealii::Utilities::split_string_list(sub_steps, ','))
      {
        const auto   words = dealii::Utilities::split_string_list(item, ':');
        unsigned int n     = 0;
        try
          {
            if (words.size() == 2)
              n = dealii::Utilities::string_to_int(words[1]);
          }
        catch (const dealii::ExceptionBase &)
          {}
        AssertThrow(n >= 1 && n <= most_sub_steps,
                    dealii::ExcMessage(
                      "'Scheme/Sub-steps' has '" + excerpt(item) +
                      "', which is no method and number of parts: write "
                      "'sand: 10', with commas between several, and numbers "
                      "from 1 to " +
                      std::to_string(most_sub_steps) + "."));
        AssertThrow(numbers.emplace(words[0], n).second,
                    dealii::ExcMessage("'Scheme/Sub-steps' has '" +
                                       excerpt(words[0]) +
                                       "' twice; remove one of them."));
      }
    return numbers;
  }



  template <int dim>
  void
  StepScheme<dim>::check_order() const
  {
    const std::vector<std::string> names   = names_of(usual_stages());
    const std::string              parts   = "methods and couplings";
    std::string                    missing = "";
    for (auto name = order.begin(); name != order.end(); ++name)
      {
        check_name(*name, "Scheme/Order", names, parts);
        AssertThrow(std::find(order.begin(), name, *name) == name,
                    dealii::ExcMessage("'Scheme/Order' has '" + *name +
                                       "' twice; remove one of them."));
      }
    for (const std::string &name : names)
      if (!order.empty() &&
          std::find(order.begin(), order.end(), name) == order.end())
        missing += (missing.empty() ? "'" : ", '") + name + "'";
    AssertThrow(missing.empty(),
                dealii::ExcMessage("'Scheme/Order' lacks " + missing +
                                   ": it must have all " + parts + "."));
  }



  template <int dim>
  void
  StepScheme<dim>::check_sub_steps() const
  {
    for (const auto &[name, n] : sub_steps_of_methods())
      check_name(name, "Scheme/Sub-steps", names_of(methods.used()), "methods");
  }



  template <int dim>
  void
  StepScheme<dim>::check(std::vector<std::string> &faults) const
  {
    // Without methods for all couplings the sequence is not known.
    if (usual_stages().size() ==
        methods.used().size() + couplings.used().size())
      collect_fault(faults, [this]() { check_order(); });
    collect_fault(faults, [this]() { check_sub_steps(); });
    if (iterations > 1 && couplings.used().empty())
      faults.push_back("'Scheme/Iterations' is " + std::to_string(iterations) +
                       ", but there is nothing to iterate for: leave it out, "
                       "or add couplings to 'Couplings/Names'.");
  }



  template <int dim>
  StepNumbers
  StepScheme<dim>::step_numbers() const
  {
    const auto  wanted  = sub_steps_of_methods();
    StepNumbers numbers = methods.step_numbers();
    for (StepNumber &number : numbers)
      if (const auto n = wanted.find(number.method); n != wanted.end())
        number.rate /= n->second;
    return numbers;
  }



  template <int dim>
  unsigned int
  StepScheme<dim>::n_sub_steps(const Stage &stage, const double dt) const
  {
    const auto wanted = sub_steps_of_methods();
    const auto n      = wanted.find(stage.name);
    return std::max(stage.method->n_sub_steps(dt),
                    n == wanted.end() ? 1u : n->second);
  }



  template <int dim>
  void
  StepScheme<dim>::make_pass(const double time,
                             const double dt,
                             Statistics  &statistics) const
  {
    const std::vector<Stage> all = stages();
    for (const Stage &stage : all)
      if (stage.method != nullptr)
        {
          const Statistics::Group group(statistics, stage.name);
          stage.method->begin_step(time, dt);
        }
    for (const Stage &stage : all)
      {
        const Statistics::Group group(statistics, stage.name);
        if (stage.coupling != nullptr)
          stage.coupling->transfer(time, dt);
        else
          for (unsigned int k = 0, n = n_sub_steps(stage, dt); k < n; ++k)
            stage.method->advance(time + k * (dt / n), dt / n);
      }
  }



  template <int dim>
  void
  StepScheme<dim>::advance(const double                 time,
                           const double                 dt,
                           Statistics                  &statistics,
                           const std::function<void()> &go_back)
  {
    make_pass(time, dt, statistics);
    for (n_passes = 1; n_passes < iterations && couplings.change() > tolerance;
         ++n_passes)
      {
        go_back();
        make_pass(time, dt, statistics);
      }
  }



  template <int dim>
  void
  StepScheme<dim>::record(Statistics &statistics) const
  {
    if (iterations == 1)
      return;
    statistics.set("passes of the step", n_passes);
    statistics.set("change by the last pass", couplings.change());
  }



  THALWEG_INSTANTIATE(StepScheme)
} // namespace Thalweg
