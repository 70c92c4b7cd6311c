#include <thalweg/core/archive.h>

#include <deal.II/base/exceptions.h>

#include <nlohmann/json.hpp>

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

    void
    expect(const bool is_there, const std::string &what)
    {
      AssertThrow(is_there,
                  dealii::ExcMessage(
                    "The checkpoint does not say '" + what +
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
    archive.mode       = Mode::read;
    archive.tree->root = Json::from_cbor(bytes, true, /* exceptions */ false);
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
