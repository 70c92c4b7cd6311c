// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/compat.h>
#include <thalweg/postprocess/flow_access.h>
#include <thalweg/postprocess/surface.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <map>

namespace Thalweg
{
  template <int dim>
  void
  Load<dim>::add(const dealii::Tensor<1, dim> &lever,
                 const dealii::Tensor<1, dim> &additional_force)
  {
    force += additional_force;
    if constexpr (dim == 2)
      moment[0] +=
        lever[0] * additional_force[1] - lever[1] * additional_force[0];
    else
      moment += cross_product_3d(lever, additional_force);
  }


  namespace
  {
    /// The flow at the points of one face after another.
    template <int dim>
    class FaceEvaluation
    {
    public:
      FaceEvaluation(const FlowFields<dim> &flow, const unsigned int n_points)
        : flow(flow)
        , quadrature(n_points)
        , velocity(flow.mapping,
                   flow.velocity_dofs.get_fe(),
                   quadrature,
                   dealii::update_values | dealii::update_gradients |
                     dealii::update_JxW_values |
                     dealii::update_quadrature_points |
                     dealii::update_normal_vectors)
        , pressure(flow.mapping,
                   flow.pressure_dofs.get_fe(),
                   quadrature,
                   dealii::update_values)
        , gradients(quadrature.size())
        , pressures(quadrature.size())
        , tractions(quadrature.size())
        , points(quadrature.size())
      {}


      const std::vector<SurfacePoint<dim>> &
      evaluate(
        const typename dealii::DoFHandler<dim>::active_cell_iterator &cell,
        const unsigned int                                            f)
      {
        velocity.reinit(cell, f);
        pressure.reinit(Compat::on_dof_handler(cell, flow.pressure_dofs), f);
        const dealii::FEValuesExtractors::Vector extractor(0);
        velocity[extractor].get_function_gradients(flow.velocity, gradients);
        const bool is_known = has_traction(flow);
        if (is_known)
          velocity[extractor].get_function_values(*flow.traction, tractions);
        pressure.get_function_values(flow.pressure, pressures);
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            const dealii::Tensor<1, dim> normal = velocity.normal_vector(q);
            const dealii::Tensor<1, dim> viscous =
              -flow.viscosity *
              ((gradients[q] + transpose(gradients[q])) * normal);
            points[q] = {velocity.quadrature_point(q),
                         normal,
                         velocity.JxW(q),
                         pressures[q],
                         viscous,
                         is_known ? tractions[q] : viscous};
          }
        return points;
      }

    private:
      const FlowFields<dim>              &flow;
      const dealii::QGauss<dim - 1>       quadrature;
      dealii::FEFaceValues<dim>           velocity;
      dealii::FEFaceValues<dim>           pressure;
      std::vector<dealii::Tensor<2, dim>> gradients;
      std::vector<double>                 pressures;
      std::vector<dealii::Tensor<1, dim>> tractions;
      std::vector<SurfacePoint<dim>>      points;
    };


    template <int dim>
    void
    sum_over_ranks(Load<dim> &load, const MPI_Comm communicator)
    {
      load.force  = dealii::Utilities::MPI::sum(load.force, communicator);
      load.moment = dealii::Utilities::MPI::sum(load.moment, communicator);
    }


    /// The cells at the boundary, ghosts too, in an order that does not tell
    /// how the mesh came about: sums over them have the same bits in a run
    /// that was resumed.
    template <int dim>
    std::vector<typename dealii::DoFHandler<dim>::active_cell_iterator>
    cells_at_boundary(const dealii::DoFHandler<dim> &dofs)
    {
      std::map<dealii::CellId,
               typename dealii::DoFHandler<dim>::active_cell_iterator>
        cells;
      for (const auto &cell : dofs.active_cell_iterators())
        if (!cell->is_artificial() && cell->at_boundary())
          cells.emplace(cell->id(), cell);
      std::vector<typename dealii::DoFHandler<dim>::active_cell_iterator>
        result;
      result.reserve(cells.size());
      for (const auto &[id, cell] : cells)
        result.push_back(cell);
      return result;
    }
  } // namespace


  template <int dim>
  void
  visit_surface(const FlowFields<dim>                      &flow,
                const std::set<dealii::types::boundary_id> &ids,
                const unsigned int                          n_points,
                const std::function<void(
                  const typename dealii::Triangulation<dim>::face_iterator &,
                  const dealii::types::boundary_id,
                  const std::vector<SurfacePoint<dim>> &)> &visit)
  {
    FaceEvaluation<dim> evaluation(flow, n_points);
    for (const auto &cell : cells_at_boundary(flow.velocity_dofs))
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f) &&
              ids.count(cell->face(f)->boundary_id()) > 0)
            visit(cell->face(f),
                  cell->face(f)->boundary_id(),
                  evaluation.evaluate(cell, f));
  }


  template <int dim>
  StressLoads<dim>
  integrate_stresses(const FlowFields<dim>                      &flow,
                     const std::set<dealii::types::boundary_id> &ids,
                     const dealii::Point<dim>                   &center)
  {
    StressLoads<dim> loads;
    visit_surface<dim>(flow,
                       ids,
                       flow.velocity_dofs.get_fe().degree + 2,
                       [&](const auto &, const auto, const auto &points) {
                         for (const auto &point : points)
                           {
                             const auto lever = point.position - center;
                             loads.pressure.add(lever,
                                                point.weight * point.pressure *
                                                  point.normal);
                             loads.viscous.add(lever,
                                               point.weight * point.viscous);
                           }
                       });
    const MPI_Comm communicator = flow.velocity_dofs.get_communicator();
    sum_over_ranks(loads.pressure, communicator);
    sum_over_ranks(loads.viscous, communicator);
    return loads;
  }


  template <int dim>
  Load<dim>
  sum_reactions(const FlowFields<dim>                      &flow,
                const std::set<dealii::types::boundary_id> &ids,
                const dealii::Point<dim>                   &center)
  {
    const auto       &dofs  = flow.velocity_dofs;
    const auto       &fe    = dofs.get_fe();
    const auto       &owned = dofs.locally_owned_dofs();
    std::vector<bool> seen(owned.n_elements(), false);
    std::vector<dealii::types::global_dof_index> indices(fe.dofs_per_cell);
    Load<dim>                                    load;
    // Ghost cells too: an owned node may be on a face of such a cell only.
    for (const auto &cell : cells_at_boundary(dofs))
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f) && ids.count(cell->face(f)->boundary_id()) > 0)
          {
            cell->get_dof_indices(indices);
            for (unsigned int i = 0; i < indices.size(); ++i)
              {
                if (!fe.has_support_on_face(i, f) ||
                    !owned.is_element(indices[i]))
                  continue;
                const auto n = owned.index_within_set(indices[i]);
                if (seen[n])
                  continue;
                seen[n] = true;
                dealii::Tensor<1, dim> force;
                force[fe.system_to_component_index(i).first] =
                  (*flow.reaction)(indices[i]);
                load.add(flow.mapping.transform_unit_to_real_cell(
                           cell, fe.unit_support_point(i)) -
                           center,
                         force);
              }
          }
    sum_over_ranks(load, dofs.get_communicator());
    return load;
  }


#define THALWEG_INSTANTIATE_SURFACE(dim)                               \
  template struct Load<dim>;                                           \
  template void visit_surface(                                         \
    const FlowFields<dim> &,                                           \
    const std::set<dealii::types::boundary_id> &,                      \
    const unsigned int,                                                \
    const std::function<                                               \
      void(const typename dealii::Triangulation<dim>::face_iterator &, \
           const dealii::types::boundary_id,                           \
           const std::vector<SurfacePoint<dim>> &)> &);                \
  template StressLoads<dim> integrate_stresses(                        \
    const FlowFields<dim> &,                                           \
    const std::set<dealii::types::boundary_id> &,                      \
    const dealii::Point<dim> &);                                       \
  template Load<dim> sum_reactions(                                    \
    const FlowFields<dim> &,                                           \
    const std::set<dealii::types::boundary_id> &,                      \
    const dealii::Point<dim> &);
  THALWEG_INSTANTIATE_SURFACE(2)
  THALWEG_INSTANTIATE_SURFACE(3)
#undef THALWEG_INSTANTIATE_SURFACE
} // namespace Thalweg
