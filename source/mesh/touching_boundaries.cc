// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/boundary_name.h>
#include <thalweg/mesh/cell_graph.h>
#include <thalweg/mesh/touching_boundaries.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace Thalweg
{
  namespace
  {
    /// Faces lie on each other if they are nearer than this part of their
    /// size.
    constexpr double relative_tolerance = 1e-6;



    /// A face at the end of the mesh.
    template <int dim>
    struct EndFace
    {
      static constexpr unsigned int n_vertices = 1 << (dim - 1);

      /// Corners, around the face.
      std::array<dealii::Point<dim>, n_vertices> corners;
      std::array<unsigned int, n_vertices>       vertices; ///< of the mesh
      dealii::Point<dim>                         center;
      dealii::Tensor<1, dim>                     normal; ///< outward
      double                                     tolerance;
      dealii::types::boundary_id                 id;
    };



    dealii::Tensor<1, 2>
    normal_of(const EndFace<2> &face)
    {
      return cross_product_2d(face.corners[1] - face.corners[0]);
    }



    dealii::Tensor<1, 3>
    normal_of(const EndFace<3> &face)
    {
      return cross_product_3d(face.corners[2] - face.corners[0],
                              face.corners[3] - face.corners[1]);
    }



    template <int dim>
    std::vector<EndFace<dim>>
    end_faces(const dealii::Triangulation<dim> &coarse)
    {
      std::vector<EndFace<dim>> faces;
      for (const auto &cell : coarse.cell_iterators_on_level(0))
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f) && !cell->has_periodic_neighbor(f))
            {
              EndFace<dim> face;
              for (unsigned int v = 0; v < face.n_vertices; ++v)
                {
                  face.corners[v]  = cell->face(f)->vertex(v ^ (v >> 1));
                  face.vertices[v] = cell->face(f)->vertex_index(v ^ (v >> 1));
                }
              dealii::Tensor<1, dim> sum;
              for (const auto &corner : face.corners)
                sum += corner - face.corners[0];
              face.center = face.corners[0] + sum / double(face.n_vertices);
              face.normal = normal_of(face);
              face.normal /= face.normal.norm();
              if (face.normal * (face.center - cell->center()) < 0.)
                face.normal *= -1.;
              face.tolerance = relative_tolerance * cell->face(f)->diameter() +
                               coordinate_round_off(face.center);
              face.id = cell->face(f)->boundary_id();
              faces.push_back(face);
            }
      return faces;
    }



    bool
    is_beside(const EndFace<2> &face, const dealii::Point<2> &x)
    {
      const auto edge = face.corners[1] - face.corners[0];
      const auto part = (x - face.corners[0]) * edge / edge.norm_square();
      return part > 0. && part < 1.;
    }



    bool
    is_beside(const EndFace<3> &face, const dealii::Point<3> &x)
    {
      const auto around = normal_of(face);
      for (unsigned int v = 0; v < 4; ++v)
        {
          const auto &a = face.corners[v], &b = face.corners[(v + 1) % 4];
          if (cross_product_3d(b - a, x - a) * around <= 0.)
            return false;
        }
      return true;
    }



    /// Whether the middle of @p face lies on @p other from the other side.
    template <int dim>
    bool
    lies_on(const EndFace<dim> &face, const EndFace<dim> &other)
    {
      const double tolerance = std::max(face.tolerance, other.tolerance);
      return face.normal * other.normal < -.5 &&
             (face.center.distance(other.center) < tolerance ||
              (std::abs((face.center - other.center) * other.normal) <
                 tolerance &&
               is_beside(other, face.center)));
    }



    /// The faces that lie on others, both the larger and the smaller ones, by
    /// their indices: for each one those that lie on it.
    template <int dim>
    std::map<unsigned int, std::set<unsigned int>>
    touching_faces(const std::vector<EndFace<dim>> &faces)
    {
      using Entry = std::pair<dealii::BoundingBox<dim>, unsigned int>;
      std::vector<Entry> entries;
      for (unsigned int i = 0; i < faces.size(); ++i)
        {
          dealii::BoundingBox<dim> box(
            std::vector<dealii::Point<dim>>(faces[i].corners.begin(),
                                            faces[i].corners.end()));
          box.extend(faces[i].tolerance);
          entries.emplace_back(box, i);
        }
      const auto tree = dealii::pack_rtree(entries);
      std::map<unsigned int, std::set<unsigned int>> touching;
      for (unsigned int i = 0; i < faces.size(); ++i)
        {
          std::vector<Entry> near;
          tree.query(boost::geometry::index::intersects(faces[i].center),
                     std::back_inserter(near));
          for (const auto &[box, j] : near)
            if (j != i && lies_on(faces[i], faces[j]))
              {
                touching[i];
                touching[j].insert(i);
              }
        }
      return touching;
    }


    /// Whether the @p smaller faces that lie on @p face share all its nodes.
    template <int dim>
    bool
    has_hanging_node(const std::vector<EndFace<dim>> &faces,
                     const EndFace<dim>              &face,
                     const std::set<unsigned int>    &smaller)
    {
      std::set<unsigned int> nodes;
      for (const unsigned int i : smaller)
        nodes.insert(faces[i].vertices.begin(), faces[i].vertices.end());
      return std::all_of(face.vertices.begin(),
                         face.vertices.end(),
                         [&nodes](const unsigned int node) {
                           return nodes.count(node) > 0;
                         });
    }
  } // namespace



  template <int dim>
  std::string
  touching_boundaries(const dealii::Triangulation<dim> &coarse,
                      const BoundaryNames              &names)
  {
    const auto faces    = end_faces(coarse);
    const auto touching = touching_faces(faces);
    if (touching.empty())
      return "";
    std::set<dealii::types::boundary_id> ids;
    for (const auto &[i, others] : touching)
      ids.insert(faces[i].id);
    std::ostringstream text;
    text.precision(10);
    text << touching.size() << " boundary faces of the coarse mesh (";
    std::string separator;
    for (const auto id : ids)
      {
        text << separator << "'" << boundary_name(names, id) << "'";
        separator = ", ";
      }
    text << ") lie on each other, the first at ("
         << faces[touching.begin()->first].center
         << "). Nothing flows through there. If it is not meant to be a thin "
            "wall, merge the nodes of the mesh (in Gmsh: 'Coherence;' for the "
            "geometry or 'Coherence Mesh;').";
    return text.str();
  }



  template <int dim>
  void
  refuse_doubled_nodes(const dealii::Triangulation<dim> &coarse,
                       const std::string                &what)
  {
    const auto         faces    = end_faces(coarse);
    const auto         touching = touching_faces(faces);
    std::ostringstream why;
    why.precision(10);
    for (const auto &[i, smaller] : touching)
      if (why.str().empty() && has_hanging_node(faces, faces[i], smaller))
        why
          << " has a node in the middle of a cell's side, at ("
          << faces[i].center
          << "), where two smaller cells meet a larger one. Divide the larger "
             "one: nodes must be corners of all cells around them.";
    for (const auto &[i, smaller] : touching)
      if (why.str().empty() && faces[i].id == 0)
        why << " has doubled nodes: " << touching.size()
            << " boundary faces lie on each other, the first at ("
            << faces[i].center
            << "), and nothing would flow through there. Merge the nodes (in "
               "Gmsh: 'Coherence;' for the geometry or 'Coherence Mesh;'), or, "
               "if this is meant to be a thin wall, give both of its sides a "
               "boundary number.";
    AssertThrow(why.str().empty(), dealii::ExcMessage(what + why.str()));
  }



  template std::string
  touching_boundaries(const dealii::Triangulation<2> &, const BoundaryNames &);
  template std::string
  touching_boundaries(const dealii::Triangulation<3> &, const BoundaryNames &);
  template void
  refuse_doubled_nodes(const dealii::Triangulation<2> &, const std::string &);
  template void
  refuse_doubled_nodes(const dealii::Triangulation<3> &, const std::string &);
} // namespace Thalweg
