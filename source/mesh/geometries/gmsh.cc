// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/plain_text.h>
#include <thalweg/mesh/geometries/gmsh.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <utility>

namespace Thalweg
{
  namespace Geometries
  {
    namespace
    {
      constexpr std::int64_t most = std::numeric_limits<int>::max() - 1;


      /// Reads a file from its beginning to its end.
      class Reader
      {
      public:
        Reader(const std::string &text, const std::string &refusal)
          : words(text, refusal)
        {}

        GmshFile
        read();

      private:
        void
        read_format();

        void
        read_names();

        std::string
        read_quoted();

        void
        read_entities();

        void
        read_nodes();

        void
        read_block_of_nodes();

        void
        read_elements();

        void
        read_block_of_elements();

        void
        read_old_elements();

        int
        read_tags();

        dealii::Point<3>
        read_point();

        Shape
        read_shape();

        std::int64_t
        tag(const std::string &name)
        {
          return words.whole(name, -most, most);
        }

        Words    words;
        GmshFile file;
        /// Ten times the version's number.
        unsigned int version = 10;
        /// The physical groups of entities, by dimension and number.
        std::map<std::pair<std::int64_t, std::int64_t>, int> groups;
      };


      void
      Reader::read_format()
      {
        const std::string name = words.next("the version");
        static const std::map<std::string, unsigned int> versions{{"2", 20},
                                                                  {"2.0", 20},
                                                                  {"2.1", 21},
                                                                  {"2.2", 22},
                                                                  {"4", 40},
                                                                  {"4.0", 40},
                                                                  {"4.1", 41}};
        const auto found = versions.find(name);
        if (found == versions.end())
          words.refuse("stands version '" + excerpt(name) +
                       "'; those that can be read are 2.2 and 4.1 (in Gmsh: "
                       "'Mesh.MshFileVersion = 4.1;')");
        version = found->second;
        if (words.whole("the type of the file", 0, 1) == 1)
          words.refuse("it says that it is binary; save it in ASCII (in Gmsh: "
                       "'Mesh.Binary = 0;')");
        words.whole("the size of numbers", 8, 8);
        words.expect("$EndMeshFormat");
      }


      std::string
      Reader::read_quoted()
      {
        std::string text  = words.rest_of_line();
        const auto  begin = text.find('"'), end = text.rfind('"');
        if (begin == end)
          words.refuse("must stand a name in quotation marks");
        return text.substr(begin + 1, end - begin - 1);
      }


      void
      Reader::read_names()
      {
        const std::size_t n = words.count("the number of physical names", 3);
        for (std::size_t i = 0; i < n; ++i)
          {
            const auto dimension =
              words.whole("the dimension of a physical name", 0, 3);
            const auto group = words.whole("the number of a group", 0, most);
            const std::string name = excerpt(read_quoted());
            const auto [entry, is_new] =
              file.names[dimension].emplace(name, group);
            if (!is_new && entry->second != group)
              words.refuse("it has two physical groups that are called '" +
                           excerpt(name) + "', " +
                           std::to_string(entry->second) + " and " +
                           std::to_string(group) +
                           ". Give each a name of its own, or make them one");
          }
        words.expect("$EndPhysicalNames");
      }


      void
      Reader::read_entities()
      {
        std::size_t n[4];
        for (auto &entities : n)
          entities = words.count("a number of entities", 5);
        for (unsigned int dimension = 0; dimension < 4; ++dimension)
          for (std::size_t i = 0; i < n[dimension]; ++i)
            {
              const auto number = tag("the number of an entity");
              // Version 4.1 gives points as such, others as boxes.
              const bool is_point = dimension == 0 && version > 40;
              for (unsigned int c = 0; c < (is_point ? 3 : 6); ++c)
                words.number("a coordinate");
              const std::size_t n_groups =
                words.count("the number of an entity's physical groups");
              if (n_groups > 1)
                words.refuse("an entity has " + std::to_string(n_groups) +
                             " physical groups, but it can have one only");
              int group = 0;
              if (n_groups == 1)
                group = words.whole("the number of a group", 0, most);
              groups[{dimension, number}] = group;
              if (dimension == 0)
                continue;
              const std::size_t n_bounds =
                words.count("the number of an entity's boundaries");
              for (std::size_t b = 0; b < n_bounds; ++b)
                tag("the number of a boundary");
            }
        words.expect("$EndEntities");
      }


      dealii::Point<3>
      Reader::read_point()
      {
        dealii::Point<3> point;
        for (unsigned int d = 0; d < 3; ++d)
          point[d] = words.number("a coordinate");
        return point;
      }


      void
      Reader::read_block_of_nodes()
      {
        tag("the entity of nodes");
        tag("the entity of nodes");
        const bool is_parametric =
          words.whole("whether nodes have parameters", 0, 1) == 1;
        const std::size_t n =
          words.count("the number of nodes of a block", version > 40 ? 4 : 3);
        std::vector<std::int64_t> numbers;
        for (std::size_t i = 0; i < n && version > 40; ++i)
          numbers.push_back(words.whole("the number of a node", 0, most));
        for (std::size_t i = 0; i < n; ++i)
          {
            const auto number =
              version > 40 ? numbers[i]
                           : words.whole("the number of a node", 0, most);
            file.outline.add_point(words, number, read_point());
            for (unsigned int p = 0; p < 2 && is_parametric; ++p)
              words.number("a parameter of a node");
          }
      }


      void
      Reader::read_nodes()
      {
        std::size_t n_blocks = 0;
        if (version >= 40)
          n_blocks = words.count("the number of blocks of nodes", 4);
        const std::size_t n = words.count("the number of nodes", 3);
        if (version > 40)
          for (const char *name : {"the least", "the greatest"})
            words.whole(name + std::string(" number of a node"), 0, most);
        if (version < 40)
          for (std::size_t i = 0; i < n; ++i)
            {
              const auto number = words.whole("the number of a node", 0, most);
              file.outline.add_point(words, number, read_point());
            }
        for (std::size_t block = 0; block < n_blocks; ++block)
          read_block_of_nodes();
        words.expect(version == 10 ? "$ENDNOD" : "$EndNodes");
        if (file.outline.points.size() != n)
          words.refuse("end " + std::to_string(file.outline.points.size()) +
                       " nodes, but there must be " + std::to_string(n));
      }


      Shape
      Reader::read_shape()
      {
        const auto type = words.whole("the type of an element", 1, 1000);
        if (type > 5 && type != 15)
          words.refuse("stands an element of the type " + std::to_string(type) +
                       ". Those that can be read are lines, triangles, "
                       "quadrilaterals, tetrahedra and hexahedra of first "
                       "order (in Gmsh: 'Mesh.ElementOrder = 1;')");
        return static_cast<Shape>(type);
      }


      void
      Reader::read_block_of_elements()
      {
        std::int64_t dimension = 0;
        if (version > 40)
          dimension = words.whole("the dimension of elements", 0, 3);
        const auto entity = tag("the entity of elements");
        if (version == 40)
          dimension = words.whole("the dimension of elements", 0, 3);
        const Shape       shape = read_shape();
        const std::size_t n =
          words.count("the number of elements of a block", 2);
        const auto group = groups.find({dimension, entity});
        for (std::size_t i = 0; i < n; ++i)
          {
            const auto number =
              words.whole("the number of an element", 0, most);
            file.outline.add_element(words,
                                     {shape,
                                      group == groups.end() ? 0 : group->second,
                                      number,
                                      0,
                                      {}});
          }
      }


      int
      Reader::read_tags()
      {
        if (version == 10)
          {
            const int group = words.whole("the group of an element", 0, most);
            tag("the entity of an element");
            return group;
          }
        // Gmsh has two, and some more for partitions.
        const auto n = words.whole("the number of an element's tags", 0, 1000);
        int        group = 0;
        for (int i = 0; i < n; ++i)
          if (i == 0)
            group = words.whole("the group of an element", 0, most);
          else
            tag("a tag of an element");
        return group;
      }


      void
      Reader::read_old_elements()
      {
        const auto  number = words.whole("the number of an element", 0, most);
        const Shape shape  = read_shape();
        const int   group  = read_tags();
        if (version == 10)
          words.whole("the number of an element's nodes",
                      n_nodes(shape),
                      n_nodes(shape));
        file.outline.add_element(words, {shape, group, number, 0, {}});
      }


      void
      Reader::read_elements()
      {
        std::size_t n_blocks = 0;
        if (version >= 40)
          n_blocks = words.count("the number of blocks of elements", 4);
        const std::size_t n = words.count("the number of elements", 2);
        if (version > 40)
          for (const char *name : {"the least", "the greatest"})
            words.whole(name + std::string(" number of an element"), 0, most);
        for (std::size_t i = 0; i < n && version < 40; ++i)
          read_old_elements();
        for (std::size_t block = 0; block < n_blocks; ++block)
          read_block_of_elements();
        words.expect(version == 10 ? "$ENDELM" : "$EndElements");
        if (file.outline.elements.size() != n)
          words.refuse("end " + std::to_string(file.outline.elements.size()) +
                       " elements, but there must be " + std::to_string(n));
      }


      GmshFile
      Reader::read()
      {
        while (file.outline.elements.empty())
          {
            const std::string section = words.next("'$Elements'");
            if (section == "$MeshFormat")
              read_format();
            else if (section == "$PhysicalNames")
              read_names();
            else if (section == "$Entities")
              read_entities();
            else if (section == "$Nodes" || section == "$NOD")
              read_nodes();
            else if (section == "$Elements" || section == "$ELM")
              {
                read_elements();
                break;
              }
            else if (section.size() > 1 && section[0] == '$')
              words.skip_behind("$End" + section.substr(1));
            else
              words.refuse("stands '" + excerpt(section) +
                           "' where a section must begin, as '$Nodes' does");
          }
        return std::move(file);
      }
    } // namespace



    GmshFile
    read_gmsh(const std::string &text, const std::string &refusal)
    {
      return Reader(text, refusal).read();
    }
  } // namespace Geometries
} // namespace Thalweg
