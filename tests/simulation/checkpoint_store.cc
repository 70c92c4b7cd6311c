// SPDX-License-Identifier: LGPL-2.1-or-later
#include <thalweg/core/errors.h>
#include <thalweg/core/files.h>
#include <thalweg/simulation/checkpoint_store.h>

#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

#include "support/files.h"

using namespace Thalweg;
namespace fs = std::filesystem;

namespace
{
  /// A directory with checkpoints that hold next to nothing.
  class Store
  {
  public:
    explicit Store(const std::string &name)
      : context(MPI_COMM_WORLD)
    {
      context.log              = Log(false);
      context.output_directory = own_path(name);
      on_root(context.communicator, [&]() {
        fs::remove_all(context.output_directory);
        fs::create_directories(context.output_directory);
      });
    }

    ~Store()
    {
      MPI_Barrier(context.communicator);
      if (context.is_root)
        fs::remove_all(context.output_directory);
    }

    std::string
    write(const unsigned int step)
    {
      CheckpointOutline outline;
      outline.step = step;
      outline.time = .5 * step;
      CheckpointContent content;
      content.values       = "values";
      content.cells        = {{0, 0, 0}, {1, 2, 3}};
      content.packed.sizes = {3, 2};
      content.packed.bytes = {'a', 'b', 'c', 'd', 'e'};
      return CheckpointStore(context).write(outline, content);
    }

    /// The step of the newest one that is whole; -1: there is none.
    int
    newest()
    {
      try
        {
          return CheckpointStore(context).find_newest().step;
        }
      catch (const dealii::ExcMessage &failure)
        {
          message = message_of(failure);
          return -1;
        }
    }

    std::string
    path(const std::string &name) const
    {
      return context.output_directory + "/checkpoints/" + name;
    }

    std::set<std::string>
    names() const
    {
      MPI_Barrier(context.communicator);
      std::set<std::string> names;
      for (const auto &entry : fs::directory_iterator(path("")))
        names.insert(entry.path().filename().string());
      MPI_Barrier(context.communicator);
      return names;
    }

    /// Changes a manifest on the root process.
    void
    change(const std::string                           &checkpoint,
           const std::function<void(nlohmann::json &)> &how,
           const bool                                   with_checksum) const
    {
      on_root(context.communicator, [&]() {
        const std::string file    = path(checkpoint) + "/manifest.json";
        auto              content = nlohmann::json::parse(read_file(file));
        how(content);
        if (with_checksum)
          {
            content.erase("checksum");
            const std::string text = content.dump();
            content["checksum"]    = checksum_of({bytes_of(text)});
          }
        write_file(file, content.dump());
      });
    }

    Context     context;
    std::string message;
  };

  using Names = std::set<std::string>;
} // namespace



TEST(CheckpointStoreMpi, SortsByNumber)
{
  Store store("numbers");
  for (const unsigned int step : {999998u, 999999u, 1000000u, 1000001u})
    {
      EXPECT_EQ(store.write(step), "");
      EXPECT_EQ(store.newest(), int(step));
    }
  EXPECT_EQ(store.names(), (Names{"step_1000000", "step_1000001"}));
}



// Killed while one of the same step took its place: there is one of the two.
TEST(CheckpointStoreMpi, FindsTheOneThatWasBeingReplaced)
{
  Store store("replaced");
  store.write(1);
  store.write(2);
  EXPECT_EQ(store.write(2), "");
  EXPECT_EQ(store.names(), (Names{"step_000001", "step_000002"}));
  on_root(store.context.communicator, [&]() {
    fs::rename(store.path("step_000002"),
               store.path("step_000002.replaced.part"));
    fs::create_directory(store.path("step_000002.part"));
  });
  EXPECT_EQ(store.newest(), 2);
  EXPECT_EQ(store.names(), (Names{"step_000001", "step_000002"}));
  on_root(store.context.communicator, [&]() {
    fs::create_directory(store.path("step_000002.replaced.part"));
  });
  EXPECT_EQ(store.newest(), 2);
  EXPECT_EQ(store.names(), (Names{"step_000001", "step_000002"}));
}



TEST(CheckpointStoreMpi, LeavesWhatIsNotItsOwn)
{
  Store store("foreign");
  store.write(1);
  const Names foreign{"step_000009.bak", "step_9", "zzz", "step_00000x"};
  on_root(store.context.communicator, [&]() {
    for (const std::string &name : foreign)
      fs::copy(store.path("step_000001"), store.path(name));
    fs::create_directory(store.path("step_000007.part"));
  });
  EXPECT_EQ(store.newest(), 1);
  for (const unsigned int step : {2u, 3u, 4u})
    store.write(step);
  Names expected = foreign;
  expected.insert({"step_000003", "step_000004"});
  EXPECT_EQ(store.names(), expected);
}



TEST(CheckpointStoreMpi, HoldsWhatWasInMemory)
{
  Store store("content");
  store.write(1);
  const CheckpointOutline found = CheckpointStore(store.context).find_newest();
  EXPECT_EQ(found.time, .5);
  const unsigned int n =
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  ASSERT_EQ(found.cells.size(), n);
  // From the second cell of the first rank on.
  const auto cells  = read_curve_cells(found, 1, 2 * n);
  const auto packed = read_packed_cells(found, 1, 2 * n);
  ASSERT_EQ(cells.size(), 2 * n - 1);
  EXPECT_EQ(cells[0], (CurveCell{1, 2, 3}));
  EXPECT_EQ(packed.sizes.size(), 2 * n - 1);
  EXPECT_EQ(std::string(packed.bytes.begin(), packed.bytes.end()).substr(0, 2),
            "de");
}



TEST(CheckpointStoreMpi, ThatCannotBeWrittenLeavesTheOldOnes)
{
  Store store("full");
  store.write(1);
  store.write(2);
  on_root(store.context.communicator, [&]() {
    // A file is where the directory of the next one must be.
    std::ofstream(store.path("step_000003.part")) << "x";
    fs::permissions(store.path("step_000003.part"), fs::perms::none);
  });
  // Such a file is removed, but not a name that is too long for any.
  EXPECT_EQ(store.write(3), "");
  on_root(store.context.communicator, [&]() {
    fs::rename(store.path(""), store.context.output_directory + "/elsewhere");
    std::ofstream(store.context.output_directory + "/checkpoints") << "x";
  });
  const std::string failure = store.write(4);
  EXPECT_NE(failure.find("/checkpoints"), std::string::npos) << failure;
  on_root(store.context.communicator, [&]() {
    fs::remove(store.context.output_directory + "/checkpoints");
    fs::rename(store.context.output_directory + "/elsewhere", store.path(""));
  });
  EXPECT_EQ(store.names(), (Names{"step_000002", "step_000003"}));
  EXPECT_EQ(store.newest(), 3);
}



TEST(CheckpointStoreMpi, FallsBackOverDamagedManifests)
{
  using nlohmann::json;
  Store      store("manifests");
  const auto expect_refused = [&](const std::function<void(json &)> &how,
                                  const bool with_checksum) {
    store.write(1);
    store.write(2);
    store.change("step_000002", how, with_checksum);
    EXPECT_EQ(store.newest(), 1);
    store.change("step_000001", how, with_checksum);
    EXPECT_EQ(store.newest(), -1);
    EXPECT_NE(store.message.find("step_000001"), std::string::npos);
    EXPECT_LT(store.message.size(), 2000u);
  };
  expect_refused([](json &m) { m["time"] = 7.; }, false);
  for (const std::string name : {"format",
                                 "step",
                                 "time",
                                 "coarse mesh",
                                 "values",
                                 "cells of ranks",
                                 "settings"})
    for (const json &value : {json(),
                              json(-1),
                              json(1e300),
                              json("text"),
                              json::array({1}),
                              json::object({{"a", 1}})})
      // Any time can be.
      if (name != "time" || value != 1e300)
        expect_refused(
          [&](json &m) {
            if (value.is_null())
              m.erase(name);
            else
              m[name] = value;
          },
          true);
  for (const std::string number : {"size", "checksum", "cells"})
    expect_refused(
      [&](json &m) {
        m["cells of ranks"][0][number] =
          std::numeric_limits<std::int64_t>::max();
      },
      true);
  expect_refused([](json &m) { m["cells of ranks"] = json::array(); }, true);
  expect_refused([](json &m) { m["step"] = 1ull << 40; }, true);
}



TEST(CheckpointStoreMpi, RefusesManifestsThatAreNone)
{
  Store store("no_manifests");
  for (const std::string &text : {std::string("[1, 2]"),
                                  std::string(100000, '['),
                                  std::string(1 << 25, ' '),
                                  std::string("\0\xff", 2),
                                  std::string()})
    {
      store.write(1);
      store.write(2);
      on_root(store.context.communicator, [&]() {
        write_file(store.path("step_000002/manifest.json"), text);
      });
      EXPECT_EQ(store.newest(), 1);
    }
}
