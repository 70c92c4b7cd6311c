// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/blocks.h>
#include <thalweg/mesh/geometries/tools.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace Thalweg
{
  namespace Geometries
  {
    double
    n_graded(const double length, const double first, const double last)
    {
      const double ratio = last / first;
      // The mean over a continuous change from first to last.
      const double mean =
        std::abs(ratio - 1.) < 1e-6 ? first : (last - first) / std::log(ratio);
      return std::max(1., std::round(length / mean));
    }



    std::vector<double>
    graded_lengths(const double length, const double first, const double last)
    {
      const double        ratio = last / first;
      const unsigned int  n     = n_graded(length, first, last);
      std::vector<double> lengths(n);
      for (unsigned int i = 0; i < n; ++i)
        lengths[i] = first * std::pow(ratio, n > 1 ? i / (n - 1.) : 0.);
      const double sum = std::accumulate(lengths.begin(), lengths.end(), 0.);
      for (double &l : lengths)
        l *= length / sum;
      return lengths;
    }



    std::vector<double>
    positions(const double start, const std::vector<double> &lengths)
    {
      std::vector<double> result{start};
      for (const double l : lengths)
        result.push_back(result.back() + l);
      return result;
    }



    std::vector<double>
    geometric_lengths(const double       length,
                      const double       growth,
                      const unsigned int n)
    {
      std::vector<double> lengths(n);
      for (unsigned int i = 0; i < n; ++i)
        lengths[i] = std::pow(growth, i);
      const double sum = std::accumulate(lengths.begin(), lengths.end(), 0.);
      for (double &l : lengths)
        l *= length / sum;
      return lengths;
    }



    std::vector<double>
    geometric_positions(const double       length,
                        const double       first,
                        const unsigned int n)
    {
      // The sum of 1 + q + ... + q^(n-1) grows with q: bisection.
      const auto sum = [n](const double q) {
        double s = 0;
        for (unsigned int i = 0; i < n; ++i)
          s = 1. + q * s;
        return s;
      };
      double low = 0., high = 2. + length / first;
      for (unsigned int i = 0; i < 200 && n > 1; ++i)
        {
          const double q                         = .5 * (low + high);
          (sum(q) * first < length ? low : high) = q;
        }
      std::vector<double> result =
        positions(0., geometric_lengths(length, low, n));
      result.back() = length;
      return result;
    }



    PlaneBlocks::PlaneBlocks(const double tolerance)
      : tolerance(tolerance)
    {}



    unsigned int
    PlaneBlocks::vertex(const dealii::Point<2> &point)
    {
      const double x = std::floor(point[0] / tolerance);
      const double y = std::floor(point[1] / tolerance);
      for (const double i : {x - 1., x, x + 1.})
        for (const double j : {y - 1., y, y + 1.})
          {
            const auto [begin, end] = in_square.equal_range({i, j});
            for (auto entry = begin; entry != end; ++entry)
              if (vertices[entry->second].distance(point) < tolerance)
                return entry->second;
          }
      in_square.emplace(Square(x, y), vertices.size());
      vertices.push_back(point);
      return vertices.size() - 1;
    }



    void
    PlaneBlocks::add_cell(const dealii::Point<2> &a,
                          const dealii::Point<2> &b,
                          const dealii::Point<2> &c,
                          const dealii::Point<2> &d)
    {
      dealii::CellData<2> cell;
      cell.vertices = {vertex(a), vertex(b), vertex(d), vertex(c)};
      cells.push_back(cell);
    }



    void
    PlaneBlocks::add_grid(const std::vector<double> &x,
                          const std::vector<double> &y)
    {
      for (unsigned int j = 1; j < y.size(); ++j)
        for (unsigned int i = 1; i < x.size(); ++i)
          add_cell({x[i - 1], y[j - 1]},
                   {x[i], y[j - 1]},
                   {x[i], y[j]},
                   {x[i - 1], y[j]});
    }



    void
    PlaneBlocks::create(dealii::Triangulation<2> &mesh) const
    {
      mesh.create_triangulation(vertices, cells, dealii::SubCellData());
    }



    template <int dim>
    void
    extrude(const dealii::Triangulation<2> &section,
            const std::vector<double>      &z,
            dealii::Triangulation<dim>     &target,
            const std::string              &what)
    {
      if constexpr (dim == 2)
        {
          (void)z;
          copy_coarse_mesh(section, target, what);
        }
      else
        {
          dealii::Triangulation<3> mesh;
          dealii::GridGenerator::extrude_triangulation(section, z, mesh);
          // deal.II gives front and back the two ids behind all others.
          const auto ids    = section.get_boundary_ids();
          const auto behind = *std::max_element(ids.begin(), ids.end()) + 1;
          for (const auto &face : mesh.active_face_iterators())
            if (face->at_boundary() && face->boundary_id() >= behind)
              face->set_boundary_id(4 + face->boundary_id() - behind);
          copy_coarse_mesh(mesh, target, what);
        }
    }



    template <int dim>
    std::map<std::string, dealii::types::boundary_id>
    sides_and(const std::map<std::string, dealii::types::boundary_id> &names,
              const std::vector<std::string>                          &without)
    {
      auto all = box_sides<dim>();
      for (const std::string &name : without)
        all.erase(name);
      all.insert(names.begin(), names.end());
      return all;
    }



    void
    check_positive(const double       value,
                   const std::string &parameter,
                   const std::string &geometry)
    {
      if (value > 0.)
        return;
      std::ostringstream message;
      message << "The '" << parameter << "' of the geometry '" << geometry
              << "' is " << value << "; it must be greater than zero.";
      AssertThrow(false, dealii::ExcMessage(message.str()));
    }


#define THALWEG_INSTANTIATE_BLOCKS(dim)                                      \
  template void extrude(const dealii::Triangulation<2> &,                    \
                        const std::vector<double> &,                         \
                        dealii::Triangulation<dim> &,                        \
                        const std::string &);                                \
  template std::map<std::string, dealii::types::boundary_id> sides_and<dim>( \
    const std::map<std::string, dealii::types::boundary_id> &,               \
    const std::vector<std::string> &);
    THALWEG_INSTANTIATE_BLOCKS(2)
    THALWEG_INSTANTIATE_BLOCKS(3)
#undef THALWEG_INSTANTIATE_BLOCKS
  } // namespace Geometries
} // namespace Thalweg
