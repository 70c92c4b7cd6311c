// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/files.h>
#include <thalweg/simulation/checkpoint_store.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <utility>

namespace Thalweg
{
  namespace fs = std::filesystem;

  namespace
  {
    constexpr unsigned int n_kept      = 2;
    const std::string      part_ending = ".part";
    /// Of one that makes room for another of the same step.
    const std::string replaced_ending = ".replaced";

    std::string
    name_of(const unsigned int step)
    {
      char name[32];
      std::snprintf(name, sizeof(name), "step_%06u", step);
      return name;
    }



    /// The step after which a checkpoint called @p name was written, and
    /// whether that is the name of one.
    std::pair<unsigned int, bool>
    step_of(const std::string &name)
    {
      unsigned int step = 0;
      std::sscanf(name.c_str(), "step_%10u", &step);
      return {step, name == name_of(step)};
    }



    /// Whole checkpoints or not, the newest first.
    std::vector<std::pair<unsigned int, std::string>>
    all_checkpoints(const std::string &root)
    {
      std::vector<std::pair<unsigned int, std::string>> found;
      std::error_code                                   error;
      for (auto entry = fs::directory_iterator(root, error);
           !error && entry != fs::directory_iterator();
           entry.increment(error))
        {
          const auto [step, is_one] =
            step_of(entry->path().filename().string());
          if (is_one && entry->is_directory(error))
            found.emplace_back(step, entry->path().string());
        }
      std::sort(found.rbegin(), found.rend());
      return found;
    }



    /// The path without its last ending, if that is @p ending; or nothing.
    fs::path
    without(const fs::path &path, const std::string &ending)
    {
      return path.extension() == ending ? fs::path(path).replace_extension("")
                                        : fs::path();
    }



    /// Tidies up after runs that were killed while they wrote a checkpoint:
    /// what is half written goes, and one that was to be replaced by another
    /// of the same step comes back if that did not take its place.
    void
    tidy_up(const std::string &root)
    {
      std::vector<fs::path> parts;
      std::error_code       error;
      for (const auto &entry : fs::directory_iterator(root, error))
        if (entry.path().extension() == part_ending)
          parts.push_back(entry.path());
      for (const fs::path &part : parts)
        {
          const fs::path name     = without(part, part_ending);
          const fs::path original = without(name, replaced_ending);
          const fs::path place    = original.empty() ? name : original;
          if (!step_of(place.filename().string()).second)
            continue;
          if (!original.empty() && !fs::exists(place, error))
            rename_file(part, place);
          else
            fs::remove_all(part, error);
        }
    }



    std::string
    nothing_in(const std::string &root, const std::string &faults)
    {
      return "There is no checkpoint to go on from in '" + root + "'. " +
             faults + "Run without --resume; the run then starts from time 0.";
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



  std::string
  CheckpointStore::write(CheckpointOutline        outline,
                         const CheckpointContent &content)
  {
    const std::string part = root + "/" + name_of(outline.step) + part_ending;
    try
      {
        on_root(context.communicator, [&]() {
          make_directory(root);
          tidy_up(root);
          make_directory(part);
        });
        write_files(part, outline, content);
        on_root(context.communicator, [&]() { take_over(part, outline.step); });
      }
    catch (const dealii::ExcMessage &failure)
      {
        std::error_code error;
        if (context.is_root)
          fs::remove_all(part, error);
        return message_of(failure);
      }
    return "";
  }



  void
  CheckpointStore::write_files(const std::string       &directory,
                               CheckpointOutline       &outline,
                               const CheckpointContent &content) const
  {
    namespace MPI = dealii::Utilities::MPI;
    CheckpointFile own;
    on_all(context.communicator, [&]() {
      own = write_cells(directory + "/" +
                          CheckpointNames::cells(
                            MPI::this_mpi_process(context.communicator)),
                        content.cells,
                        content.packed);
    });
    const std::vector<std::uint64_t> numbers{own.size,
                                             own.checksum,
                                             own.n_cells};
    outline.cells.clear();
    for (const auto &n : MPI::gather(context.communicator, numbers))
      outline.cells.push_back({n[0], n[1], n[2]});
    on_root(context.communicator, [&]() {
      write_file(directory + "/" + CheckpointNames::values,
                 content.values,
                 Durability::on_disk);
      outline.values = {content.values.size(),
                        checksum_of({bytes_of(content.values)}),
                        0};
      write_file(directory + "/" + CheckpointNames::manifest,
                 manifest_of(outline),
                 Durability::on_disk);
    });
  }



  void
  CheckpointStore::take_over(const std::string &directory,
                             const unsigned int step) const
  {
    const std::string place    = root + "/" + name_of(step);
    const std::string replaced = place + replaced_ending + part_ending;
    std::error_code   error;
    sync_directory(directory);
    // If the run is killed between the two, tidy_up() brings the old one back.
    if (fs::exists(place, error))
      rename_file(place, replaced);
    rename_file(directory, place);
    sync_directory(root);
    fs::remove_all(replaced, error);
    unsigned int n = 0;
    for (const auto &[other, path] : all_checkpoints(root))
      // Those of later steps were of no use, or the run would have gone on
      // from them.
      if (other > step || ++n > n_kept)
        fs::remove_all(path, error);
  }



  std::string
  CheckpointStore::fault_of(const std::string &directory,
                            CheckpointOutline &outline) const
  {
    namespace MPI    = dealii::Utilities::MPI;
    const auto  rank = MPI::this_mpi_process(context.communicator);
    const auto  n    = MPI::n_mpi_processes(context.communicator);
    std::string fault;
    const auto  look = [&](const std::function<std::string()> &find) {
      try
        {
          fault = find();
        }
      catch (const std::exception &exception)
        {
          fault = message_of(exception);
        }
      const auto all = MPI::all_gather(context.communicator, fault);
      const auto first =
        std::find_if(all.begin(), all.end(), [](const std::string &of_rank) {
          return !of_rank.empty();
        });
      fault = first == all.end() ? "" : *first;
      return !fault.empty();
    };
    if (look([&]() { return read_manifest(directory, outline); }))
      return fault;
    look([&]() {
      std::string found;
      if (rank == 0)
        found =
          fault_of_file(directory, CheckpointNames::values, outline.values);
      for (unsigned int r = rank; r < outline.cells.size() && found.empty();
           r += n)
        found =
          fault_of_file(directory, CheckpointNames::cells(r), outline.cells[r]);
      return found;
    });
    return fault;
  }



  CheckpointOutline
  CheckpointStore::find_newest()
  {
    namespace MPI = dealii::Utilities::MPI;
    on_root(context.communicator, [&]() { tidy_up(root); });
    const std::vector<std::pair<unsigned int, std::string>> candidates =
      MPI::broadcast(context.communicator,
                     context.is_root
                       ? all_checkpoints(root)
                       : std::vector<std::pair<unsigned int, std::string>>());
    std::string faults;
    for (const auto &[step, directory] : candidates)
      {
        CheckpointOutline outline;
        const std::string fault = fault_of(directory, outline);
        if (fault.empty())
          return outline;
        faults +=
          "The checkpoint '" + directory + "' cannot be used: " + fault + ". ";
        context.log.warning("The checkpoint '" + directory +
                            "' cannot be used: " + fault + ".");
      }
    AssertThrow(false, dealii::ExcMessage(nothing_in(root, faults)));
    return {};
  }
} // namespace Thalweg
