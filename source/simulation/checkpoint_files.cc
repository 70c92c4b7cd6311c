// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/files.h>
#include <thalweg/simulation/checkpoint_files.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>

namespace Thalweg
{
  namespace fs = std::filesystem;
  using Json   = nlohmann::json;

  namespace
  {
    /// Of the files and what they mean; another number is another format.
    constexpr unsigned int format = 3;
    /// No run has so many ranks that its manifest would be longer.
    constexpr std::uintmax_t longest_manifest = 1 << 24;
    constexpr int            deepest_manifest = 8;

    /// A file of cells: this, then for all cells their sizes, their places and
    /// what they carry.
    struct Head
    {
      std::uint64_t n_cells = 0, n_bytes = 0;
    };

    constexpr std::uint64_t bytes_of_place =
      sizeof(std::uint32_t) + sizeof(CurveCell);



    /// Names in other encodings than UTF-8 must not hinder a checkpoint.
    std::string
    text_of(const Json &content, const int indentation)
    {
      return content.dump(indentation,
                          ' ',
                          false,
                          Json::error_handler_t::replace);
    }



    std::uint32_t
    own_checksum(Json content)
    {
      content.erase("checksum");
      const std::string text = text_of(content, -1);
      return checksum_of({bytes_of(text)});
    }



    Json
    json_of(const CheckpointFile &file)
    {
      return {{"size", file.size},
              {"checksum", file.checksum},
              {"cells", file.n_cells}};
    }



    /// A number without sign or point. @throws Json::exception if it is none
    std::uint64_t
    whole_number(const Json &object, const std::string &name)
    {
      return object.at(name).get_ref<const Json::number_unsigned_t &>();
    }



    CheckpointFile
    file_of(const Json &object)
    {
      CheckpointFile file;
      file.size     = whole_number(object, "size");
      file.checksum = whole_number(object, "checksum");
      file.n_cells  = whole_number(object, "cells");
      return file;
    }



    /// The content of a manifest, or nothing if that is no plain object.
    Json
    parse(const std::string &text)
    {
      bool       is_deep = false;
      const auto keep    = [&](const int depth, Json::parse_event_t, Json &) {
        is_deep = is_deep || depth > deepest_manifest;
        return !is_deep;
      };
      Json content = Json::parse(text, keep, /* exceptions */ false);
      return is_deep || !content.is_object() ? Json() : content;
    }



    CheckpointOutline
    outline_of(const std::string &directory, const Json &content)
    {
      CheckpointOutline outline;
      outline.directory        = directory;
      const std::uint64_t step = whole_number(content, "step");
      outline.step             = step;
      outline.time             = content.at("time").get<double>();
      outline.coarse_mesh      = whole_number(content, "coarse mesh");
      outline.values           = file_of(content.at("values"));
      for (const Json &file : content.at("cells of ranks"))
        outline.cells.push_back(file_of(file));
      outline.settings = content.at("settings").get<Settings>();
      return outline;
    }



    std::string
    fault_of(const CheckpointOutline &outline, const Json &content)
    {
      std::uint64_t n_cells = 0;
      for (const CheckpointFile &file : outline.cells)
        {
          if (file.size < sizeof(Head) ||
              file.n_cells > (file.size - sizeof(Head)) / bytes_of_place)
            return "says impossible numbers of cells";
          n_cells += file.n_cells;
        }
      if (n_cells == 0 || content.at("step") != outline.step ||
          !std::isfinite(outline.time) || outline.time < 0.)
        return "says impossible numbers";
      return "";
    }



    /// Calls @p read with each file that has some of the cells, the number of
    /// the first one in it and how many.
    void
    for_files(const CheckpointOutline                          &checkpoint,
              const std::uint64_t                               begin,
              const std::uint64_t                               end,
              const std::function<void(const std::string  &path,
                                       const std::uint64_t n_in_file,
                                       const std::uint64_t first,
                                       const std::uint64_t n)> &read)
    {
      std::uint64_t before = 0;
      for (unsigned int r = 0; r < checkpoint.cells.size(); ++r)
        {
          const std::uint64_t n = checkpoint.cells[r].n_cells;
          const auto first = std::clamp(begin, before, before + n) - before;
          const auto last  = std::clamp(end, before, before + n) - before;
          if (last > first)
            read(checkpoint.directory + "/" + CheckpointNames::cells(r),
                 n,
                 first,
                 last - first);
          before += n;
        }
    }



    void
    expect(const bool is_good, const std::string &path)
    {
      AssertThrow(is_good,
                  dealii::ExcMessage("The file '" + path +
                                     "' does not have the cells that it should "
                                     "have. Delete this checkpoint, to go on "
                                     "from the one before."));
    }



    /// Appends what some cells of a file carry.
    void
    append_packed(PackedCells        &cells,
                  const std::string  &path,
                  const std::uint64_t n_in_file,
                  const std::uint64_t first,
                  const std::uint64_t n)
    {
      Head head;
      read_range(path, 0, &head, sizeof(head));
      std::error_code     error;
      const std::uint64_t size = fs::file_size(path, error);
      expect(!error && head.n_cells == n_in_file &&
               size >= sizeof(Head) + n_in_file * bytes_of_place &&
               head.n_bytes == size - sizeof(Head) - n_in_file * bytes_of_place,
             path);
      std::vector<std::uint32_t> sizes(first + n);
      read_range(path,
                 sizeof(Head),
                 sizes.data(),
                 sizes.size() * sizeof(std::uint32_t));
      const auto middle = sizes.begin() + first;
      const auto skipped =
        std::accumulate(sizes.begin(), middle, std::uint64_t(0));
      const auto wanted =
        std::accumulate(middle, sizes.end(), std::uint64_t(0));
      expect(skipped + wanted <= head.n_bytes, path);
      cells.sizes.insert(cells.sizes.end(), middle, sizes.end());
      const std::size_t old = cells.bytes.size();
      cells.bytes.resize(old + wanted);
      read_range(path,
                 sizeof(Head) + n_in_file * bytes_of_place + skipped,
                 cells.bytes.data() + old,
                 wanted);
    }
  } // namespace



  std::string
  CheckpointNames::cells(const unsigned int rank)
  {
    char name[32];
    std::snprintf(name, sizeof(name), "cells_%05u.data", rank);
    return name;
  }



  std::string
  manifest_of(const CheckpointOutline &outline)
  {
    Json content{{"format", format},
                 {"version", THALWEG_VERSION},
                 {"step", outline.step},
                 {"time", outline.time},
                 {"coarse mesh", outline.coarse_mesh},
                 {"values", json_of(outline.values)},
                 {"cells of ranks", Json::array()},
                 {"settings", outline.settings}};
    for (const CheckpointFile &file : outline.cells)
      content["cells of ranks"].push_back(json_of(file));
    content["checksum"] = own_checksum(content);
    return text_of(content, 1) + "\n";
  }



  std::string
  read_manifest(const std::string &directory, CheckpointOutline &outline)
  {
    const std::string path = directory + "/" + CheckpointNames::manifest;
    const std::string name = std::string("its ") + CheckpointNames::manifest;
    std::error_code   error;
    const auto        size = fs::file_size(path, error);
    if (error)
      return "it has no " + std::string(CheckpointNames::manifest);
    if (size > longest_manifest)
      return name + " is too long";
    try
      {
        const Json content = parse(read_file(path));
        if (content.is_null())
          return name + " is damaged";
        if (whole_number(content, "format") != format)
          return "it was written by Thalweg " +
                 content.at("version").get<std::string>() +
                 ", whose format this version does not read";
        if (whole_number(content, "checksum") != own_checksum(content))
          return name + " is damaged";
        outline                 = outline_of(directory, content);
        const std::string fault = fault_of(outline, content);
        return fault.empty() ? "" : name + " " + fault;
      }
    catch (const Json::exception &)
      {
        return name + " is damaged";
      }
  }



  std::string
  fault_of_file(const std::string    &directory,
                const std::string    &name,
                const CheckpointFile &file)
  {
    const std::string path = directory + "/" + name;
    std::error_code   error;
    const auto        size = fs::file_size(path, error);
    if (error)
      return "its file '" + name + "' is missing";
    if (size != file.size)
      return "its file '" + name + "' has " + std::to_string(size) +
             " bytes instead of " + std::to_string(file.size);
    if (checksum_of_file(path) != file.checksum)
      return "its file '" + name + "' is damaged";
    return "";
  }



  CheckpointFile
  write_cells(const std::string            &path,
              const std::vector<CurveCell> &cells,
              const PackedCells            &packed)
  {
    const std::vector<Head>     head{{cells.size(), packed.bytes.size()}};
    const std::vector<ByteView> pieces{bytes_of(head),
                                       bytes_of(packed.sizes),
                                       bytes_of(cells),
                                       bytes_of(packed.bytes)};
    write_file(path, pieces, Durability::on_disk);
    CheckpointFile file;
    for (const ByteView &piece : pieces)
      file.size += piece.size;
    file.checksum = checksum_of(pieces);
    file.n_cells  = cells.size();
    return file;
  }



  std::vector<CurveCell>
  read_curve_cells(const CheckpointOutline &checkpoint,
                   const std::uint64_t      begin,
                   const std::uint64_t      end)
  {
    std::vector<CurveCell> cells;
    for_files(checkpoint,
              begin,
              end,
              [&](const std::string &path,
                  const auto         n_in_file,
                  const auto         first,
                  const auto         n) {
                std::vector<CurveCell> some(n);
                read_range(path,
                           sizeof(Head) + n_in_file * sizeof(std::uint32_t) +
                             first * sizeof(CurveCell),
                           some.data(),
                           n * sizeof(CurveCell));
                cells.insert(cells.end(), some.begin(), some.end());
              });
    return cells;
  }



  PackedCells
  read_packed_cells(const CheckpointOutline &checkpoint,
                    const std::uint64_t      begin,
                    const std::uint64_t      end)
  {
    PackedCells cells;
    for_files(checkpoint,
              begin,
              end,
              [&](const std::string &path,
                  const auto         n_in_file,
                  const auto         first,
                  const auto         n) {
                append_packed(cells, path, n_in_file, first, n);
              });
    return cells;
  }
} // namespace Thalweg
