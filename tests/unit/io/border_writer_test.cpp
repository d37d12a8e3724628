#include <sstream>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/mesh_writer.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight {
namespace {

using test::file_bytes;
using test::ScratchFolder;

/// A tetrahedron: core below, undercut on one side, cavity on the others.
SplitMesh sample_split() {
  SplitMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1.0 / 3.0, 0, 0}, {0, 1e-7, 0}, {0, 0, 12345.678}};
  mesh.pieces = {{{0, 2, 1}, 0, Region::core},
                 {{0, 1, 3}, 1, Region::cavity},
                 {{1, 2, 3}, 2, Region::cavity},
                 {{2, 0, 3}, 3, Region::undercut}};
  return mesh;
}

/// What is written to a file of this name.
std::string written(const std::string& name) {
  const ScratchFolder folder;
  write_borders(folder.file(name), sample_split());
  return file_bytes(folder.file(name));
}

TEST(BorderWriter, WritesPolylinesInAGroupAPairOfRegions) {
  EXPECT_EQ(written("lines.OBJ"),
            "# moldlight borders of mold-piece regions\n"
            "v 0 1e-07 0\nv 0.3333333333333333 0 0\nv 0 0 0\ng core-cavity\nl 1 2 3\n"
            "g core-undercut\nl 3 1\n"
            "v 0 0 12345.678\ng cavity-undercut\nl 1 4 3\n");
}

TEST(BorderWriter, WritesALineAPoint) {
  EXPECT_EQ(written("lines.csv"),
            "chain,closed,region_a,region_b,x,y,z\n"
            "0,0,core,cavity,0,1e-07,0\n0,0,core,cavity,0.3333333333333333,0,0\n0,0,core,cavity,0,0,0\n"
            "1,0,core,undercut,0,0,0\n1,0,core,undercut,0,1e-07,0\n"
            "2,0,cavity,undercut,0,1e-07,0\n2,0,cavity,undercut,0,0,12345.678\n2,0,cavity,undercut,0,0,0\n");
}

TEST(BorderWriter, ClosesALoopWithItsFirstPoint) {
  const ScratchFolder folder;
  SplitMesh mesh = sample_split();
  for (SplitPiece& piece : mesh.pieces) piece.region = piece.facet == 0 ? Region::undercut : Region::cavity;
  write_borders(folder.file("loop.obj"), mesh);
  std::string text = file_bytes(folder.file("loop.obj"));
  EXPECT_NE(text.find("g cavity-undercut\nl 1 2 3 1\n"), std::string::npos) << text;
  write_borders(folder.file("loop.csv"), mesh);
  std::istringstream lines(file_bytes(folder.file("loop.csv")));
  std::vector<std::string> rows;
  for (std::string line; std::getline(lines, line);) rows.push_back(line);
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_TRUE(rows[1].starts_with("0,1,cavity,undercut,"));
  EXPECT_EQ(rows[1], rows[4]);
}

TEST(BorderWriter, OfOneRegionHasNoLines) {
  const ScratchFolder folder;
  write_borders(folder.file("none.csv"), SplitMesh{});
  EXPECT_EQ(file_bytes(folder.file("none.csv")), "chain,closed,region_a,region_b,x,y,z\n");
  write_borders(folder.file("none.obj"), SplitMesh{});
  EXPECT_EQ(file_bytes(folder.file("none.obj")), "# moldlight borders of mold-piece regions\n");
}

TEST(BorderWriter, LeavesNothingWhereItFails) {
  const ScratchFolder folder;
  EXPECT_THROW(write_borders(folder.file("lines.ply"), sample_split()), UsageError);
  EXPECT_THROW(write_borders(folder.file("missing/lines.obj"), sample_split()), FileError);
  EXPECT_THROW(write_borders(folder.path().string(), sample_split()), UsageError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace moldlight
