// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/mesh_outline.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace Thalweg
{
  namespace Geometries
  {
    namespace
    {
      using Nodes = std::vector<unsigned int>;


      /// The nodes of the sides of a shape.
      const std::vector<Nodes> &
      sides_of(const Shape shape)
      {
        static const std::map<Shape, std::vector<Nodes>> sides{
          {Shape::triangle, {{0, 1}, {1, 2}, {2, 0}}},
          {Shape::quadrilateral, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}},
          {Shape::tetrahedron, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {0, 2, 3}}},
          {Shape::hexahedron,
           {{0, 1, 2, 3},
            {4, 5, 6, 7},
            {0, 1, 5, 4},
            {1, 2, 6, 5},
            {2, 3, 7, 6},
            {3, 0, 4, 7}}}};
        static const std::vector<Nodes> none;
        const auto                      found = sides.find(shape);
        return found == sides.end() ? none : found->second;
      }


      Nodes
      sorted(Nodes nodes)
      {
        std::sort(nodes.begin(), nodes.end());
        return nodes;
      }


      std::string
      name_of(const MeshOutline::Element &element)
      {
        return "the element " + std::to_string(element.number) + " in line " +
               std::to_string(element.line);
      }


      /// The middle of the points, for messages.
      std::string
      place_of(const MeshOutline &outline, const Nodes &nodes)
      {
        dealii::Tensor<1, 3> sum;
        for (const unsigned int node : nodes)
          sum += outline.points[node] - outline.points[nodes[0]];
        std::ostringstream text;
        text.precision(10);
        text << "(" << outline.points[nodes[0]] + sum / double(nodes.size())
             << ")";
        return text.str();
      }


      class Checker
      {
      public:
        Checker(const MeshOutline &outline,
                const unsigned int dim,
                const std::string &refusal)
          : outline(outline)
          , dim(dim)
          , refusal(refusal)
        {}

        void
        check();

      private:
        [[noreturn]] void
        refuse(const std::string &why) const
        {
          throw dealii::ExcMessage(refusal + ": " + why);
        }

        void
        add_cell(const MeshOutline::Element &cell);

        void
        add_edges(const MeshOutline::Element &cell);

        void
        check_side(const MeshOutline::Element &side);

        const MeshOutline &outline;
        const unsigned int dim;
        const std::string &refusal;

        std::map<Nodes, const MeshOutline::Element *> cells, sides;
        /// The cells at each side.
        std::map<Nodes, std::vector<const MeshOutline::Element *>> cells_at;
        std::set<Nodes>                                            edges;
      };


      void
      Checker::add_cell(const MeshOutline::Element &cell)
      {
        const auto [twin, is_new] = cells.emplace(sorted(cell.nodes), &cell);
        if (!is_new)
          refuse(name_of(cell) + " has the same nodes as " +
                 name_of(*twin->second) + ". Remove one of them.");
        for (const Nodes &side : sides_of(cell.shape))
          {
            Nodes nodes;
            for (const unsigned int node : side)
              nodes.push_back(cell.nodes[node]);
            auto &all = cells_at[sorted(nodes)];
            all.push_back(&cell);
            if (all.size() > 2)
              refuse("three cells meet at one side, at " +
                     place_of(outline, nodes) + ": " + name_of(*all[0]) + ", " +
                     name_of(*all[1]) + " and " + name_of(*all[2]) +
                     ". Two at the most can have a side in common.");
          }
      }


      void
      Checker::add_edges(const MeshOutline::Element &cell)
      {
        for (const Nodes &side : sides_of(cell.shape))
          for (unsigned int n = 0; n < side.size(); ++n)
            edges.insert(sorted(
              {cell.nodes[side[n]], cell.nodes[side[(n + 1) % side.size()]]}));
      }


      void
      Checker::check_side(const MeshOutline::Element &side)
      {
        const Nodes nodes = sorted(side.nodes);
        if (cells_at.count(nodes) == 0)
          refuse(name_of(side) +
                 " is to mark a boundary, but is no side of a "
                 "cell (its middle is " +
                 place_of(outline, nodes) +
                 "). Remove it, or repair the mesh.");
        const auto [twin, is_new] = sides.emplace(nodes, &side);
        if (!is_new && twin->second->tag != side.tag)
          refuse(name_of(side) + " and " + name_of(*twin->second) +
                 " give two numbers to one side, " + std::to_string(side.tag) +
                 " and " + std::to_string(twin->second->tag) +
                 ". Remove one of them.");
      }


      void
      Checker::check()
      {
        bool has_lines_in_3d = false;
        for (const auto &element : outline.elements)
          if (dimension_of(element.shape) > dim)
            refuse(name_of(element) + " is one of " +
                   std::to_string(dimension_of(element.shape)) +
                   " dimensions. Does the parameter 'Dimension' fit the mesh?");
          else if (dimension_of(element.shape) == dim)
            add_cell(element);
          else if (dim == 3 && element.shape == Shape::line)
            has_lines_in_3d = true;
        if (cells.empty())
          refuse("it has no cells of " + std::to_string(dim) +
                 " dimensions. Does the parameter 'Dimension' fit the mesh?");
        for (const auto &element : outline.elements)
          if (dimension_of(element.shape) == dim - 1)
            check_side(element);
        if (!has_lines_in_3d)
          return;
        for (const auto &element : outline.elements)
          if (dimension_of(element.shape) == dim)
            add_edges(element);
        for (const auto &element : outline.elements)
          if (element.shape == Shape::line &&
              edges.count(sorted(element.nodes)) == 0)
            refuse(name_of(element) + " is a line, but no edge of a cell. "
                                      "Remove it, or repair the mesh.");
      }
    } // namespace



    unsigned int
    n_nodes(const Shape shape)
    {
      switch (shape)
        {
          case Shape::point:
            return 1;
          case Shape::line:
            return 2;
          case Shape::triangle:
            return 3;
          case Shape::quadrilateral:
          case Shape::tetrahedron:
            return 4;
          case Shape::hexahedron:
            return 8;
        }
      return 0;
    }



    unsigned int
    dimension_of(const Shape shape)
    {
      switch (shape)
        {
          case Shape::point:
            return 0;
          case Shape::line:
            return 1;
          case Shape::triangle:
          case Shape::quadrilateral:
            return 2;
          case Shape::tetrahedron:
          case Shape::hexahedron:
            return 3;
        }
      return 0;
    }



    void
    MeshOutline::add_point(const Words            &words,
                           const std::int64_t      number,
                           const dealii::Point<3> &point)
    {
      if (!indices.emplace(number, points.size()).second)
        words.refuse("the node " + std::to_string(number) +
                     " comes for the second time");
      points.push_back(point);
    }



    unsigned int
    MeshOutline::index(const Words &words, const std::int64_t number) const
    {
      const auto found = indices.find(number);
      if (found == indices.end())
        words.refuse("an element has the node " + std::to_string(number) +
                     ", but there is no node of this number");
      return found->second;
    }



    void
    MeshOutline::add_element(Words &words, Element element)
    {
      for (unsigned int n = 0; n < n_nodes(element.shape); ++n)
        {
          const auto number =
            words.whole("the number of a node", 0, 1000000000000);
          const unsigned int node = index(words, number);
          if (std::count(element.nodes.begin(), element.nodes.end(), node) > 0)
            words.refuse("the element " + std::to_string(element.number) +
                         " has the node " + std::to_string(number) + " twice");
          element.nodes.push_back(node);
        }
      element.line = words.line();
      elements.push_back(std::move(element));
    }



    bool
    MeshOutline::has_only_cubes(const unsigned int dimension) const
    {
      return std::all_of(elements.begin(),
                         elements.end(),
                         [dimension](const Element &element) {
                           return dimension_of(element.shape) != dimension ||
                                  element.shape == Shape::quadrilateral ||
                                  element.shape == Shape::hexahedron;
                         });
    }



    namespace
    {
      /// Whether a quadrilateral of x and y turns left and right.
      bool
      is_twisted(const MeshOutline &outline, const Nodes &nodes)
      {
        bool left = false, right = false;
        for (unsigned int n = 0; n < 4; ++n)
          {
            const auto  &point = outline.points[nodes[n]];
            const auto   to    = outline.points[nodes[(n + 1) % 4]] - point;
            const auto   from  = point - outline.points[nodes[(n + 3) % 4]];
            const double turn  = from[0] * to[1] - from[1] * to[0];
            left               = left || turn > 0.;
            right              = right || turn < 0.;
          }
        return left && right;
      }
    } // namespace



    std::string
    MeshOutline::first_twisted() const
    {
      unsigned int n = 0;
      for (const Element &element : elements)
        if (dimension_of(element.shape) == 3)
          return "";
        else if (dimension_of(element.shape) == 2)
          {
            if (element.shape == Shape::quadrilateral &&
                is_twisted(*this, element.nodes))
              return std::to_string(n) + " with its centre at " +
                     place_of(*this, element.nodes);
            ++n;
          }
      return "";
    }



    std::vector<dealii::Point<3>>
    MeshOutline::points_of_cells(const unsigned int dimension) const
    {
      std::vector<dealii::Point<3>> result;
      for (const Element &element : elements)
        if (dimension_of(element.shape) == dimension)
          for (const unsigned int node : element.nodes)
            result.push_back(points[node]);
      return result;
    }



    void
    check_outline(const MeshOutline &outline,
                  const unsigned int dim,
                  const std::string &refusal)
    {
      Checker(outline, dim, refusal).check();
    }
  } // namespace Geometries
} // namespace Thalweg
