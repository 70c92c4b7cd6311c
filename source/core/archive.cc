// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/archive.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

namespace Thalweg
{
  using Json = nlohmann::json;



  struct Archive::Tree
  {
    Json root = Json::object();

    Json *
    find(const std::string &path)
    {
      const Json::json_pointer pointer(path);
      return root.contains(pointer) ? &root[pointer] : nullptr;
    }
  };



  namespace
  {
    /// @p name as a step of a path in a tree.
    std::string
    step_to(const std::string &name)
    {
      std::string step = "/";
      for (const char letter : name)
        if (letter == '~')
          step += "~0";
        else if (letter == '/')
          step += "~1";
        else
          step += letter;
      return step;
    }

    /**
     * @brief Whether values in CBOR (RFC 8949) lie so deep in each other that
     * reading them, which calls itself for each level, would use up the stack.
     *
     * Each item begins with three bits that say its kind and five that say its
     * number, or in how many bytes that follows.
     */
    bool
    is_too_deep(const std::string &bytes)
    {
      constexpr std::size_t deepest = 64;
      // How many items are to come on each level.
      std::vector<std::uint64_t> open{1};
      for (std::size_t i = 0; i < bytes.size() && open.size() <= deepest;)
        {
          const unsigned int head   = static_cast<unsigned char>(bytes[i++]);
          const unsigned int kind   = head >> 5;
          std::uint64_t      number = head & 31;
          if (number >= 24 && number <= 27)
            {
              const unsigned int width = 1u << (number - 24);
              number                   = 0;
              for (unsigned int b = 0; b < width && i < bytes.size(); ++b)
                number = number << 8 | static_cast<unsigned char>(bytes[i++]);
            }
          --open.back();
          if (kind == 2 || kind == 3)
            i += std::min<std::uint64_t>(number, bytes.size() - i);
          else if (kind == 4)
            open.push_back(number);
          else if (kind == 5)
            open.push_back(2 * number);
          else if (kind == 6)
            ++open.back(); // a tag, which stands before an item
          // Items without a given end are written by nobody.
          if (kind >= 2 && kind <= 6 && (head & 31) == 31)
            return true;
          while (!open.empty() && open.back() == 0)
            open.pop_back();
          if (open.empty())
            return false;
        }
      return open.size() > deepest;
    }

    void
    expect(const bool is_there, const std::string &what)
    {
      AssertThrow(is_there,
                  dealii::ExcMessage(
                    "The checkpoint does not say '" + what.substr(0, 200) +
                    "': it was written by another version of Thalweg or for "
                    "other parameters. Start the run anew, without "
                    "--resume."));
    }
  } // namespace



  Archive::Archive()
    : tree(std::make_shared<Tree>())
  {}



  Archive
  Archive::restore(const std::string &bytes)
  {
    Archive archive;
    archive.mode = Mode::read;
    if (!is_too_deep(bytes))
      archive.tree->root = Json::from_cbor(bytes, true, /* exceptions */ false);
    else
      archive.tree->root = Json();
    AssertThrow(archive.tree->root.is_object(),
                dealii::ExcMessage("The values of a checkpoint cannot be "
                                   "read: the file is damaged."));
    return archive;
  }



  Archive
  Archive::reader() const
  {
    Archive archive = *this;
    archive.mode    = Mode::read;
    return archive;
  }



  Archive
  Archive::nowhere()
  {
    Archive archive;
    archive.mode = Mode::nowhere;
    return archive;
  }



  bool
  Archive::has(const std::string &name) const
  {
    return tree->find(path + step_to(name)) != nullptr;
  }



  Archive
  Archive::enter(const std::string &name) const
  {
    Archive part = *this;
    part.path += step_to(name);
    if (mode == Mode::read)
      expect(tree->find(part.path) != nullptr, part.path);
    if (mode == Mode::write && tree->find(part.path) == nullptr)
      tree->root[Json::json_pointer(part.path)] = Json::object();
    return part;
  }



  template <typename T>
  void
  Archive::value(const std::string &name, T &value) const
  {
    const std::string place = path + step_to(name);
    if (mode == Mode::write)
      tree->root[Json::json_pointer(place)] = value;
    else if (mode == Mode::read)
      {
        const Json *entry = tree->find(place);
        expect(entry != nullptr, place);
        try
          {
            value = entry->get<T>();
          }
        catch (const Json::exception &)
          {
            expect(false, place);
          }
      }
  }



  std::string
  Archive::bytes() const
  {
    std::string bytes;
    Json::to_cbor(tree->root, bytes);
    return bytes;
  }



  template void
  Archive::value(const std::string &, bool &) const;
  template void
  Archive::value(const std::string &, int &) const;
  template void
  Archive::value(const std::string &, unsigned int &) const;
  template void
  Archive::value(const std::string &, std::uint64_t &) const;
  template void
  Archive::value(const std::string &, double &) const;
  template void
  Archive::value(const std::string &, std::string &) const;
  template void
  Archive::value(const std::string &, std::vector<unsigned int> &) const;
  template void
  Archive::value(const std::string &, std::vector<std::uint64_t> &) const;
  template void
  Archive::value(const std::string &, std::vector<double> &) const;
  template void
  Archive::value(const std::string &, std::vector<std::string> &) const;
} // namespace Thalweg
