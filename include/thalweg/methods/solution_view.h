// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_methods_solution_view_h
#define thalweg_methods_solution_view_h

#include <thalweg/core/offers.h>
#include <thalweg/core/ports.h>
#include <thalweg/core/section.h>
#include <thalweg/methods/flow_view.h>

#include <deal.II/base/exceptions.h>

#include <list>
#include <string>

namespace Thalweg
{
  /// How far a run is.
  struct Moment
  {
    double       time      = 0.; ///< s
    double       time_step = 0.; ///< s; 0 at the start
    unsigned int step      = 0;
    double       end_time  = 0.; ///< s
    bool         last_step = false;
  };



  /// Things that methods have, by the method's name.
  template <typename T>
  class ByName
  {
  public:
    struct Entry
    {
      std::string name; ///< empty: the only method's
      T           object;
    };

    void
    add(const std::string &name, const T &object)
    {
      entries.push_back({name, object});
    }

    /**
     * @brief The one of the method @p name, or the first if that is empty.
     * @param what it is called in the message: "flow"
     * @throws dealii::ExcMessage that says which there are
     */
    const T &
    get(const std::string &name, const std::string &what) const;

    auto
    begin() const
    {
      return entries.begin();
    }

    auto
    end() const
    {
      return entries.end();
    }

  private:
    std::list<Entry> entries;
  };

  /// What is known of a run before it begins.
  template <int dim>
  struct RunOutline
  {
    /// The mesh, or a coarser one of the same domain.
    const Mesh<dim> &mesh;
    /// Whether the mesh fills the domain exactly; a coarse one with curved
    /// sides does not.
    bool                     fills_domain = true;
    ByName<FlowOutline<dim>> flows;
    /// What methods will offer each other.
    Offers offered{};

    /// That of a method, or the first. @throws dealii::ExcMessage
    const FlowOutline<dim> &
    flow(const std::string &method) const
    {
      return flows.get(method, "flow");
    }
  };

  /// The state of a run as those see it who only look.
  template <int dim>
  struct SolutionView
  {
    const Mesh<dim>      &mesh;
    Moment                moment;
    ByName<FlowView<dim>> flows;
    /// What methods offer; nullptr: nothing.
    const Ports *ports = nullptr;

    /// That of a method, or the first. @throws dealii::ExcMessage
    const FlowView<dim> &
    flow(const std::string &method) const
    {
      return flows.get(method, "flow");
    }
  };

  /// Declares the parameter by which @p method is chosen for flow().
  void
  declare_flow_choice(const Section &section, std::string &method);



  template <typename T>
  const T &
  ByName<T>::get(const std::string &name, const std::string &what) const
  {
    std::string all;
    for (const Entry &entry : entries)
      {
        if (name.empty() || entry.name == name)
          return entry.object;
        all += (all.empty() ? "'" : ", '") + entry.name + "'";
      }
    throw dealii::ExcMessage(entries.empty()
                               ? "No method of this run has a " + what + "."
                               : "There is no " + what + " of a method '" +
                                   name + "', but of " + all + ".");
  }
} // namespace Thalweg

#endif
