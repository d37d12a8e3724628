// Results under their keys: whole, found again, failures giving way to results.
#include "batch/store.hpp"

#include <chrono>
#include <filesystem>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight::batch {
namespace {

namespace fs = std::filesystem;
using test::ScratchFolder;

TEST(ResultStore, AResultIsFoundUnderItsKeyAlone) {
  const ScratchFolder folder;
  const ResultStore store(folder.path().string());
  const Digest key = digest_of("a"), other = digest_of("b");
  EXPECT_EQ(store.state(key), ResultState::missing);
  EXPECT_TRUE(store.index(Progress()).empty()) << "a batch without results";
  EXPECT_FALSE(fs::exists(folder.path() / "results")) << "asking makes nothing";
  store.put(key, ResultState::done, {{"outcome", "done"}});
  EXPECT_EQ(store.state(key), ResultState::done);
  EXPECT_EQ(store.state(other), ResultState::missing);
  EXPECT_EQ(store.index(Progress()), (ResultIndex{{key, ResultState::done}}));
  ASSERT_TRUE(store.read(key, ResultState::done));
  EXPECT_EQ((*store.read(key, ResultState::done))["outcome"], "done");
  EXPECT_FALSE(store.read(other, ResultState::done));
}

TEST(ResultStore, AFailureGivesWayToAResult) {
  const ScratchFolder folder;
  const ResultStore store(folder.path().string());
  const Digest key = digest_of("a");
  store.put(key, ResultState::failed, {{"reason", "no"}});
  EXPECT_EQ(store.state(key), ResultState::failed);
  EXPECT_EQ(store.index(Progress()), (ResultIndex{{key, ResultState::failed}}));
  store.put(key, ResultState::done, {{"outcome", "done"}});
  EXPECT_EQ(store.index(Progress()), (ResultIndex{{key, ResultState::done}}));
  EXPECT_FALSE(store.read(key, ResultState::failed));
}

TEST(ResultStore, StrangeFilesAreNoResults) {
  const ScratchFolder folder;
  const ResultStore store(folder.path().string());
  store.put(digest_of("a"), ResultState::done, {{"outcome", "done"}});
  const fs::path place = fs::path(store.beside(digest_of("a"), Beside::picture)).parent_path();
  for (const std::string& name :
       {std::string("notes.txt"), std::string(64, 'x') + ".json", std::string("a.json"),
        hex_of(digest_of("b")) + ".json.damaged", hex_of(digest_of("c"))})
    static_cast<void>(folder.write((fs::relative(place, folder.path()) / name).string(), "{}"));
  EXPECT_EQ(store.index(Progress()).size(), 1u);
  EXPECT_TRUE(store.those_with(Beside::picture, Progress()).empty());
}

TEST(ResultStore, ADamagedResultIsToldAndSetAside) {
  const ScratchFolder folder;
  const ResultStore store(folder.path().string());
  const Digest key = digest_of("a");
  store.put(key, ResultState::done, {{"outcome", "done"}});
  const std::string file = fs::path(store.beside(key, Beside::picture)).replace_extension(".json").string();
  fs::resize_file(file, 5);
  EXPECT_THROW(static_cast<void>(store.read(key, ResultState::done)), FileError);
  store.set_aside(key, ResultState::done);
  EXPECT_EQ(store.state(key), ResultState::missing);
}

TEST(ResultStore, OldTemporaryFilesGoAndYoungOnesStay) {
  const ScratchFolder folder;
  const ResultStore store(folder.path().string());
  store.put(digest_of("a"), ResultState::done, {{"outcome", "done"}});
  const fs::path place = fs::path(store.beside(digest_of("a"), Beside::picture)).parent_path();
  const fs::path old = place / ".moldlight-1-0.part", young = place / ".moldlight-2-0.part";
  for (const fs::path& file : {old, young})
    static_cast<void>(folder.write(fs::relative(file, folder.path()).string(), "{"));
  fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(1));
  store.remove_leftovers(Progress());
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(young));
  EXPECT_EQ(store.index(Progress()).size(), 1u);
}

}  // namespace
}  // namespace moldlight::batch
