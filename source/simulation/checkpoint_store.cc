#include <thalweg/core/errors.h>
#include <thalweg/simulation/checkpoint_store.h>
#include <thalweg/simulation/run_directory.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace Thalweg
{
  namespace fs = std::filesystem;
  using Json   = nlohmann::json;

  namespace
  {
    /// Of the files and what they mean; another number is another format.
    constexpr unsigned int format      = 1;
    constexpr unsigned int n_kept      = 2;
    const std::string      manifest    = "manifest.json";
    const std::string      part_ending = ".part";

    std::string
    name_of(const unsigned int step)
    {
      char name[32];
      std::snprintf(name, sizeof(name), "step_%06u", step);
      return name;
    }

    unsigned int
    checksum(const fs::path &path)
    {
      boost::crc_32_type crc;
      std::ifstream      file(path, std::ios::binary);
      std::vector<char>  buffer(1 << 20);
      while (file)
        {
          file.read(buffer.data(), buffer.size());
          crc.process_bytes(buffer.data(), file.gcount());
        }
      return crc.checksum();
    }

    /// Whole checkpoints or not, the newest first.
    std::vector<fs::path>
    all_checkpoints(const std::string &root)
    {
      std::vector<fs::path> found;
      std::error_code       error;
      for (const auto &entry : fs::directory_iterator(root, error))
        if (entry.is_directory() && entry.path().extension() != part_ending)
          found.push_back(entry.path());
      std::sort(found.rbegin(), found.rend());
      return found;
    }

    /// What is wrong with the files of a checkpoint; empty if nothing is.
    std::string
    fault_of(const fs::path &directory, Json &content)
    {
      std::ifstream file(directory / manifest);
      if (!file)
        return "it has no " + manifest;
      content = Json::parse(file, nullptr, false);
      if (!content.is_object())
        return "its " + manifest + " is damaged";
      if (content.value("format", 0u) != format)
        return "it was written by Thalweg " +
               content.value("version", std::string("of unknown version")) +
               ", whose format this version does not read";
      for (const auto &[name, entry] : content["files"].items())
        {
          std::error_code error;
          const auto      size = fs::file_size(directory / name, error);
          if (error)
            return "its file '" + name + "' is missing";
          if (size != entry["size"].get<std::uintmax_t>())
            return "its file '" + name + "' has " + std::to_string(size) +
                   " bytes instead of " + entry["size"].dump();
          if (checksum(directory / name) !=
              entry["checksum"].get<unsigned int>())
            return "its file '" + name + "' is damaged";
        }
      return "";
    }

    std::string
    nothing_in(const std::string &root, const std::string &faults)
    {
      return "There is no checkpoint to go on from in '" + root + "'. " +
             faults + "Run without --resume; the run then starts from time 0.";
    }

    CheckpointOutline
    outline_of(const std::string &directory, const Json &content)
    {
      CheckpointOutline outline;
      outline.directory   = directory;
      outline.step        = content["step"];
      outline.time        = content["time"];
      outline.coarse_mesh = content["coarse mesh"];
      outline.cells_of_ranks =
        content["cells of ranks"].get<std::vector<unsigned int>>();
      outline.settings = content["settings"].get<Settings>();
      return outline;
    }
  } // namespace



  CheckpointStore::CheckpointStore(Context &context)
    : context(context)
    , root(context.output_directory + "/checkpoints")
  {}



  void
  CheckpointStore::expect_any(const std::string &directory)
  {
    const std::string root = directory + "/checkpoints";
    AssertThrow(fs::is_directory(root),
                dealii::ExcMessage(nothing_in(root, "")));
  }



  void
  CheckpointStore::set_aside()
  {
    if (context.output_directory.empty())
      return;
    on_root(context.communicator, [&]() {
      if (!fs::exists(root))
        return;
      const std::string aside = root + ".old";
      std::error_code   error;
      fs::remove_all(aside, error);
      fs::rename(root, aside, error);
      AssertThrow(!error,
                  dealii::ExcMessage("Cannot move the checkpoints in '" + root +
                                     "' to '" + aside +
                                     "': " + error.message() + "."));
      context.log.line("The checkpoints of an earlier run are in " + aside +
                       "/ now");
    });
  }



  std::string
  CheckpointStore::begin(const unsigned int step)
  {
    unfinished = root + "/" + name_of(step) + part_ending;
    on_root(context.communicator, [&]() {
      std::error_code error;
      fs::remove_all(unfinished, error);
      fs::create_directories(unfinished, error);
      AssertThrow(!error,
                  dealii::ExcMessage(
                    "Cannot create the directory '" + unfinished +
                    "' for a checkpoint: " + error.message() + "."));
    });
    return unfinished;
  }



  void
  CheckpointStore::commit(const CheckpointOutline &outline)
  {
    on_root(context.communicator, [&]() {
      Json content{{"format", format},
                   {"version", THALWEG_VERSION},
                   {"step", outline.step},
                   {"time", outline.time},
                   {"coarse mesh", outline.coarse_mesh},
                   {"cells of ranks", outline.cells_of_ranks},
                   {"settings", outline.settings}};
      for (const auto &file : fs::directory_iterator(unfinished))
        content["files"][file.path().filename().string()] = {
          {"size", file.file_size()}, {"checksum", checksum(file.path())}};
      write_file(unfinished + "/" + manifest, content.dump(1) + "\n");
      const fs::path  place = root + "/" + name_of(outline.step);
      std::error_code error;
      fs::remove_all(place, error);
      fs::rename(unfinished, place, error);
      AssertThrow(!error,
                  dealii::ExcMessage("Cannot write the checkpoint '" +
                                     place.string() + "': " + error.message() +
                                     "."));
      const auto all = all_checkpoints(root);
      for (unsigned int i = n_kept; i < all.size(); ++i)
        fs::remove_all(all[i], error);
    });
  }



  CheckpointOutline
  CheckpointStore::find_newest()
  {
    std::string directory, text;
    on_root(context.communicator, [&]() {
      std::string faults;
      for (const fs::path &candidate : all_checkpoints(root))
        {
          Json              content;
          const std::string fault = fault_of(candidate, content);
          if (fault.empty())
            {
              directory = candidate.string();
              text      = content.dump();
              return;
            }
          faults += "The checkpoint '" + candidate.string() +
                    "' cannot be used: " + fault + ". ";
          context.log.warning("The checkpoint '" + candidate.string() +
                              "' cannot be used: " + fault + ".");
        }
      AssertThrow(false, dealii::ExcMessage(nothing_in(root, faults)));
    });
    directory =
      dealii::Utilities::MPI::broadcast(context.communicator, directory, 0);
    text = dealii::Utilities::MPI::broadcast(context.communicator, text, 0);
    return outline_of(directory, Json::parse(text));
  }
} // namespace Thalweg
