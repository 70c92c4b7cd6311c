#include <thalweg/fields/gather.h>
#include <thalweg/postprocess/cell_access.h>

#include <deal.II/base/mpi.h>

#include <limits>
#include <sstream>

namespace Thalweg
{
  std::string
  length_unit(const unsigned int exponent)
  {
    return exponent == 1 ? "m" : "m^" + std::to_string(exponent);
  }


  template <int dim>
  std::array<double, (1 << dim)>
  cell_level_set(const SolutionView<dim> &solution, const unsigned int cell)
  {
    if (solution.fluids.size() == 2)
      return gather<dim>(solution.level_set, solution.space.nodes(cell));
    std::array<double, (1 << dim)> phi;
    phi.fill(-1.);
    return phi;
  }


  namespace
  {
    /// Finds reference coordinates; returns whether @p point is in the cell.
    template <int dim>
    bool
    find_in_cell(const Mesh<dim>          &mesh,
                 const unsigned int        c,
                 const dealii::Point<dim> &point,
                 dealii::Point<dim>       &xi)
    {
      const double tolerance = 1e-9;
      const auto  &cell      = mesh.graph().cell(c);
      if (cell.axis_parallel)
        {
          for (unsigned int d = 0; d < dim; ++d)
            xi[d] = (point[d] - cell.vertices[0][d]) * cell.inverse_extent[d];
        }
      else
        {
          const auto &iterator = mesh.graph().iterator(c);
          if (!iterator->bounding_box().point_inside(point, 1e-6))
            return false;
          try
            {
              xi = mesh.mapping().transform_real_to_unit_cell(iterator, point);
            }
          catch (const typename dealii::Mapping<dim>::ExcTransformationFailed &)
            {
              // Newton's method may diverge only for points outside.
              return false;
            }
        }
      for (unsigned int d = 0; d < dim; ++d)
        if (!(xi[d] >= -tolerance && xi[d] <= 1. + tolerance))
          return false;
      return true;
    }
  } // namespace


  template <int dim>
  std::vector<LocatedPoint<dim>>
  locate(const Mesh<dim>                       &mesh,
         const std::vector<dealii::Point<dim>> &points,
         const std::string                     &what)
  {
    using Index                           = dealii::types::global_cell_index;
    const Index                    nobody = std::numeric_limits<Index>::max();
    const CellGraph<dim>          &graph  = mesh.graph();
    std::vector<LocatedPoint<dim>> located(points.size());
    std::vector<Index>             candidates(points.size(), nobody);
    for (std::size_t p = 0; p < points.size(); ++p)
      for (unsigned int c = 0; c < graph.n_owned_cells(); ++c)
        if (find_in_cell(mesh, c, points[p], located[p].xi))
          {
            located[p].cell = c;
            candidates[p]   = graph.cell(c).global_index;
            break;
          }

    std::vector<Index> winners(points.size());
    dealii::Utilities::MPI::min(candidates,
                                mesh.triangulation().get_communicator(),
                                winners);
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        if (winners[p] == nobody)
          {
            std::ostringstream message;
            message << what << " (" << points[p]
                    << ") lies outside the mesh; move it inside.";
            AssertThrow(false, dealii::ExcMessage(message.str()));
          }
        located[p].is_here = winners[p] == candidates[p];
      }
    return located;
  }


#define THALWEG_INSTANTIATE_ACCESS(dim)                   \
  template std::array<double, (1 << dim)> cell_level_set( \
    const SolutionView<dim> &, const unsigned int);       \
  template std::vector<LocatedPoint<dim>> locate(         \
    const Mesh<dim> &,                                    \
    const std::vector<dealii::Point<dim>> &,              \
    const std::string &);
  THALWEG_INSTANTIATE_ACCESS(2)
  THALWEG_INSTANTIATE_ACCESS(3)
#undef THALWEG_INSTANTIATE_ACCESS
} // namespace Thalweg
