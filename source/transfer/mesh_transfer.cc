// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/lagrange_shape.h>
#include <thalweg/particles/sub_cell.h>
#include <thalweg/transfer/mesh_transfer.h>

#include <cmath>

namespace Thalweg
{
  namespace
  {
    template <int dim>
    std::vector<std::string>
    names_of(const std::vector<NamedCarried<dim>> &carried)
    {
      std::vector<std::string> names;
      names.reserve(carried.size());
      for (const auto &[name, item] : carried)
        names.push_back(name);
      return names;
    }



    /// The number of the node of Lagrange elements at @p unit.
    template <int dim>
    unsigned int
    node_at(const dealii::Point<dim> &unit, const unsigned int degree)
    {
      unsigned int node = 0;
      for (unsigned int d = dim; d-- > 0;)
        node = node * (degree + 1) + std::lround(unit[d] * degree);
      return node;
    }

    /// The value at @p unit of a field with the nodal values
    /// `values[stride * node]`.
    template <int dim, unsigned int degree>
    double
    value_at(const dealii::Point<dim> &unit,
             const double             *values,
             const unsigned int        stride)
    {
      const auto shape = LagrangeShape::values<dim, degree>(unit);
      double     sum   = 0.;
      for (unsigned int i = 0; i < shape.size(); ++i)
        sum += shape[i] * values[stride * i];
      return sum;
    }

    template <int dim>
    double
    value_at(const unsigned int        degree,
             const dealii::Point<dim> &unit,
             const double             *values,
             const unsigned int        stride)
    {
      return degree == 1 ? value_at<dim, 1>(unit, values, stride)
                         : value_at<dim, 2>(unit, values, stride);
    }
  } // namespace



  template <int dim>
  void
  MeshTransfer<dim>::take(const State<dim> &state)
  {
    fields = state.fields();
    values.clear();
    names.clear();
    n_values.clear();
    values.reserve(fields.size()); // copies of vectors lose ghost values
    for (const auto &field : fields)
      {
        values.push_back(*field.vector);
        values.back().update_ghost_values();
        names.push_back(field.name);
        n_values.push_back(field.space->n_nodes_per_cell() *
                           field.n_components);
      }
    carried          = state.carried();
    names_of_carried = names_of(carried);
    for (const auto &[name, item] : carried)
      item->save();
  }



  template <int dim>
  void
  MeshTransfer<dim>::pack(const State<dim> &state)
  {
    take(state);
    for (const auto &[name, item] : carried)
      item->clear();
    handle = mesh.triangulation().register_data_attach(
      [this](const CellIterator &cell, const auto status) {
        return pack_cell(cell, Compat::fate<dim>(status));
      },
      true);
  }



  template <int dim>
  void
  MeshTransfer<dim>::keep(const Archive &archive)
  {
    archive.value("names", names);
    archive.value("values of a cell", n_values);
    archive.value("carried", names_of_carried);
  }



  template <int dim>
  CarriedField<dim>
  MeshTransfer<dim>::find(const State<dim> &state, const std::string &name)
  {
    for (const auto &field : state.fields())
      if (field.name == name)
        return field;
    return {name, nullptr, nullptr, 0};
  }



  template <int dim>
  typename MeshTransfer<dim>::Bytes
  MeshTransfer<dim>::pack_cell(const CellIterator    &cell,
                               const Compat::CellFate fate) const
  {
    const CellGraph<dim> &graph        = mesh.graph();
    const bool            is_coarsened = fate == Compat::CellFate::is_coarsened;
    Bytes                 bytes;
    for (unsigned int k = 0; k < fields.size(); ++k)
      for (unsigned int i = 0; i < fields[k].space->n_nodes_per_cell(); ++i)
        {
          const auto  &field  = fields[k];
          unsigned int place  = i;
          CellIterator source = cell;
          if (is_coarsened)
            {
              // A node of the parent is one of the child that covers it.
              const auto &unit  = field.space->unit_nodes()[i];
              const auto  child = sub_cell<dim>(unit);
              source            = cell->child(child);
              place             = node_at<dim>(from_parent<dim>(unit, child),
                                   field.space->degree());
            }
          const unsigned int node =
            field.space->nodes(graph.index(source))[place];
          for (unsigned int d = 0; d < field.n_components; ++d)
            append_plain(bytes,
                         values[k].local_element(field.n_components * node +
                                                 d));
        }
    for (const auto &[name, item] : carried)
      item->pack(cell, fate, bytes);
    return bytes;
  }



  template <int dim>
  void
  MeshTransfer<dim>::set_nodes(const CarriedField<dim>   &field,
                               const unsigned int         cell,
                               const std::vector<double> &values) const
  {
    const unsigned int *nodes = field.space->nodes(cell);
    const unsigned int  n     = field.n_components;
    for (unsigned int i = 0; i < field.space->n_nodes_per_cell(); ++i)
      if (nodes[i] < field.space->n_owned_nodes())
        for (unsigned int d = 0; d < n; ++d)
          field.vector->local_element(n * nodes[i] + d) = values[n * i + d];
  }



  template <int dim>
  void
  MeshTransfer<dim>::unpack_field(const CarriedField<dim>   &field,
                                  const CellIterator        &cell,
                                  const Compat::CellFate     fate,
                                  const std::vector<double> &values) const
  {
    const CellGraph<dim> &graph = mesh.graph();
    if (fate != Compat::CellFate::is_refined)
      return set_nodes(field, graph.index(cell), values);
    const unsigned int  n = field.n_components;
    std::vector<double> inside(values.size());
    for (unsigned int c = 0; c < cell->n_children(); ++c)
      {
        for (unsigned int i = 0; i < field.space->n_nodes_per_cell(); ++i)
          for (unsigned int d = 0; d < n; ++d)
            inside[n * i + d] =
              value_at<dim>(field.space->degree(),
                            to_parent<dim>(field.space->unit_nodes()[i], c),
                            &values[d],
                            n);
        set_nodes(field, graph.index(cell->child(c)), inside);
      }
  }



  template <int dim>
  void
  MeshTransfer<dim>::unpack_cell(const CellIterator    &cell,
                                 const Compat::CellFate fate,
                                 const char            *bytes,
                                 const std::size_t      size)
  {
    PlainReader reader(bytes, size);
    for (unsigned int k = 0; k < fields.size(); ++k)
      {
        AssertThrow(n_values[k] <= reader.left() / sizeof(double),
                    dealii::ExcMessage("its cells are cut short"));
        std::vector<double> values(n_values[k]);
        for (double &value : values)
          reader.read(value);
        if (fields[k].vector != nullptr)
          unpack_field(fields[k], cell, fate, values);
      }
    for (const auto &[name, item] : carried)
      item->unpack(cell, fate, reader);
    AssertThrow(reader.left() == 0,
                dealii::ExcMessage("its cells hold more than they should"));
  }



  template <int dim>
  void
  MeshTransfer<dim>::begin_to_unpack(const State<dim> &state)
  {
    fields.clear();
    for (const std::string &name : names)
      fields.push_back(find(state, name));
    for (const auto &field : state.fields())
      field.vector->zero_out_ghost_values();
    carried = state.carried();
    AssertThrow(names_of(carried) == names_of_carried,
                dealii::ExcMessage("what sits in its cells is of another "
                                   "kind than in this run."));
    for (const auto &[name, item] : carried)
      item->begin_to_unpack();
  }



  template <int dim>
  void
  MeshTransfer<dim>::unpack(const State<dim> &state)
  {
    begin_to_unpack(state);
    mesh.triangulation().notify_ready_to_unpack(handle,
                                                [this](const CellIterator &cell,
                                                       const auto       status,
                                                       const ByteRange &bytes) {
                                                  if (!bytes.empty())
                                                    unpack_cell(
                                                      cell,
                                                      Compat::fate<dim>(status),
                                                      &*bytes.begin(),
                                                      bytes.size());
                                                });
    end_to_unpack(state);
  }



  template <int dim>
  void
  MeshTransfer<dim>::end_to_unpack(const State<dim> &state)
  {
    for (const auto &field : state.fields())
      field.space->interpolate(*field.vector, field.n_components);
    for (const auto &[name, item] : carried)
      item->end_to_unpack();
    carried.clear();
    fields.clear();
    values.clear();
  }



  THALWEG_INSTANTIATE(MeshTransfer)
} // namespace Thalweg
