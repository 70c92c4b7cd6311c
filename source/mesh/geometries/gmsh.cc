#include <thalweg/mesh/geometries/gmsh.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/point.h>

#include <algorithm>
#include <iomanip>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

namespace Thalweg
{
  namespace Geometries
  {
    namespace
    {
      /// Meshes farther away than this times their extent are moved.
      constexpr double far = 10.;


      /// Goes behind the line that begins with @p keyword; false at the end.
      bool
      find_section(std::istream &file, const std::string &keyword)
      {
        std::string line;
        while (std::getline(file, line))
          if (line.compare(0, keyword.size(), keyword) == 0)
            return true;
        return false;
      }


      /// A file of which the places of nodes are known.
      struct NodeLines
      {
        std::vector<std::string> lines;
        /// The lines that have coordinates at their ends.
        std::vector<std::size_t> nodes;
        /// How many words stand before them.
        unsigned int n_words_before = 0;
      };


      /// Reads a file; of versions that are not known no nodes.
      NodeLines
      read_lines(std::istream &file)
      {
        NodeLines   all;
        double      version = 0.;
        std::size_t begin   = 0;
        for (std::string line; std::getline(file, line);)
          {
            all.lines.push_back(line);
            const std::size_t n = all.lines.size();
            if (n > 1 && all.lines[n - 2].rfind("$MeshFormat", 0) == 0)
              std::istringstream(line) >> version;
            if (line.rfind("$Nodes", 0) == 0)
              begin = n;
            if (line.rfind("$EndNodes", 0) != 0 || begin == 0)
              continue;
            if (version >= 2. && version < 3.)
              {
                all.n_words_before = 1;
                for (std::size_t i = begin + 1; i + 1 < n; ++i)
                  all.nodes.push_back(i);
              }
            else if (version == 4.1)
              for (std::size_t i = begin + 1; i + 1 < n;)
                {
                  unsigned int       dimension, tag, is_parametric;
                  std::size_t        n_nodes = 0;
                  std::istringstream block(all.lines[i]);
                  block >> dimension >> tag >> is_parametric >> n_nodes;
                  i += 1 + n_nodes;
                  for (std::size_t j = 0; j < n_nodes && i + 1 < n; ++j)
                    all.nodes.push_back(i++);
                }
          }
        return all;
      }


      /// The words and the coordinates of a node's line.
      std::pair<std::string, dealii::Point<3>>
      read_node(const NodeLines &all, const std::size_t line)
      {
        std::istringstream text(all.lines[line]);
        std::string        words, word;
        for (unsigned int w = 0; w < all.n_words_before && text >> word; ++w)
          words += word + " ";
        dealii::Point<3> point;
        text >> point[0] >> point[1] >> point[2];
        return {words, point};
      }
    } // namespace


    std::string
    near_origin(std::istream &file, dealii::Tensor<1, 3> &offset)
    {
      NodeLines all = read_lines(file);
      offset        = dealii::Tensor<1, 3>();
      if (!all.nodes.empty())
        {
          const auto first  = read_node(all, all.nodes[0]).second;
          double     extent = 0.;
          for (const std::size_t line : all.nodes)
            extent =
              std::max(extent, first.distance(read_node(all, line).second));
          if (first.norm() > far * extent)
            offset = first;
        }
      if (offset.norm() > 0.)
        for (const std::size_t line : all.nodes)
          {
            const auto [words, point] = read_node(all, line);
            std::ostringstream text;
            text.precision(std::numeric_limits<double>::max_digits10);
            text << words << point - offset;
            all.lines[line] = text.str();
          }
      std::string text;
      for (const std::string &line : all.lines)
        text += line + "\n";
      return text;
    }


    std::map<std::string, unsigned int>
    physical_names(std::istream      &file,
                   const unsigned int dimension,
                   const std::string &what)
    {
      std::map<std::string, unsigned int> names;
      if (!find_section(file, "$PhysicalNames"))
        return names;
      unsigned int n = 0;
      file >> n;
      for (unsigned int i = 0; i < n && file; ++i)
        {
          unsigned int group_dimension = 0, group = 0;
          std::string  name;
          file >> group_dimension >> group >> std::quoted(name);
          if (!file || group_dimension != dimension)
            continue;
          const auto [entry, is_new] = names.emplace(name, group);
          AssertThrow(is_new || entry->second == group,
                      dealii::ExcMessage(
                        what + " has two physical groups that are called '" +
                        name + "', " + std::to_string(entry->second) + " and " +
                        std::to_string(group) +
                        ". Give each a name of its own, or make them one."));
        }
      AssertThrow(file,
                  dealii::ExcMessage(
                    what +
                    " has a section $PhysicalNames that breaks off: it "
                    "needs a line 'dimension number \"name\"' for each "
                    "of its " +
                    std::to_string(n) + " groups."));
      return names;
    }
  } // namespace Geometries
} // namespace Thalweg
