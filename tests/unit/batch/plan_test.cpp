// What a folder, a pattern and a list name, and what becomes of files that are missing or the same.
#include "batch/plan.hpp"

#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight::batch {
namespace {

namespace fs = std::filesystem;
using test::ScratchFolder;

std::vector<std::string> paths_of(const PlanSource& source) {
  std::vector<std::string> paths;
  for (const PlanEntry& entry : source.entries) paths.push_back(entry.path);
  return paths;
}

RowSettings made(const std::vector<NamedValue>& row) {
  RowSettings settings;
  settings.effective = Json::object();
  for (const auto& [name, value] : row) {
    if (name == "colour") throw UsageError("there is no option --colour");
    settings.effective[name] = value;
  }
  return settings;
}

std::string fault_of(const std::string& source) {
  try {
    static_cast<void>(read_plan_source(source, Progress()));
    return "";
  } catch (const FileError& error) {
    return error.what();
  }
}

TEST(PlanSource, AFolderGivesItsPartFilesInOrder) {
  const ScratchFolder folder;
  for (const char* name : {"b.stl", "a b.STL", "sub/c.obj", "notes.txt", ".hidden.stl", ".git/d.stl"}) {
    fs::create_directories((folder.path() / name).parent_path());
    static_cast<void>(folder.write(name, "x"));
  }
  const PlanSource source = read_plan_source(folder.path().string(), Progress());
  EXPECT_EQ(source.parts, folder.path().string());
  EXPECT_EQ(paths_of(source), (std::vector<std::string>{"a b.STL", "b.stl", "sub/c.obj"}));
  EXPECT_NE(fault_of(folder.file("sub/..") + "/.git/none").find("no such folder"), std::string::npos);
  fs::create_directories(folder.path() / "empty");
  EXPECT_NE(fault_of(folder.file("empty")).find("holds no part file"), std::string::npos);
}

TEST(PlanSource, AFolderGivesNothingThatLiesOutsideOfIt) {
  const ScratchFolder folder;
  for (const char* name : {"in/a.stl", "outside.stl", "inside-out/b.stl"}) {
    fs::create_directories((folder.path() / name).parent_path());
    static_cast<void>(folder.write(name, "x"));
  }
  fs::create_symlink("a.stl", folder.path() / "in/same.stl");
  fs::create_symlink("../outside.stl", folder.path() / "in/out.stl");
  fs::create_symlink("../inside-out/b.stl", folder.path() / "in/beside.stl");
  fs::create_directory_symlink("../inside-out", folder.path() / "in/folder");
  const PlanSource source = read_plan_source(folder.file("in"), Progress());
  EXPECT_EQ(paths_of(source), (std::vector<std::string>{"a.stl", "same.stl"}));
  EXPECT_EQ(source.left_out, 2u);
}

TEST(PlanSource, APatternGivesTheFilesThatFit) {
  const ScratchFolder folder;
  for (const char* name : {"one/a.stl", "two/a.stl", "two/b.obj", "one/[a].stl"}) {
    fs::create_directories((folder.path() / name).parent_path());
    static_cast<void>(folder.write(name, "x"));
  }
  const PlanSource source = read_plan_source(folder.file("*/a.stl"), Progress());
  EXPECT_EQ(source.parts, folder.path().string());
  EXPECT_EQ(paths_of(source), (std::vector<std::string>{"one/a.stl", "two/a.stl"}));
  const PlanSource literal = read_plan_source(folder.file("one/[a].stl"), Progress());
  EXPECT_EQ(paths_of(literal), std::vector<std::string>{"[a].stl"}) << "a name that looks like a pattern";
  EXPECT_NE(fault_of(folder.file("*.ply")).find("no file matches"), std::string::npos);
}

TEST(PlanSource, AListGivesPathsAndSettingsOfItsRows) {
  const ScratchFolder folder;
  const std::string list =
      folder.write("list.csv", "unit,path,direction\nmm,\"a\n\"\"b\"\".stl\",\n,/c.stl,\"0,0,1\"\n");
  const PlanSource source = read_plan_source(list, Progress());
  EXPECT_EQ(source.parts, folder.path().string());
  ASSERT_EQ(paths_of(source), (std::vector<std::string>{"a\n\"b\".stl", "/c.stl"}));
  EXPECT_EQ(source.entries[0].settings, (std::vector<NamedValue>{{"unit", "mm"}}));
  EXPECT_EQ(source.entries[1].settings, (std::vector<NamedValue>{{"direction", "0,0,1"}}));
  EXPECT_EQ(paths_of(read_plan_source(folder.write("s.csv", "path;tau\nb.stl;2\n"), Progress())),
            std::vector<std::string>{"b.stl"});
  const auto fault = [&](const char* text) { return fault_of(folder.write("bad.csv", text)); };
  EXPECT_NE(fault("").find("no column `path`"), std::string::npos);
  EXPECT_NE(fault("file\na.stl\n").find("no column `path`"), std::string::npos);
  EXPECT_NE(fault("path\n").find("names no part"), std::string::npos);
  EXPECT_NE(fault("path,unit\na.stl\n").find("line 2: has 1 fields, not 2"), std::string::npos);
  EXPECT_NE(fault("path,unit\n,mm\n").find("line 2: the path is empty"), std::string::npos);
}

TEST(PlanRows, SameContentWithSameSettingsIsDoneOnce) {
  const ScratchFolder folder;
  static_cast<void>(folder.write("a.stl", "1"));
  static_cast<void>(folder.write("b.stl", "1"));
  static_cast<void>(folder.write("c.stl", "2"));
  const std::string list = folder.write(
      "list.csv", "path,unit\na.stl,mm\nb.stl,mm\na.stl,in\nc.stl,mm\nnone.stl,mm\na.stl,mm\nnone.stl,mm\n");
  Manifest manifest;
  manifest.folder = folder.file("batch");
  manifest.version = "1";
  manifest.command = "classify";
  const std::vector<Row> rows = plan_rows(manifest, read_plan_source(list, Progress()), made, Progress());
  EXPECT_EQ(manifest.parts, "..");
  ASSERT_EQ(rows.size(), 7u);
  const std::vector<std::optional<std::size_t>> same = {{}, 0, {}, {}, {}, 0, 4};
  for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_EQ(rows[k].same_as, same[k]) << k;
  EXPECT_EQ(rows[0].content, digest_of("1"));
  EXPECT_EQ(rows[4].fault, "No such file or directory");
  EXPECT_EQ(manifest.settings.size(), 2u) << "equal settings are kept once";
}

TEST(PlanRows, ASettingThatIsRefusedIsNamedWithItsLine) {
  const ScratchFolder folder;
  static_cast<void>(folder.write("a.stl", "1"));
  const std::string list = folder.write("list.csv", "path,colour\na.stl,\na.stl,red\n");
  Manifest manifest;
  manifest.folder = folder.file("batch");
  manifest.source = list;
  try {
    static_cast<void>(plan_rows(manifest, read_plan_source(list, Progress()), made, Progress()));
    FAIL() << "nothing was thrown";
  } catch (const UsageError& error) {
    EXPECT_EQ(error.what(), list + ": line 3: there is no option --colour");
  }
}

TEST(PlanRows, PathsAreRelativeToTheBatchWhereTheyMoveWithIt) {
  const ScratchFolder folder;
  fs::create_directories(folder.path() / "share/parts");
  static_cast<void>(folder.write("share/parts/a.stl", "1"));
  Manifest manifest;
  manifest.folder = folder.file("share/nights/one");
  const PlanSource source = read_plan_source(folder.file("share/parts"), Progress());
  static_cast<void>(plan_rows(manifest, source, made, Progress()));
  EXPECT_EQ(manifest.parts, "../../parts");
  EXPECT_EQ(fs::weakly_canonical(manifest.parts_folder()),
            fs::weakly_canonical(folder.path() / "share/parts"));
  manifest.folder = "/night";
  static_cast<void>(plan_rows(manifest, source, made, Progress()));
  EXPECT_EQ(manifest.parts, folder.file("share/parts")) << "nothing in common but the root";
}

}  // namespace
}  // namespace moldlight::batch
