// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/registry.h>
#include <thalweg/fields/gather.h>
#include <thalweg/fluid/enriched_matrix.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/trilinos_solver.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Epetra_CrsMatrix.h>


namespace Thalweg
{
  template <int dim>
  EnrichedMatrix<dim>::EnrichedMatrix(
    const NodeSpace<dim>                         &space,
    const BoundaryNodes<dim>                     &boundary,
    const PhaseField<dim>                        &phase,
    const dealii::TrilinosWrappers::SparseMatrix &standard)
    : space(space)
    , boundary(boundary)
    , phase(phase)
    , standard(standard)
    , is_given(space.dependences().n_nodes(), false)
    , star_row(space.dependences().n_nodes(), -1)
    , nodal_row(star_row)
  {
    for (Vector *vector :
         {&nodal_part, &star_part, &nodal_values, &star_values})
      space.initialize_scalar(*vector);
    for (const auto &given : boundary.pressure_nodes())
      is_given[given.node] = true;
    const auto &all = space.dependences().all();
    for (unsigned int first = 0, end = 0; first < all.size(); first = end)
      {
        while (end < all.size() && all[end].node == all[first].node)
          ++end;
        dependences[all[first].node] = {first, end};
      }
  }



  template <int dim>
  EnrichedMatrix<dim>::~EnrichedMatrix() = default;



  template <int dim>
  void
  EnrichedMatrix<dim>::remove_given(Vector &nodal) const
  {
    for (const auto &node : boundary.pressure_nodes())
      if (node.node < nodal.locally_owned_size())
        nodal.local_element(node.node) = 0.;
  }



  template <int dim>
  void
  EnrichedMatrix<dim>::find_masters(const unsigned int   cell,
                                    std::vector<Master> &masters) const
  {
    masters.clear();
    for (unsigned int v = 0; v < n_vertices; ++v)
      {
        const unsigned int node = space.nodes(cell)[v];
        if (!space.is_dependent(node))
          {
            masters.push_back({node, v, 1.});
            continue;
          }
        const auto [first, end] = dependences.at(node);
        for (unsigned int k = first; k < end; ++k)
          {
            const Dependence &entry = space.dependences().all()[k];
            masters.push_back({entry.master, v, entry.weight});
          }
      }
  }



  template <int dim>
  template <typename Visitor>
  void
  EnrichedMatrix<dim>::for_each_entry(const Visitor &visit) const
  {
    std::vector<Master> masters;
    for (const CutCell<dim> &cut : phase.cut_cells())
      if (cut.enriched)
        {
          find_masters(cut.cell, masters);
          for (const Master &a : masters)
            for (const Master &b : masters)
              visit(a.node,
                    b.node,
                    a.weight * b.weight * cut.laplace_star[a.vertex][b.vertex],
                    a.weight * b.weight *
                      cut.star_response[a.vertex][b.vertex]);
        }
  }



  template <int dim>
  void
  EnrichedMatrix<dim>::number_rows()
  {
    for (const unsigned int node : nodes)
      star_row[node] = nodal_row[node] = -1;
    nodes.clear();
    star_part = 0.;
    for_each_entry([this](const unsigned int i,
                          const unsigned int j,
                          const double,
                          const double S) {
      if (i == j)
        star_part.local_element(i) += S;
    });
    star_part.compress(dealii::VectorOperation::add);
    n_rows = 0;
    for (unsigned int n = 0; n < star_part.locally_owned_size(); ++n)
      if (star_part.local_element(n) > 0.)
        {
          nodes.push_back(n);
          star_row[n] = n_rows++;
          if (!is_given[n])
            nodal_row[n] = n_rows++;
        }
  }



  template <int dim>
  void
  EnrichedMatrix<dim>::collect_standard_entries(std::vector<Entry> &entries)
  {
    const Epetra_CrsMatrix &matrix      = standard.trilinos_matrix();
    const auto             &partitioner = *nodal_part.get_partitioner();
    links.clear();
    for (const unsigned int node : nodes)
      if (const int row = nodal_row[node]; row >= 0)
        {
          int     length = 0, *columns = nullptr;
          double *values = nullptr;
          matrix.ExtractMyRowView(matrix.LRID(static_cast<long long>(
                                    partitioner.local_to_global(node))),
                                  length,
                                  values,
                                  columns);
          for (int k = 0; k < length; ++k)
            {
              const dealii::types::global_dof_index column =
                matrix.GCID64(columns[k]);
              if (!partitioner.in_local_range(column))
                continue;
              const unsigned int other = partitioner.global_to_local(column);
              if (nodal_row[other] >= 0)
                entries.push_back({row, nodal_row[other], values[k]});
              else
                links.push_back({row, static_cast<int>(other), values[k]});
            }
        }
  }



  template <int dim>
  void
  EnrichedMatrix<dim>::collect_star_entries(std::vector<Entry> &entries) const
  {
    for_each_entry([&](const unsigned int i,
                       const unsigned int j,
                       const double       L,
                       const double       S) {
      if (star_row[i] < 0 || star_row[j] < 0)
        return; // of another rank
      if (i != j)
        entries.push_back({star_row[i], star_row[j], S});
      if (nodal_row[i] >= 0)
        {
          entries.push_back({nodal_row[i], star_row[j], L});
          entries.push_back({star_row[j], nodal_row[i], L});
        }
    });
    // with what other ranks' cells add
    for (const unsigned int node : nodes)
      entries.push_back(
        {star_row[node], star_row[node], star_part.local_element(node)});
  }



  template <int dim>
  void
  EnrichedMatrix<dim>::update()
  {
    number_rows();
    std::vector<Entry> entries;
    collect_standard_entries(entries);
    collect_star_entries(entries);
    inverse.reset();
    rows.reinit(n_rows);
    solution.reinit(n_rows);
    if (n_rows == 0)
      return;
    dealii::DynamicSparsityPattern dynamic_pattern(n_rows);
    for (const Entry &entry : entries)
      dynamic_pattern.add(entry.row, entry.column);
    dealii::SparsityPattern pattern;
    pattern.copy_from(dynamic_pattern);
    dealii::SparseMatrix<double> sums(pattern);
    for (const Entry &entry : entries)
      sums.add(entry.row, entry.column, entry.value);
    const dealii::IndexSet all = dealii::complete_index_set(n_rows);
    // The solver refers to it.
    block = std::make_unique<dealii::TrilinosWrappers::SparseMatrix>();
    block->reinit(all, all, sums, MPI_COMM_SELF, 0.);
    inverse = std::make_unique<dealii::TrilinosWrappers::SolverDirect>(control);
    inverse->initialize(*block);
  }



  template <int dim>
  void
  EnrichedMatrix<dim>::vmult(EnrichedPressure       &result,
                             const EnrichedPressure &pressure) const
  {
    standard.vmult(nodal(result), nodal(pressure));
    nodal_values.copy_locally_owned_data_from(nodal(pressure));
    star_values.copy_locally_owned_data_from(star(pressure));
    space.interpolate(nodal_values, 1);
    space.interpolate(star_values, 1);
    nodal_part = 0.;
    star_part  = 0.;
    for (const CutCell<dim> &cut : phase.cut_cells())
      if (cut.enriched)
        {
          const auto &at = space.nodes(cut.cell);
          const auto  p  = gather<dim>(nodal_values, at);
          const auto  q  = gather<dim>(star_values, at);
          for (unsigned int i = 0; i < n_vertices; ++i)
            {
              double sum = 0., star_sum = 0.;
              for (unsigned int j = 0; j < n_vertices; ++j)
                {
                  sum += cut.laplace_star[i][j] * q[j];
                  star_sum += cut.laplace_star[j][i] * p[j] +
                              cut.laplace_star_star[i][j] * q[j];
                }
              nodal_part.local_element(at[i]) += sum;
              star_part.local_element(at[i]) += star_sum;
            }
        }
    space.fold(nodal_part, 1);
    space.fold(star_part, 1);
    remove_given(nodal_part);
    nodal(result).add(1., nodal_part);
    star(result).copy_locally_owned_data_from(star_part);
  }



  template <int dim>
  void
  EnrichedMatrix<dim>::read_rows(const EnrichedPressure &load) const
  {
    for (const unsigned int node : nodes)
      {
        rows.local_element(star_row[node]) = star(load).local_element(node);
        if (nodal_row[node] >= 0)
          rows.local_element(nodal_row[node]) = nodal(load).local_element(node);
      }
  }



  template <int dim>
  void
  EnrichedMatrix<dim>::solve_rows() const
  {
    if (n_rows > 0)
      inverse->solve(solution, rows);
  }



  template <int dim>
  void
  EnrichedMatrix<dim>::write_rows(EnrichedPressure &pressure) const
  {
    for (const unsigned int node : nodes)
      {
        star(pressure).local_element(node) =
          solution.local_element(star_row[node]);
        if (nodal_row[node] >= 0)
          nodal(pressure).local_element(node) =
            solution.local_element(nodal_row[node]);
      }
  }



  template <int dim>
  void
  EnrichedMatrix<dim>::invert_beside_interface(
    EnrichedPressure       &pressure,
    const EnrichedPressure &load) const
  {
    pressure = 0.;
    read_rows(load);
    solve_rows();
    write_rows(pressure);
  }



  template <int dim>
  void
  EnrichedMatrix<dim>::precondition(EnrichedPressure        &result,
                                    const EnrichedPressure  &load,
                                    const AmgPreconditioner &amg) const
  {
    read_rows(load);
    solve_rows();
    nodal_part.zero_out_ghost_values();
    nodal_part.copy_locally_owned_data_from(nodal(load));
    for (const Entry &link : links)
      nodal_part.local_element(link.column) -=
        link.value * solution.local_element(link.row);
    for (const unsigned int node : nodes)
      nodal_part.local_element(node) = 0.;
    amg.vmult(nodal(result), nodal_part);
    remove_given(nodal(result));
    read_rows(load);
    for (const Entry &link : links)
      rows.local_element(link.row) -=
        link.value * nodal(result).local_element(link.column);
    solve_rows();
    star(result) = 0.;
    write_rows(result);
  }



  THALWEG_INSTANTIATE(EnrichedMatrix)
} // namespace Thalweg
