#include <thalweg/mesh/boundary_name.h>
#include <thalweg/mesh/cell_graph.h>
#include <thalweg/mesh/touching_boundaries.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

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
                face.corners[v] = cell->face(f)->vertex(v ^ (v >> 1));
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



    /// The faces that lie on others, both the larger and the smaller ones.
    template <int dim>
    std::vector<EndFace<dim>>
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
      const auto             tree = dealii::pack_rtree(entries);
      std::set<unsigned int> touching;
      for (unsigned int i = 0; i < faces.size(); ++i)
        {
          std::vector<Entry> near;
          tree.query(boost::geometry::index::intersects(faces[i].center),
                     std::back_inserter(near));
          for (const auto &[box, j] : near)
            if (j != i && lies_on(faces[i], faces[j]))
              touching.insert({i, j});
        }
      std::vector<EndFace<dim>> result;
      for (const unsigned int i : touching)
        result.push_back(faces[i]);
      return result;
    }
  } // namespace



  template <int dim>
  std::string
  touching_boundaries(const dealii::Triangulation<dim> &coarse,
                      const BoundaryNames              &names)
  {
    const auto faces = touching_faces(end_faces(coarse));
    if (faces.empty())
      return "";
    std::set<dealii::types::boundary_id> ids;
    for (const auto &face : faces)
      ids.insert(face.id);
    std::ostringstream text;
    text.precision(10);
    text << faces.size() << " boundary faces of the coarse mesh (";
    std::string separator;
    for (const auto id : ids)
      {
        text << separator << "'" << boundary_name(names, id) << "'";
        separator = ", ";
      }
    text << ") lie on each other, the first at (" << faces.front().center
         << "). Nothing flows through there. If it is not meant to be a thin "
            "wall, merge the nodes of the mesh (in Gmsh: 'Coherence;' for the "
            "geometry or 'Coherence Mesh;').";
    return text.str();
  }



  template std::string
  touching_boundaries(const dealii::Triangulation<2> &, const BoundaryNames &);
  template std::string
  touching_boundaries(const dealii::Triangulation<3> &, const BoundaryNames &);
} // namespace Thalweg
