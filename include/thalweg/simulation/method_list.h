// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_simulation_method_list_h
#define thalweg_simulation_method_list_h

#include <thalweg/core/instances.h>
#include <thalweg/core/parameter_file.h>
#include <thalweg/methods/method.h>

#include <deque>
#include <string>
#include <vector>

namespace Thalweg
{
  /**
   * @brief The methods of a run: those of "Methods/Names" in their order, each
   * with a section of its name, or without names one whose sections stand at
   * the top.
   *
   * Its functions are those of Method, for all of them.
   */
  template <int dim>
  class MethodList
  {
  public:
    struct Entry
    {
      std::string  name; ///< empty: the only one
      Method<dim> *method;

      /// The name with a colon, for what is said of it.
      std::string
      prefix() const
      {
        return name.empty() ? "" : name + ": ";
      }
    };

    /// Those that are used.
    std::vector<Entry>
    used() const;

    /// Their names.
    std::vector<std::string>
    names_of_used() const;

    /// What they offer each other and couplings.
    Ports &
    offers()
    {
      return ports;
    }

    /// Declares "Method" and "Methods/Names", and makes the methods of
    /// @p input. @throws dealii::ExcMessage for names that cannot be
    void
    declare_choice(const Section &root, const ParameterFile &input);

    /// Declares the sections of the methods that are used.
    void
    declare_sections(const Section &root);

    void
    check(std::vector<std::string> &faults) const;

    void
    check_on_mesh(const Mesh<dim>          &coarse,
                  std::vector<std::string> &faults) const;

    /// That they offer what they need of each other, and what is seen when
    /// all are known.
    void
    check_on_outline(const RunOutline<dim>    &outline,
                     std::vector<std::string> &faults) const;

    std::vector<std::string>
    warnings(const Mesh<dim> &coarse, const double n_cells) const;

    double
    particles_per_cell() const;

    RunOutline<dim>
    outline(const Mesh<dim> &mesh, const bool fills_domain) const;

    void
    create(Context &context, Mesh<dim> &mesh, BodyForces<dim> &forces);

    void
    release();

    void
    attach();

    void
    initialize();

    void
    clear();

    void
    keep_constants(const Archive &archive);

    void
    keep(const State<dim> &state);

    void
    update();

    void
    repopulate();

    void
    check_conditions(const double time) const;

    void
    check_conditions_of_step(const double end) const;

    StepNumbers
    step_numbers() const;

    SolutionView<dim>
    view(const Mesh<dim> &mesh, const Moment &moment) const;

    std::vector<std::string>
    columns() const;

    void
    record(const double time);

    std::string
    size() const;

    void
    warn_at_start() const;

    std::string
    headline() const;

  private:
    /// What all say, with their names.
    template <typename Words>
    std::string
    say(const Words &words) const;

    Choice<Method<dim>>    single;
    std::string            single_name; ///< as the input has it
    Instances<Method<dim>> named;
    std::string            names; ///< as they are declared
    Context               *context = nullptr;
    Ports                  ports;
  };
} // namespace Thalweg

#endif
