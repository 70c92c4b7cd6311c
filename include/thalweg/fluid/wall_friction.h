// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef thalweg_fluid_wall_friction_h
#define thalweg_fluid_wall_friction_h

#include <thalweg/fluid/flow_operators.h>

#include <vector>

namespace Thalweg
{
  /**
   * @brief nu dV/dn at the boundaries where the velocity is given or zero: the
   * gradient of the cells there, of first order with linear elements, and at
   * their nodes what it misses of the weak form of the viscous acceleration,
   *
   * <N, nu dV/dn> = (N, g) + nu (grad N, grad V).
   *
   * Nodes where faces meet at an angle, or where other boundaries begin, get on
   * each face the mean of what is missing at its other nodes.
   */
  template <int dim>
  class WallFriction
  {
  public:
    /// A face where the velocity is given or zero.
    struct Face
    {
      unsigned int              cell;
      unsigned int              face_no;
      std::vector<unsigned int> nodes; ///< local numbers
      /// [node of the face][node of the cell]: d/dn of its shape function
      std::vector<double> slopes;
    };

    /// @param operators must outlive the object
    WallFriction(const FlowOperators<dim> &operators,
                 const FlowBoundary<dim>  &boundary,
                 const double              kinematic_viscosity);

    /// Those of the owned cells, in the order of cells and of their faces.
    const std::vector<Face> &
    faces() const
    {
      return faces_;
    }

    /**
     * @brief Finds nu dV/dn. Collective.
     * @param velocity ghosted
     * @param g its viscous acceleration, m/s^2, ghosted
     * @return [face][node of the face][component], m^2/s^2
     */
    const std::vector<double> &
    find(const Vector &velocity, const Vector &g);

  private:
    void
    collect_faces(const FlowBoundary<dim> &boundary);

    /// Finds `area`, and `is_corner` by the mean of the normals of a node.
    void
    find_corners(const FlowBoundary<dim> &boundary);

    /// The weak form knows of all boundaries: where those end at which the
    /// velocity is given, `is_corner` is 1.
    void
    mark_other_faces(const FlowBoundary<dim> &boundary);

    /// What the cells' gradients miss at nodes, over the area.
    void
    find_missing(const Vector &velocity, const Vector &g);

    /// Sets @p values to nu dV/dn at the nodes of a face.
    void
    find_on_face(const Face   &face,
                 const Vector &velocity,
                 double       *values) const;

    const FlowOperators<dim> &operators;
    const double              nu;
    std::vector<Face>         faces_;
    std::vector<double>       on_faces;
    Vector                    area;      ///< of a node's faces, dim times
    Vector                    is_corner; ///< 0 where the faces meet smoothly
    Vector                    missing;
  };
} // namespace Thalweg

#endif
