#include "io/mesh_writer.hpp"

#include <csignal>
#include <cstring>
#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "base/error.hpp"
#include "io/part_formats.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight {
namespace {

using test::file_bytes;
using test::ScratchFolder;

/// Eleven facets over shared vertices, of irregular coordinates, in an order that no sort leaves as it is.
TriangleMesh sample_mesh() {
  TriangleMesh mesh;
  for (int i = 0; i < 13; ++i) mesh.vertices.emplace_back(0.1 * i * i, 1.0 / (i + 3), -1e-7 * i);
  for (VertexIndex k = 0; k < 11; ++k) {
    const VertexIndex first = (k * 7) % 11;
    mesh.facets.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

std::vector<Region> sample_regions() {
  std::vector<Region> regions;
  for (std::size_t k = 0; k < 11; ++k) regions.push_back(k_regions[(k * 5 / 2) % 4]);
  return regions;
}

TEST(MeshWriter, WritesObjThatReadsBackTheSame) {
  const ScratchFolder folder;
  const TriangleMesh mesh = sample_mesh();
  const std::vector<Region> regions = sample_regions();
  const std::string path = folder.file("part.obj");
  write_coloured_mesh(path, {mesh, regions, Palette::paper, "mm"});
  const Part back = read_part(path, {}, Progress());
  ASSERT_EQ(back.mesh.facets.size(), mesh.facets.size());
  for (FacetIndex k = 0; k < mesh.facets.size(); ++k) {
    for (int corner = 0; corner < 3; ++corner) EXPECT_EQ(back.mesh.corner(k, corner), mesh.corner(k, corner));
  }
  const std::string text = file_bytes(path);
  EXPECT_TRUE(text.starts_with("# moldlight mold-piece regions, unit mm\nmtllib part.mtl\n"));
  EXPECT_NE(file_bytes(folder.file("part.mtl")).find("newmtl undercut\nKd 0.8471 0.1647 0.1647\n"),
            std::string::npos);
  // The material in force at each face is its region.
  std::string material;
  std::size_t facet = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("usemtl ")) material = line.substr(7);
    if (!line.starts_with("f ")) continue;
    EXPECT_EQ(material, region_name(regions[facet++]));
  }
  EXPECT_EQ(facet, mesh.facets.size());
}

TEST(MeshWriter, LeavesNoMaterialsWhereThereIsNoRoomForTheMesh) {
  const ScratchFolder folder;
  TriangleMesh mesh = sample_mesh();
  mesh.vertices.resize(5000, glm::dvec3(1.0 / 3.0));
  rlimit before = {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small = {10'000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(write_coloured_mesh(folder.file("part.obj"), {mesh, sample_regions(), Palette::paper, "mm"}),
               FileError);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  static_cast<void>(std::signal(SIGXFSZ, handler));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(MeshWriter, WritesStlWithColoursInTheAttributes) {
  const ScratchFolder folder;
  const TriangleMesh mesh = sample_mesh();
  const std::vector<Region> regions = sample_regions();
  const std::string path = folder.file("part.STL");
  write_coloured_mesh(path, {mesh, regions, Palette::paper, ""});
  const Part back = read_part(path, {}, Progress());
  EXPECT_EQ(back.format, "STL binary");
  ASSERT_EQ(back.mesh.facets.size(), mesh.facets.size());
  const std::string bytes = file_bytes(path);
  EXPECT_FALSE(bytes.starts_with("solid"));
  for (FacetIndex k = 0; k < mesh.facets.size(); ++k) {
    EXPECT_EQ(glm::vec3(back.mesh.corner(k, 1)), glm::vec3(mesh.corner(k, 1)));
    std::uint16_t attribute = 0;
    std::memcpy(&attribute, bytes.data() + 84 + 50 * k + 48, 2);
    const Colour colour = region_colour(regions[k], Palette::paper);
    EXPECT_TRUE(attribute & 0x8000);
    EXPECT_NEAR((attribute >> 10 & 31) / 31.0, colour.r / 255.0, 0.02);
    EXPECT_NEAR((attribute >> 5 & 31) / 31.0, colour.g / 255.0, 0.02);
    EXPECT_NEAR((attribute & 31) / 31.0, colour.b / 255.0, 0.02);
  }
}

TEST(MeshWriter, WritesPlyWithColoursAndRegions) {
  const ScratchFolder folder;
  const TriangleMesh mesh = sample_mesh();
  const std::vector<Region> regions = sample_regions();
  const std::string path = folder.file("part.ply");
  write_coloured_mesh(path, {mesh, regions, Palette::colour_blind_safe, "in"});
  const std::string bytes = file_bytes(path);
  EXPECT_NE(bytes.find("comment moldlight mold-piece regions, unit in\n"), std::string::npos);
  const std::size_t body = bytes.find("end_header\n") + 11;
  ASSERT_EQ(bytes.size(), body + 13 * 24 + 11 * 17);
  for (std::size_t k = 0; k < 11; ++k) {
    const char* row = bytes.data() + body + 13 * 24 + 17 * k;
    EXPECT_EQ(row[0], 3);
    EXPECT_EQ(std::memcmp(row + 1, mesh.facets[k].data(), 12), 0);
    const Colour colour = region_colour(regions[k], Palette::colour_blind_safe);
    EXPECT_EQ(std::memcmp(row + 13, &colour, 3), 0);
    EXPECT_EQ(static_cast<Region>(row[16]), regions[k]);
  }
}

TEST(MeshWriter, SplitsByRegion) {
  const ScratchFolder folder;
  const TriangleMesh mesh = sample_mesh();
  std::vector<Region> regions = sample_regions();
  const std::string split = folder.file("new/split");
  EXPECT_EQ(write_region_stls(split, "cap", {mesh, regions}).size(), 4u);
  for (Region& region : regions) region = region == Region::undercut ? Region::core : region;
  const std::vector<std::string> paths = write_region_stls(split, "cap", {mesh, regions});
  ASSERT_EQ(paths.size(), 3u);
  EXPECT_EQ(paths[0], split + "/cap_core.stl");
  EXPECT_FALSE(std::filesystem::exists(split + "/cap_undercut.stl"));
  std::size_t facets = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Part back = read_part(paths[i], {}, Progress());
    FacetIndex next = 0;
    for (FacetIndex k = 0; k < mesh.facets.size(); ++k) {
      if (regions[k] != k_regions[i]) continue;
      EXPECT_EQ(glm::vec3(back.mesh.corner(next++, 2)), glm::vec3(mesh.corner(k, 2)));
    }
    EXPECT_EQ(next, back.mesh.facets.size());
    facets += next;
  }
  EXPECT_EQ(facets, mesh.facets.size());
}

TEST(MeshWriter, LeavesNothingWhereItFails) {
  const ScratchFolder folder;
  const TriangleMesh mesh = sample_mesh();
  const std::vector<Region> regions = sample_regions();
  EXPECT_THROW(write_coloured_mesh(folder.file("part.off"), {mesh, regions}), UsageError);
  EXPECT_THROW(write_coloured_mesh(folder.file("missing/part.ply"), {mesh, regions}), FileError);
  EXPECT_THROW(write_region_stls(folder.write("file", "") + "/split", "a", {mesh, regions}), FileError);
  // The materials cannot be written, so the mesh stays as it was.
  const std::string old = folder.write("part.obj", "old");
  std::filesystem::create_directory(folder.file("part.mtl"));
  EXPECT_THROW(write_coloured_mesh(old, {mesh, regions}), FileError);
  EXPECT_EQ(file_bytes(old), "old");
}

}  // namespace
}  // namespace moldlight
