// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_support_irregular_mesh_h
#define tests_support_irregular_mesh_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "support/files.h"
#include "support/input.h"

/**
 * @brief A file with a mesh of the unit box for Gmsh whose inner nodes are
 * moved, removed when this object goes.
 * @param n cells a side
 * @param amplitude by which nodes are moved at most, in parts of a cell
 * @param simplices whether cells are cut into triangles or tetrahedra
 */
template <int dim>
class IrregularMesh
{
public:
  IrregularMesh(const unsigned int n,
                const double       amplitude,
                const bool         simplices)
    : n(n)
    , path(own_path("irregular.msh"))
  {
    std::ofstream file(path);
    file.precision(17);
    file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n"
         << count(n + 1) << "\n";
    for (unsigned int i = 0; i < count(n + 1); ++i)
      {
        file << i + 1;
        for (unsigned int d = 0; d < 3; ++d)
          file << " " << coordinate(i, d, amplitude);
        file << "\n";
      }
    std::ostringstream elements;
    unsigned int       n_elements = 0;
    const auto         add        = [&](const unsigned int               type,
                         const std::vector<unsigned int> &nodes) {
      elements << ++n_elements << " " << type << " 2 0 0";
      for (const unsigned int node : nodes)
        elements << " " << node;
      elements << "\n";
    };
    for (unsigned int c = 0; c < count(n); ++c)
      simplices ? add_simplices(c, add) : add_cell(c, add);
    file << "$EndNodes\n$Elements\n"
         << n_elements << "\n"
         << elements.str() << "$EndElements\n";
  }

  ~IrregularMesh()
  {
    std::remove(path.c_str());
  }

  /// The section "Geometry" of an input file.
  std::string
  geometry(const bool divide) const
  {
    return section("Geometry",
                   {"Model = file"},
                   section("file",
                           {"File name = " + path,
                            std::string("Divide cells = ") +
                              (divide ? "true" : "false")}));
  }

private:
  static unsigned int
  count(const unsigned int per_side)
  {
    return dim == 2 ? per_side * per_side : per_side * per_side * per_side;
  }

  double
  coordinate(const unsigned int node,
             const unsigned int d,
             const double       amplitude) const
  {
    if (d >= dim)
      return 0.;
    unsigned int index = node;
    for (unsigned int e = 0; e < d; ++e)
      index /= n + 1;
    index %= n + 1;
    const double moved =
      index == 0 || index == n ? 0. : std::sin(37. * node + 11. * d);
    return (index + amplitude * moved) / n;
  }

  /// The number of the vertex of cell @p cell with these bits.
  unsigned int
  vertex(unsigned int cell, const unsigned int bits) const
  {
    unsigned int node = 1, stride = 1;
    for (unsigned int d = 0; d < dim; ++d)
      {
        node += (cell % n + ((bits >> d) & 1u)) * stride;
        cell /= n;
        stride *= n + 1;
      }
    return node;
  }

  template <typename Add>
  void
  add_cell(const unsigned int cell, const Add &add) const
  {
    std::vector<unsigned int> nodes;
    for (unsigned int layer = 0; layer < (dim == 2 ? 1 : 2); ++layer)
      for (const unsigned int bits : {0, 1, 3, 2})
        nodes.push_back(vertex(cell, bits + 4 * layer));
    add(dim == 2 ? 3 : 5, nodes);
  }

  /// Kuhn's division: a simplex for each order of the directions.
  template <typename Add>
  void
  add_simplices(const unsigned int cell, const Add &add) const
  {
    std::array<unsigned int, dim> order;
    for (unsigned int d = 0; d < dim; ++d)
      order[d] = d;
    do
      {
        std::vector<unsigned int> nodes = {vertex(cell, 0)};
        unsigned int              bits = 0, swaps = 0;
        for (unsigned int d = 0; d < dim; ++d)
          {
            bits |= 1u << order[d];
            nodes.push_back(vertex(cell, bits));
            for (unsigned int e = 0; e < d; ++e)
              swaps += order[e] > order[d];
          }
        if (swaps % 2 == 1)
          std::swap(nodes[dim - 1], nodes[dim]);
        add(dim == 2 ? 2 : 4, nodes);
    } while (std::next_permutation(order.begin(), order.end()));
  }

  const unsigned int n;
  const std::string  path;
};

#endif
