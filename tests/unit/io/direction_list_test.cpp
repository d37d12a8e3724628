#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/csv_tables.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight {
namespace {

std::vector<glm::dvec3> directions_read(const std::string& text) {
  const test::ScratchFolder folder;
  return read_directions(folder.write("list.csv", text), Progress());
}

std::string error_of(const std::string& text) {
  const test::ScratchFolder folder;
  const std::string path = folder.write("list.csv", text);
  try {
    static_cast<void>(read_directions(path, Progress()));
  } catch (const FileError& error) {
    return std::string(error.what()).substr(path.size() + 2);
  }
  return "no error";
}

TEST(DirectionList, TakesCommasSemicolonsAndSpaces) {
  const std::vector<glm::dvec3> expected = {{0, 0, 1}, {0.5, -0.5, 1e-3}, {-1, 0, 0}};
  EXPECT_EQ(directions_read("0,0,1\n0.5 ; -0.5 ; 1e-3\r\n  -1\t0  0\n"), expected);
}

TEST(DirectionList, LeavesNamesCommentsAndFurtherColumnsAside) {
  const std::vector<glm::dvec3> expected = {{0, 0, 1}, {0, 1, 0}};
  EXPECT_EQ(directions_read("x,y,z,undercut\n# two pulls\n\n0,0,1,12.5\n0,1,0,0\n"), expected);
}

TEST(DirectionList, NamesTheLineThatIsWrong) {
  EXPECT_EQ(error_of("0,0,1\n0,1\n"),
            "line 2: '0,1' is not a direction; write three numbers x, y, z, not all zero");
  EXPECT_TRUE(error_of("0,0,1\nx,y,z\n").starts_with("line 2: "));
  EXPECT_TRUE(error_of("0,0,0\n").starts_with("line 1: "));
  EXPECT_TRUE(error_of("0,0,nan\n").starts_with("line 1: "));
  EXPECT_TRUE(error_of("# nothing\n\nx,y,z\n").starts_with("holds no direction"));
  EXPECT_NE(error_of(""), "no error");
}

}  // namespace
}  // namespace moldlight
