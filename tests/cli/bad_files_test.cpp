// Files that are damaged, hostile or no parts at all: a clear line or a warned result, soon and in little
// memory.
#include <algorithm>
#include <filesystem>
#include <iostream>

#include <gtest/gtest.h>

#include "cli/small_part.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;

constexpr double k_time_limit_s = 5.0;
constexpr std::size_t k_bad_file_memory = std::size_t{1} << 30;

void expect_clear_end(const std::string& file) {
  for (const char* command : {"info", "classify"}) {
    std::vector<std::string> arguments = {command, file};
    if (arguments.front() == "classify") arguments.insert(arguments.end(), {"--direction", "0,0,1"});
    test::ProcessSettings settings;
    settings.address_space_limit = 4 * k_bad_file_memory;
    const auto run = test::run_moldlight(arguments, settings);
    if (!test::built_with_sanitizers()) {
      EXPECT_LT(run.processor_s, k_time_limit_s) << file;
      EXPECT_LT(run.peak_memory, k_bad_file_memory) << file;
    }
    if (run.exit_code == 1) {
      EXPECT_EQ(run.error_lines(), 1u) << run.err;
      EXPECT_TRUE(run.err.starts_with("moldlight: ")) << run.err;
      EXPECT_NE(run.err.find(fs::path(file).filename().string()), std::string::npos) << run.err;
      EXPECT_EQ(run.out, "");
    } else {
      ASSERT_EQ(run.exit_code, 0) << file << ": " << run.err;
      const bool warned =
          run.err.find("warning: ") != std::string::npos || run.out.find("warning: ") != std::string::npos;
      EXPECT_TRUE(warned) << file << " went through without a word";
    }
  }
}

TEST(BadFiles, OfOurOwnEndClearly) {
  const test::SmallPart part;
  const test::ScratchFolder folder;
  const std::string good = test::file_bytes(part.file());
  std::string binary(84, '\0');
  binary[80] = 7;
  expect_clear_end(folder.write("empty.obj", ""));
  expect_clear_end(folder.write("zeros.stl", std::string(5000, '\0')));
  expect_clear_end(folder.write("seven_facets_missing.stl", binary));
  expect_clear_end(folder.write("cut.obj", good.substr(0, good.size() / 2)));
  expect_clear_end(folder.write("no_part.txt", "Lorem ipsum dolor sit amet\n"));
  expect_clear_end(folder.write("no_name",
                                "\x7F"
                                "ELF and so on"));
  expect_clear_end(folder.write("flat.stl",
                                "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0 0\n"
                                "vertex 0 0 0\nendloop\nendfacet\nendsolid a\n"));
}

TEST(BadFiles, OfTheSharedFolderEndClearly) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no shared parts";
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(*shared / "parts" / "bad"))
    files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  for (const std::string& file : files) expect_clear_end(file);
  std::cout << files.size() << " bad files used\n";
  EXPECT_GE(files.size(), 22u);
}

}  // namespace
}  // namespace moldlight
