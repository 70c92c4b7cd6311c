// SPDX-License-Identifier: LGPL-2.1-or-later
// What files in other formats than that of Gmsh say.
#include <thalweg/core/plain_text.h>
#include <thalweg/mesh/geometries/mesh_outline.h>

#include <limits>
#include <map>

namespace Thalweg
{
  namespace Geometries
  {
    namespace
    {
      constexpr std::int64_t most_of_outlines = std::numeric_limits<int>::max();


      /// The shape that @p table has under @p key.
      template <typename Key>
      Shape
      shape_of(const Words                &words,
               const std::map<Key, Shape> &table,
               const Key                  &key,
               const std::string          &name)
      {
        const auto found = table.find(key);
        if (found == table.end())
          words.refuse("stands an element of the type " + name +
                       ", which is not supported");
        return found->second;
      }


      dealii::Point<3>
      read_point(Words &words)
      {
        dealii::Point<3> point;
        for (unsigned int d = 0; d < 3; ++d)
          point[d] = words.number("a coordinate");
        return point;
      }


      void
      skip_comments(Words &words, const std::string &text, std::size_t at)
      {
        for (; at < text.size() && text[at] == '#';
             at = std::min(text.find('\n', at), text.size() - 1) + 1)
          {
            words.next("a comment");
            words.rest_of_line();
          }
      }
    } // namespace



    MeshOutline
    outline_of_vtk(const std::string &text, const std::string &refusal)
    {
      static const std::map<std::int64_t, Shape> shapes{
        {3, Shape::line},
        {5, Shape::triangle},
        {9, Shape::quadrilateral},
        {10, Shape::tetrahedron},
        {12, Shape::hexahedron}};
      // The types of cells come behind the cells.
      Words types(text, refusal);
      types.skip_behind("CELL_TYPES");
      const std::size_t  n_types = types.count("the number of cell types");
      std::vector<Shape> type_of;
      for (std::size_t i = 0; i < n_types; ++i)
        {
          const auto type = types.whole("a cell's type", 0, 1000);
          type_of.push_back(
            shape_of(types, shapes, type, std::to_string(type)));
        }

      MeshOutline outline;
      Words       words(text, refusal);
      words.skip_behind("POINTS");
      const std::size_t n_points = words.count("the number of points", 3);
      words.next("the type of coordinates");
      for (std::size_t i = 0; i < n_points; ++i)
        outline.add_point(words, i, read_point(words));
      words.expect("CELLS");
      const std::size_t n_cells = words.count("the number of cells", 3);
      words.whole("the number of numbers", 0, most_of_outlines);
      if (n_cells != n_types)
        words.refuse("CELLS has " + std::to_string(n_cells) +
                     " cells, but CELL_TYPES has " + std::to_string(n_types));
      for (std::size_t i = 0; i < n_cells; ++i)
        {
          const unsigned int n = n_nodes(type_of[i]);
          words.whole("the number of a cell's points", n, n);
          outline.add_element(words, {type_of[i], 0, std::int64_t(i), 0, {}});
        }
      return outline;
    }



    MeshOutline
    outline_of_ucd(const std::string &text, const std::string &refusal)
    {
      static const std::map<std::string, Shape> shapes{
        {"line", Shape::line},
        {"quad", Shape::quadrilateral},
        {"hex", Shape::hexahedron}};
      MeshOutline outline;
      Words       words(text, refusal);
      skip_comments(words, text, 0);
      const std::size_t n_points = words.count("the number of nodes", 4);
      const std::size_t n_cells  = words.count("the number of cells", 4);
      for (const char *name : {"the number of nodes' data",
                               "the number of cells' data",
                               "the number of the model's data"})
        words.whole(name, 0, most_of_outlines);
      for (std::size_t i = 0; i < n_points; ++i)
        {
          const auto number =
            words.whole("the number of a node", 0, most_of_outlines);
          outline.add_point(words, number, read_point(words));
        }
      for (std::size_t i = 0; i < n_cells; ++i)
        {
          const auto number =
            words.whole("the number of a cell", 0, most_of_outlines);
          const auto id =
            words.whole("a material or boundary id", 0, most_of_outlines - 1);
          const std::string type = words.next("the type of a cell");
          outline.add_element(
            words,
            {shape_of(words, shapes, type, "'" + excerpt(type) + "'"),
             static_cast<int>(id),
             number,
             0,
             {}});
        }
      return outline;
    }



    namespace
    {
      /// Reads what stands in a section of elements up to its end.
      void
      read_unv_elements(Words &words, MeshOutline &outline)
      {
        static const std::map<std::int64_t, Shape> shapes{
          {11, Shape::line},
          {44, Shape::quadrilateral},
          {94, Shape::quadrilateral},
          {115, Shape::hexahedron}};
        while (true)
          {
            const auto number =
              words.whole("the number of an element", -1, most_of_outlines);
            if (number == -1)
              return;
            const auto type =
              words.whole("the type of an element", 0, most_of_outlines);
            const Shape shape =
              shape_of(words, shapes, type, std::to_string(type));
            // Three properties and the number of nodes; of lines three more.
            for (unsigned int i = 0; i < (shape == Shape::line ? 7 : 4); ++i)
              words.whole("an element's property",
                          -most_of_outlines,
                          most_of_outlines);
            outline.add_element(words, {shape, 0, number, 0, {}});
          }
      }


      /// Goes through the groups of a section.
      void
      check_unv_groups(Words &words)
      {
        while (true)
          {
            if (words.whole("the number of a group", -1, most_of_outlines) ==
                -1)
              return;
            for (unsigned int i = 0; i < 6; ++i)
              words.whole("a group's property",
                          -most_of_outlines,
                          most_of_outlines);
            const std::size_t n = words.count("the size of a group", 4);
            words.whole("the name of a group, which is used as id,",
                        0,
                        most_of_outlines - 1);
            for (std::size_t i = 0; i < 4 * n; ++i)
              words.whole("a number in a group",
                          -most_of_outlines,
                          most_of_outlines);
          }
      }
    } // namespace



    MeshOutline
    outline_of_unv(const std::string &text, const std::string &refusal)
    {
      MeshOutline outline;
      Words       words(text, refusal);
      skip_comments(words, text, 0);
      const auto begin = [&words]() {
        words.expect("-1");
        return words.whole("the number of a section", 0, most_of_outlines);
      };
      for (auto section = begin(); section != 2411; section = begin())
        words.skip_behind("-1");
      while (true)
        {
          const auto number =
            words.whole("the number of a node", -1, most_of_outlines);
          if (number == -1)
            break;
          for (unsigned int i = 0; i < 3; ++i)
            words.whole("a node's property",
                        -most_of_outlines,
                        most_of_outlines);
          outline.add_point(words, number, read_point(words));
        }
      if (begin() != 2412)
        words.refuse("must begin the section 2412 of the elements");
      read_unv_elements(words, outline);
      if (words.at_end())
        return outline;
      const auto section = begin();
      if (section != 2467 && section != 2477)
        words.refuse("begins the section " + std::to_string(section) +
                     ", but behind the elements only groups are understood "
                     "(2467 and 2477)");
      check_unv_groups(words);
      return outline;
    }
  } // namespace Geometries
} // namespace Thalweg
