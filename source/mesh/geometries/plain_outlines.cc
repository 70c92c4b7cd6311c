// SPDX-License-Identifier: LGPL-2.1-or-later
// What files say in formats that know no boundaries.
#include <thalweg/mesh/geometries/mesh_outline.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <limits>

namespace Thalweg
{
  namespace Geometries
  {
    namespace
    {
      Shape
      cube(const unsigned int dim)
      {
        return dim == 2 ? Shape::quadrilateral : Shape::hexahedron;
      }


      /// An outline of points whose places are not known yet.
      MeshOutline
      with_numbered_points(const Words       &words,
                           const std::size_t  n_points,
                           const std::int64_t first)
      {
        MeshOutline outline;
        for (std::size_t i = 0; i < n_points; ++i)
          outline.add_point(words, i + first, dealii::Point<3>());
        return outline;
      }
    } // namespace



    MeshOutline
    outline_of_xda(const std::string &text,
                   const unsigned int dim,
                   const std::string &refusal)
    {
      Words words(text, refusal);
      words.rest_of_line();
      const std::size_t n_cells = words.count("the number of cells");
      words.rest_of_line();
      const std::size_t n_points = words.count("the number of nodes");
      // The end of this line, and eight that mean nothing.
      for (unsigned int i = 0; i < 9; ++i)
        words.rest_of_line(true);
      MeshOutline outline = with_numbered_points(words, n_points, 0);
      for (std::size_t i = 0; i < n_cells; ++i)
        outline.add_element(words, {cube(dim), 0, std::int64_t(i), 0, {}});
      for (dealii::Point<3> &point : outline.points)
        for (unsigned int d = 0; d < 3; ++d)
          point[d] = words.number("a coordinate");
      return outline;
    }



    MeshOutline
    outline_of_dbmesh(const std::string &text, const std::string &refusal)
    {
      Words words(text, refusal);
      words.skip_behind("END");
      words.skip_behind("Vertices");
      const std::size_t n_points = words.count("the number of vertices", 3);
      MeshOutline       outline  = with_numbered_points(words, n_points, 1);
      for (dealii::Point<3> &point : outline.points)
        {
          for (unsigned int d = 0; d < 2; ++d)
            point[d] = words.number("a coordinate");
          words.number("the reference of a vertex");
        }
      for (const char *section : {"Edges", "CrackedEdges"})
        {
          words.expect(section);
          const std::size_t n = words.count("the number of edges", 3);
          for (std::size_t i = 0; i < 3 * n; ++i)
            words.number("a number of an edge");
        }
      words.expect("Quadrilaterals");
      const std::size_t n_cells = words.count("the number of cells", 5);
      for (std::size_t i = 0; i < n_cells; ++i)
        {
          outline.add_element(words, {cube(2), 0, std::int64_t(i), 0, {}});
          words.number("the reference of a cell");
        }
      words.skip_behind("End");
      return outline;
    }



    namespace
    {
      /// The number behind @p name in the header of a zone, as in "N=4"; zero
      /// if there is none.
      std::size_t
      number_in(const std::string &header, const std::string &name)
      {
        for (std::size_t at = header.find(name); at != std::string::npos;
             at             = header.find(name, at + 1))
          {
                        const std::size_t digits =
                          header.find_first_not_of(" =", at + name.size());
                        const bool begins_here =
                          at == 0 ||
                          !std::isalpha(static_cast<unsigned char>(header[at - 1]));
                        if (begins_here && digits != std::string::npos &&
                header.substr(at + name.size(), digits - at - name.size())
                    .find('=') != std::string::npos &&
                std::isdigit(static_cast<unsigned char>(header[digits])))
              return std::strtoull(&header[digits], nullptr, 10);
          }
        return 0;
      }


      /// Where the last @p n words of @p text begin.
      std::size_t
      begin_of_last_words(const std::string &text, std::size_t n)
      {
        const char *const blank = " \t\n";
        std::size_t       at    = text.size();
        for (; n > 0 && at != std::string::npos && at > 0; --n)
          {
            const std::size_t end = text.find_last_not_of(blank, at - 1);
            if (end == std::string::npos)
              return 0;
            at = text.find_last_of(blank, end);
            at = at == std::string::npos ? 0 : at + 1;
          }
        return at;
      }
    } // namespace



    MeshOutline
    outline_of_tecplot(const std::string &text,
                       const unsigned int dim,
                       const std::string &refusal)
    {
      // The header ends with the last line in which letters stand.
      const std::size_t letter =
        text.find_last_of("abcdfghijklmnopqrstuvwxyzABCDFGHIJKLMNOPQRSTUVWXYZ");
      const std::size_t end =
        letter == std::string::npos
          ? 0
          : std::min(text.find('\n', letter), text.size());
      std::string header = text.substr(0, end);
      for (char &c : header)
        c = c == '\n' || c == ',' ? ' '
                                  : std::toupper(static_cast<unsigned char>(c));
      const std::size_t n_points = number_in(header, "N");
      const std::size_t n_cells  = number_in(header, "E");
      Words             words(text, refusal);
      if (std::max(n_points, n_cells) > text.size())
        words.refuse("begins a header with " + std::to_string(n_points) +
                     " points and " + std::to_string(n_cells) +
                     " cells, for which the file has no room");
      MeshOutline outline = with_numbered_points(words, n_points, 1);
      if (n_cells == 0)
        return outline;
      const Shape       shape = cube(dim);
      const std::size_t begin =
        begin_of_last_words(text, n_cells * n_nodes(shape));
      words.skip_to(begin);
      for (std::size_t i = 0; i < n_cells; ++i)
        outline.add_element(words, {shape, 0, std::int64_t(i), 0, {}});
      return outline;
    }
  } // namespace Geometries
} // namespace Thalweg
