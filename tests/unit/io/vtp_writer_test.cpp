// VTK PolyData of a mesh in groups, read again by a reader of its own.
#include <vector>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/mesh_writer.hpp"
#include "support/read_vtp.hpp"
#include "support/scratch_folder.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

using test::file_bytes;
using test::ScratchFolder;

TEST(VtpWriter, KeepsEveryNumberToTheBit) {
  const ScratchFolder folder;
  TriangleMesh mesh = test::cup_with_side_hole({}).mesh;
  for (glm::dvec3& vertex : mesh.vertices) vertex = vertex / 3.0 + 1e7;
  std::vector<Region> regions;
  std::vector<double> drafts;
  std::vector<std::int32_t> faces;
  for (std::size_t k = 0; k < mesh.facets.size(); ++k) {
    regions.push_back(k_regions[k % 4]);
    drafts.push_back(1.0 / static_cast<double>(k + 3));
    faces.push_back(static_cast<std::int32_t>(k) - 5);
  }
  const auto values = [&] { return std::vector<FacetValues>{{"draft_deg", drafts}, {"face", faces}}; };
  const std::string path = folder.file("part.vtp");
  write_coloured_mesh(path, {.mesh = mesh, .regions = regions, .unit = "a--->b", .values = values});
  const test::Vtp vtp = test::read_vtp(file_bytes(path));
  EXPECT_EQ(vtp.mesh.vertices, mesh.vertices);
  EXPECT_EQ(vtp.mesh.facets, mesh.facets);
  ASSERT_EQ(vtp.of_facets.size(), 3u);
  EXPECT_EQ(vtp.of_facets.at("draft_deg").values, drafts);
  EXPECT_EQ(vtp.of_facets.at("face").type, "Int32");
  EXPECT_EQ(vtp.of_facets.at("region").type, "Int32");
  for (std::size_t k = 0; k < regions.size(); ++k) {
    EXPECT_EQ(vtp.of_facets.at("face").values[k], faces[k]);
    EXPECT_EQ(vtp.of_facets.at("region").values[k], static_cast<double>(regions[k]));
  }
  // The text that says what it is ends where it should.
  const std::string bytes = file_bytes(path);
  const std::size_t comment = bytes.find("<!--");
  ASSERT_NE(comment, std::string::npos);
  EXPECT_EQ(bytes.find("--", comment + 4), bytes.find("-->\n<VTKFile", comment));
  EXPECT_NE(bytes.find("region: 0 core, 1 cavity, 2 both, 3 undercut -->"), std::string::npos);
  write_coloured_mesh(path, {.mesh = mesh, .regions = regions, .unit = "a--->b", .values = values});
  EXPECT_EQ(file_bytes(path), bytes);
}

TEST(VtpWriter, AsksForValuesOnlyWhereThereIsRoomForThem) {
  const ScratchFolder folder;
  const TriangleMesh mesh = test::cup_with_side_hole({}).mesh;
  const std::vector<Region> regions(mesh.facets.size(), Region::core);
  int asked = 0;
  const auto values = [&] {
    ++asked;
    return std::vector<FacetValues>();
  };
  for (const auto& format : mesh_formats()) {
    const std::string path = folder.file("part." + std::string(format.extension));
    write_coloured_mesh(path, {.mesh = mesh, .regions = regions, .values = values});
    EXPECT_EQ(asked, format.extension == "vtp" ? 1 : 0) << format.extension;
    EXPECT_THROW(write_coloured_mesh(folder.file("none/") + path.substr(path.rfind('/') + 1),
                                     {.mesh = mesh, .regions = regions}),
                 FileError);
  }
}

}  // namespace
}  // namespace moldlight
