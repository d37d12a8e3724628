// Results under their keys: whole, found again, failures giving way to results.
#include "batch/store.hpp"

#include <chrono>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

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

/// What reading the result says is wrong with it; nothing where all is well.
std::string fault_of(const ResultStore& store, const Digest& key) {
  try {
    static_cast<void>(store.read(key, ResultState::done));
  } catch (const FileError& error) {
    const std::string text = error.what();
    return text.substr(text.rfind(": ") + 2);
  }
  return "";
}

TEST(ResultStore, AResultProvesWhatItIs) {
  const ScratchFolder folder;
  const ResultStore store(folder.path().string());
  const Digest key = digest_of("a"), other = digest_of("b");
  const auto file_of = [&](const Digest& of) {
    return fs::path(store.beside(of, Beside::picture)).replace_extension(".json");
  };
  const auto write = [&](const std::string& text) {
    static_cast<void>(folder.write(fs::relative(file_of(key), folder.path()).string(), text));
  };
  const Json result = {{"outcome", "done"}, {"report", {{"area", 12.5}}}};
  for (const Digest& one : {key, other}) store.put(one, ResultState::done, result);
  EXPECT_EQ(fault_of(store, key), "");
  EXPECT_EQ((*store.read(key, ResultState::done))["report"]["area"], 12.5);
  EXPECT_EQ((*store.read(key, ResultState::done))["key"], hex_of(key));

  const std::string text = test::file_bytes(file_of(key).string());
  std::string changed = text;
  changed.replace(changed.find("12.5"), 4, "10.5");
  write(changed);
  EXPECT_EQ(fault_of(store, key), "was changed and does not match its checksum");
  write(result.dump() + "\n");
  EXPECT_EQ(fault_of(store, key), "is damaged and does not end with its checksum");
  fs::copy_file(file_of(other), file_of(key), fs::copy_options::overwrite_existing);
  EXPECT_EQ(fault_of(store, key), "is the result of another part");
  write(text);
  EXPECT_EQ(fault_of(store, key), "");
  fs::resize_file(file_of(key), std::uintmax_t{1} << 40);
  EXPECT_EQ(fault_of(store, key), "is larger than any result (256 MiB)");
  fs::remove(file_of(key));
  ASSERT_EQ(::mkfifo(file_of(key).c_str(), 0600), 0);
  EXPECT_EQ(fault_of(store, key), "is not a regular file") << "a pipe is not waited for";
  fs::remove(file_of(key));
  fs::create_symlink(file_of(other), file_of(key));
  EXPECT_EQ(fault_of(store, key), "is not a regular file");
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
