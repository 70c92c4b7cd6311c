// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/plain_text.h>
#include <thalweg/core/text_file.h>
#include <thalweg/dem/triangle_file.h>
#include <thalweg/mesh/geometries/words.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace Thalweg
{
  namespace
  {
    using Geometries::Words;

    constexpr std::size_t largest_file    = std::size_t(1) << 30;
    constexpr std::size_t stl_header      = 84;
    constexpr std::size_t bytes_of_facet  = 50;
    constexpr std::size_t bytes_of_normal = 12;



    Vec3
    read_vertex(Words &words)
    {
      const double x = words.number("a coordinate");
      const double y = words.number("a coordinate");
      return {x, y, words.number("a coordinate")};
    }



    std::vector<Triangle>
    read_ascii_stl(const std::string &text, const std::string &refusal)
    {
      std::vector<Triangle> triangles;
      Words                 words(text, refusal);
      words.expect("solid");
      words.rest_of_line();
      for (std::string word = words.next("'facet' or 'endsolid'");
           word != "endsolid";
           word = words.next("'facet' or 'endsolid'"))
        {
          if (word != "facet")
            words.refuse("'" + excerpt(word) +
                         "' stands where 'facet' must be");
          // Normals are often nothing but zeros.
          words.rest_of_line();
          words.expect("outer");
          words.expect("loop");
          Triangle triangle;
          for (Vec3 &corner : triangle)
            {
              words.expect("vertex");
              corner = read_vertex(words);
            }
          words.expect("endloop");
          words.expect("endfacet");
          triangles.push_back(triangle);
        }
      return triangles;
    }



    std::uint32_t
    stl_count(const std::string &bytes)
    {
      std::uint32_t n = 0;
      if (bytes.size() >= stl_header)
        std::memcpy(&n, bytes.data() + stl_header - sizeof(n), sizeof(n));
      return n;
    }



    std::vector<Triangle>
    read_binary_stl(const std::string &bytes, const std::string &refusal)
    {
      const std::size_t n        = stl_count(bytes);
      const std::size_t expected = stl_header + n * bytes_of_facet;
      AssertThrow(bytes.size() >= expected && bytes.size() >= stl_header,
                  dealii::ExcMessage(
                    refusal + ": it has " + std::to_string(bytes.size()) +
                    " bytes, and " + std::to_string(n) + " triangles need " +
                    std::to_string(expected) + "; is it complete?"));
      std::vector<Triangle> triangles(n);
      for (std::size_t t = 0; t < n; ++t)
        {
          float numbers[9];
          std::memcpy(numbers,
                      bytes.data() + stl_header + t * bytes_of_facet +
                        bytes_of_normal,
                      sizeof(numbers));
          for (unsigned int c = 0; c < 3; ++c)
            triangles[t][c] = {numbers[3 * c],
                               numbers[3 * c + 1],
                               numbers[3 * c + 2]};
        }
      return triangles;
    }



    /// The corner "7", "7/1", "7//2" or "-1" of a face.
    std::size_t
    corner_number(const std::string &word, const std::size_t n, Words &words)
    {
      char      *end    = nullptr;
      const long number = std::strtol(word.c_str(), &end, 10);
      if (end == word.c_str() || (*end != '\0' && *end != '/') || number == 0 ||
          static_cast<std::size_t>(std::abs(number)) > n)
        words.refuse("the corner '" + excerpt(word) +
                     "' of a face is none of the " + std::to_string(n) +
                     " vertices before it");
      return number > 0 ? number - 1 : n + number;
    }



    std::vector<Triangle>
    read_obj(const std::string &text, const std::string &refusal)
    {
      std::vector<Triangle> triangles;
      std::vector<Vec3>     vertices;
      Words                 words(text, refusal);
      while (!words.at_end())
        {
          const std::string word = words.next("a word");
          if (word == "v")
            vertices.push_back(read_vertex(words));
          const std::string rest = words.rest_of_line(true) + " ";
          if (word != "f")
            continue;
          std::vector<std::size_t> corners;
          for (std::size_t begin = rest.find_first_not_of(" \t");
               begin != std::string::npos;)
            {
              const std::size_t end = rest.find_first_of(" \t", begin);
              corners.push_back(corner_number(rest.substr(begin, end - begin),
                                              vertices.size(),
                                              words));
              begin = rest.find_first_not_of(" \t", end);
            }
          if (corners.size() < 3)
            words.refuse("a face has fewer than three corners");
          for (std::size_t c = 1; c + 1 < corners.size(); ++c)
            triangles.push_back({{vertices[corners[0]],
                                  vertices[corners[c]],
                                  vertices[corners[c + 1]]}});
        }
      return triangles;
    }



    bool
    ends_with(const std::string &path, const std::string &ending)
    {
      std::string end =
        path.substr(path.size() - std::min(path.size(), ending.size()));
      std::transform(end.begin(), end.end(), end.begin(), [](const char c) {
        return std::tolower(static_cast<unsigned char>(c));
      });
      return end == ending;
    }



    /// Takes out what has no area. @throws dealii::ExcMessage if nothing is
    /// left
    void
    check_triangles(std::vector<Triangle> &triangles,
                    const std::string     &refusal)
    {
      const auto is_flat = [](const Triangle &t) {
        const double area = norm(cross(t[1] - t[0], t[2] - t[0]));
        const double edge = std::max({norm_square(t[1] - t[0]),
                                      norm_square(t[2] - t[0]),
                                      norm_square(t[2] - t[1])});
        return !(area > 1e-12 * edge);
      };
      for (std::size_t t = 0; t < triangles.size(); ++t)
        for (const Vec3 &corner : triangles[t])
          AssertThrow(std::isfinite(corner.x) && std::isfinite(corner.y) &&
                        std::isfinite(corner.z),
                      dealii::ExcMessage(refusal + ": triangle " +
                                         std::to_string(t + 1) +
                                         " has a coordinate that is no finite "
                                         "number."));
      triangles.erase(std::remove_if(triangles.begin(),
                                     triangles.end(),
                                     is_flat),
                      triangles.end());
      AssertThrow(!triangles.empty(),
                  dealii::ExcMessage(refusal + ": it has no triangle with an "
                                               "area."));
    }
  } // namespace



  std::vector<Triangle>
  read_triangles(const std::string &path)
  {
    const std::string what    = "The surface '" + excerpt(path) + "'";
    const std::string refusal = what + " cannot be read";
    const bool        is_obj  = ends_with(path, ".obj");
    AssertThrow(is_obj || ends_with(path, ".stl"),
                dealii::ExcMessage(what + " must be a file with the ending "
                                          "'.stl' or '.obj'."));
    const std::string content =
      read_text_file(with_home(path), what, largest_file).content;
    AssertThrow(!content.empty(), dealii::ExcMessage(what + " is empty."));
    const bool is_ascii =
      content.compare(0, 5, "solid") == 0 &&
      content.size() != stl_header + stl_count(content) * bytes_of_facet;
    std::vector<Triangle> triangles =
      is_obj     ? read_obj(plain_lines(content, what), refusal)
      : is_ascii ? read_ascii_stl(plain_lines(content, what), refusal)
                 : read_binary_stl(content, refusal);
    check_triangles(triangles, refusal);
    return triangles;
  }
} // namespace Thalweg
