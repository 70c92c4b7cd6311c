// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fields_state_h
#define thalweg_fields_state_h

#include <thalweg/core/archive.h>
#include <thalweg/fields/carried.h>
#include <thalweg/fields/lagrange_space.h>

#include <memory>
#include <string>
#include <vector>

namespace Thalweg
{
  /// A field that goes along when cells are refined, coarsened, given to
  /// another rank, or saved.
  template <int dim>
  struct CarriedField
  {
    std::string               name;
    const LagrangeSpace<dim> *space;
    Vector                   *vector;
    unsigned int              n_components; ///< 1 or dim
  };

  /// What sits in cells and has a name in a State.
  template <int dim>
  struct NamedCarried
  {
    std::string   name;
    Carried<dim> *carried;
  };

  /**
   * @brief What a part of a simulation keeps from one step to the next:
   * values, fields on the mesh, and what sits in its cells.
   *
   * A part names them once, in one function, and with that is carried from
   * mesh to mesh, restored after a failed step, saved and resumed:
   *
   * @code
   * void Pfem2<dim>::keep(const State<dim> &state)
   * {
   *   state.values().value("flow time", flow_time);
   *   state.field("level set", parts->space, level_set, 1);
   *   state.carry("particles", carried_population);
   * }
   * @endcode
   *
   * On a new mesh parts are made anew first, with zero vectors in the new
   * spaces; then the same function says where the fields go.
   */
  template <int dim>
  class State
  {
  public:
    explicit State(const Archive &values)
      : archive(values)
      , named(std::make_shared<Named>())
    {}

    /// Values that are the same on all ranks.
    const Archive &
    values() const
    {
      return archive;
    }

    /// Names a field. Its vector is ghosted in the layout of @p space and
    /// must stay where it is as long as this state is used.
    void
    field(const std::string        &name,
          const LagrangeSpace<dim> &space,
          Vector                   &vector,
          const unsigned int        n_components) const
    {
      named->fields.push_back({prefix + name, &space, &vector, n_components});
    }

    /// Names what sits in cells. It must stay where it is as long as this
    /// state is used.
    void
    carry(const std::string &name, Carried<dim> &carried) const
    {
      named->carried.push_back({prefix + name, &carried});
    }

    /// For the values and fields of a part that has this name.
    State
    enter(const std::string &name) const
    {
      State part(*this);
      part.archive = archive.enter(name);
      part.prefix += name + "/";
      return part;
    }

    /// For parts whose fields and cells belong to this state, but whose
    /// values are kept in @p other.
    State
    with(const Archive &other) const
    {
      State part(*this);
      part.archive = other;
      return part;
    }

    /// All fields that were named.
    const std::vector<CarriedField<dim>> &
    fields() const
    {
      return named->fields;
    }

    /// All that was named with carry().
    const std::vector<NamedCarried<dim>> &
    carried() const
    {
      return named->carried;
    }

  private:
    struct Named
    {
      std::vector<CarriedField<dim>> fields;
      std::vector<NamedCarried<dim>> carried;
    };

    Archive                archive;
    std::shared_ptr<Named> named;
    std::string            prefix;
  };
} // namespace Thalweg

#endif
