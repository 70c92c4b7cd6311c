// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/mesh/geometries/mesh_outline.h>

#include <cctype>
#include <limits>
#include <sstream>

namespace Thalweg
{
  namespace Geometries
  {
    namespace
    {
      enum class Keyword
      {
        nodes,
        elements,
        other
      };


      Keyword
      keyword_of(std::string header)
      {
        for (char &letter : header)
          letter = std::toupper(static_cast<unsigned char>(letter));
        const auto begins = [&header](const std::string &word) {
          return header.compare(0, word.size(), word) == 0 &&
                 !std::isalpha(static_cast<unsigned char>(
                   header.size() > word.size() ? header[word.size()] : ','));
        };
        return begins("*NODE")      ? Keyword::nodes
               : begins("*ELEMENT") ? Keyword::elements
                                    : Keyword::other;
      }


      /**
       * @brief The nodes and elements in @p text, each in a line of its own
       * that is also its line there: "node", its number and three coordinates;
       * or "element", its number, how many nodes it has, and these.
       */
      std::string
      plain_data(const std::string &text)
      {
        std::string        plain;
        std::istringstream stream(text);
        Keyword            keyword = Keyword::other;
        for (std::string line; std::getline(stream, line); plain += '\n')
          {
            if (!line.empty() && line[0] == '*')
              {
                if (line.compare(0, 2, "**") != 0)
                  keyword = keyword_of(line);
                continue;
              }
            for (char &letter : line)
              if (letter == ',')
                letter = ' ';
            std::istringstream       words(line);
            std::vector<std::string> all;
            for (std::string word; words >> word;)
              all.push_back(word);
            if (keyword == Keyword::other || all.empty())
              continue;
            if (keyword == Keyword::nodes)
              {
                plain += "node";
                // In two dimensions there need be no z.
                if (all.size() == 3)
                  all.emplace_back("0");
              }
            else
              {
                plain += "element";
                all.insert(all.begin() + 1, std::to_string(all.size() - 1));
              }
            for (const std::string &word : all)
              plain += ' ' + word;
          }
        return plain;
      }
    } // namespace



    MeshOutline
    outline_of_abaqus(const std::string &text,
                      const unsigned int dim,
                      const std::string &refusal)
    {
      constexpr std::int64_t most  = std::numeric_limits<int>::max() - 1;
      const std::string      plain = plain_data(text);
      const Shape shape = dim == 2 ? Shape::quadrilateral : Shape::hexahedron;
      MeshOutline outline;
      Words       words(plain, refusal);
      while (!words.at_end())
        if (const std::string kind = words.next("a node"); kind == "node")
          {
            const auto number = words.whole("the number of a node", 0, most);
            dealii::Point<3> point;
            for (unsigned int d = 0; d < 3; ++d)
              point[d] = words.number("a coordinate");
            outline.add_point(words, number, point);
          }
        else if (kind == "element")
          {
            const auto number =
              words.whole("the number of an element", 0, most);
            words.whole("the number of an element's nodes",
                        n_nodes(shape),
                        n_nodes(shape));
            outline.add_element(words, {shape, 0, number, 0, {}});
          }
        else
          words.refuse("are more numbers than a node has");
      return outline;
    }
  } // namespace Geometries
} // namespace Thalweg
