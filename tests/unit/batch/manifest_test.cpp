// Plans: what is frozen reads back, keys name content, version and settings, damage is reported.
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "unit/batch/small_batch.hpp"

namespace moldlight::batch {
namespace {

namespace fs = std::filesystem;
using test::file_bytes;
using test::ScratchFolder;

TEST(Manifest, RowsReadBackAsTheyWerePlanned) {
  const ScratchFolder folder;
  Manifest manifest = test_batch::plan(folder.path().string(), 0);
  std::vector<Row> rows(3);
  rows[0].path = "a \"b\"\n,c.stl";
  rows[0].content = digest_of("a");
  rows[1].number = 1;
  rows[1].path = "\xFF.stl";
  rows[1].settings = 1;
  rows[1].content = digest_of("a");
  rows[1].same_as = 0;
  rows[2].number = 2;
  rows[2].path = "none.stl";
  rows[2].fault = "No such file, or directory";
  write_plan(manifest, rows);
  const Manifest read = read_manifest(folder.path().string());
  EXPECT_EQ(read.command, "actions");
  EXPECT_EQ(read.version, "1.2.3");
  EXPECT_EQ(read.parts_folder(), (folder.path().parent_path() / "parts").string());
  ASSERT_EQ(read.settings.size(), 2u);
  EXPECT_EQ(read.settings[1].arguments, std::vector<std::string>{"--tau=2"});
  const std::vector<Row> back = test_batch::rows_of(read);
  ASSERT_EQ(back.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(back[k].number, k);
    EXPECT_EQ(back[k].path, rows[k].path);
    EXPECT_EQ(back[k].settings, rows[k].settings);
    EXPECT_EQ(back[k].content, rows[k].content);
    EXPECT_EQ(back[k].same_as, rows[k].same_as);
    EXPECT_EQ(back[k].fault, rows[k].fault);
  }
}

TEST(Manifest, KeysTellContentVersionCommandAndSettingsApart) {
  const ScratchFolder folder;
  Manifest manifest = test_batch::plan(folder.path().string(), 1);
  Row row = test_batch::rows_of(manifest).front();
  std::set<Digest> keys = {KeyMaker(manifest)(row)};
  row.path = "another name.stl";
  EXPECT_FALSE(keys.insert(KeyMaker(manifest)(row)).second) << "the name is no part of the key";
  row.settings = 1;
  EXPECT_TRUE(keys.insert(KeyMaker(manifest)(row)).second);
  row.settings = 0;
  row.content = digest_of("other");
  EXPECT_TRUE(keys.insert(KeyMaker(manifest)(row)).second);
  row.fault = "gone";
  EXPECT_TRUE(keys.insert(KeyMaker(manifest)(row)).second);
  row.path = "gone, too.stl";
  EXPECT_TRUE(keys.insert(KeyMaker(manifest)(row)).second);
  row.fault.clear();
  manifest.version = "1.2.4";
  EXPECT_TRUE(keys.insert(KeyMaker(manifest)(row)).second);
  manifest.command = "classify";
  EXPECT_TRUE(keys.insert(KeyMaker(manifest)(row)).second);
}

TEST(Manifest, ANewPlanKeepsTheFormerBesideIt) {
  const ScratchFolder folder;
  static_cast<void>(test_batch::plan(folder.path().string(), 2));
  const std::string former = file_bytes(folder.path() / "batch.json");
  static_cast<void>(test_batch::plan(folder.path().string(), 3));
  EXPECT_EQ(read_manifest(folder.path().string()).rows, 3u);
  std::size_t kept = 0;
  for (const auto& entry : fs::directory_iterator(folder.path()))
    if (entry.path().filename() != "batch.json" && file_bytes(entry.path()) == former) ++kept;
  EXPECT_EQ(kept, 1u);
}

TEST(Manifest, WhatIsNoBatchOrDamagedIsTold) {
  const ScratchFolder folder;
  const std::string path = folder.path().string();
  const auto fault = [&]() -> std::string {
    try {
      const Manifest manifest = read_manifest(path);
      static_cast<void>(test_batch::rows_of(manifest));
      return "";
    } catch (const FileError& error) {
      return error.what();
    }
  };
  EXPECT_NE(fault().find("is not a batch"), std::string::npos) << fault();
  for (const char* text : {"", "{", "[]", "{}", "{\"schema\": 1}", "null"}) {
    static_cast<void>(folder.write("batch.json", text));
    EXPECT_NE(fault().find("is damaged"), std::string::npos) << text << ": " << fault();
  }
  static_cast<void>(folder.write("batch.json", R"({"schema": "moldlight.batch/9"})"));
  EXPECT_NE(fault().find("moldlight.batch/9"), std::string::npos) << fault();
  fs::remove(folder.path() / "batch.json");
  const Manifest manifest = test_batch::plan(path, 3);
  EXPECT_EQ(fault(), "");
  const std::string table = file_bytes(folder.path() / manifest.rows_file);
  static_cast<void>(folder.write(manifest.rows_file, table.substr(0, table.size() / 2)));
  EXPECT_NE(fault().find("plan again"), std::string::npos) << fault();
  static_cast<void>(folder.write(manifest.rows_file, table.substr(0, table.rfind("part-2"))));
  EXPECT_NE(fault().find("2 of 3 rows"), std::string::npos) << fault();
  fs::remove(folder.path() / manifest.rows_file);
  EXPECT_NE(fault().find("plan again"), std::string::npos) << fault();
  std::string text = file_bytes(folder.path() / "batch.json");
  text.replace(text.find(manifest.rows_file), manifest.rows_file.size(), "../elsewhere.csv");
  static_cast<void>(folder.write("batch.json", text));
  EXPECT_NE(fault().find("is damaged"), std::string::npos) << fault();
}

TEST(Shards, TakeEveryRowOnce) {
  for (const std::size_t count : {1u, 2u, 7u, 100u}) {
    std::vector<int> taken(50);
    for (std::size_t index = 0; index < count; ++index)
      for (std::size_t row = 0; row < taken.size(); ++row) taken[row] += Shard{index, count}.has(row) ? 1 : 0;
    EXPECT_EQ(taken, std::vector<int>(50, 1)) << count;
  }
}

}  // namespace
}  // namespace moldlight::batch
