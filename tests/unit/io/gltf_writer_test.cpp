// Binary glTF of a mesh in groups, read again by a reader of its own.
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "io/mesh_writer.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/health.hpp"
#include "support/read_glb.hpp"
#include "support/scratch_folder.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

using test::file_bytes;
using test::Glb;
using test::ScratchFolder;

/// Facets of a closed shape in all regions but one.
std::vector<Region> some_regions(const TriangleMesh& mesh) {
  std::vector<Region> regions;
  for (std::size_t k = 0; k < mesh.facets.size(); ++k)
    regions.push_back(k % 5 == 0 ? Region::undercut : k % 2 == 0 ? Region::core : Region::cavity);
  return regions;
}

void move_by(TriangleMesh& mesh, const glm::dvec3& way) {
  for (glm::dvec3& vertex : mesh.vertices) vertex += way;
}

TEST(GltfWriter, HasAPrimitiveAndAMaterialARegion) {
  const ScratchFolder folder;
  const TriangleMesh mesh = test::cup_with_side_hole({}).mesh;
  const std::vector<Region> regions = some_regions(mesh);
  const std::string path = folder.file("part.GLB");
  write_coloured_mesh(path, {mesh, regions, Palette::paper, "mm", "cup \"1\".stl"});
  const Glb glb(file_bytes(path));
  const std::size_t node = glb.node("cup \"1\".stl");
  const auto& primitives =
      glb.json()["meshes"].at(glb.json()["nodes"][node]["mesh"].get<std::size_t>())["primitives"];
  ASSERT_EQ(primitives.size(), 3u) << "no facet is of both";
  EXPECT_EQ(glb.json()["materials"].size(), 3u);
  EXPECT_FALSE(glb.json().contains("animations"));
  const FacetGeometry geometry = facet_geometry(mesh);
  RegionValues areas, written;
  for (std::size_t k = 0; k < regions.size(); ++k) areas[regions[k]] += geometry.areas[k];
  std::vector<TriangleMesh> meshes;
  for (const auto& primitive : primitives) {
    meshes.push_back(glb.mesh(primitive));
    for (const Region region : k_regions)
      if (glb.material(primitive) == region_name(region))
        written[region] += facet_geometry(meshes.back()).total_area;
  }
  for (const Region region : k_regions) EXPECT_NEAR(written[region], areas[region], 1e-6 * areas.total());
  const TriangleMesh whole = test::joined(meshes);
  EXPECT_TRUE(health_report(whole, facet_geometry(whole)).closed);
  // The undercuts' red, #D82A2A, as light.
  const auto& red = glb.json()["materials"][2];
  EXPECT_EQ(red["name"], "undercut");
  EXPECT_NEAR(red["pbrMetallicRoughness"]["baseColorFactor"][0].get<double>(), 0.686, 1e-3);
  EXPECT_NEAR(red["pbrMetallicRoughness"]["baseColorFactor"][1].get<double>(), 0.0232, 1e-3);
  write_coloured_mesh(folder.file("again.glb"), {mesh, regions, Palette::paper, "mm", "cup \"1\".stl"});
  EXPECT_EQ(file_bytes(folder.file("again.glb")), file_bytes(path));
}

TEST(GltfWriter, StandsUprightInMetres) {
  const ScratchFolder folder;
  const TriangleMesh mesh = test::cup_with_side_hole({}).mesh;
  const std::vector<Region> regions(mesh.facets.size(), Region::core);
  for (const auto& [unit, metres] : {std::pair("mm", 0.001), {"in", 0.0254}, {"", 1.0}}) {
    const std::string path = folder.file("part.glb");
    write_coloured_mesh(path, {mesh, regions, Palette::paper, unit, "cup"});
    const Glb glb(file_bytes(path));
    const glm::dmat4 placed = glb.placed(glb.node("cup"));
    const TriangleMesh back = glb.mesh(glb.json()["meshes"][0]["primitives"][0]);
    for (FacetIndex k = 0; k < mesh.facets.size(); ++k) {
      const glm::dvec3 at = glm::dvec3(placed * glm::dvec4(back.corner(k, 0), 1.0)) / metres;
      const glm::dvec3& from = mesh.corner(k, 0);
      EXPECT_NEAR(glm::length(at - glm::dvec3(from.x, from.z, -from.y)), 0.0, 1e-5);
    }
  }
}

TEST(GltfWriter, KeepsTheDigitsOfAPartFarAway) {
  const ScratchFolder folder;
  TriangleMesh mesh = test::cup_with_side_hole({}).mesh;
  const glm::dvec3 away(1e7, -3e7, 123456.789);
  move_by(mesh, away);
  const std::vector<Region> regions(mesh.facets.size(), Region::core);
  write_coloured_mesh(folder.file("part.glb"), {mesh, regions, Palette::paper, "m", "cup"});
  const Glb glb(file_bytes(folder.file("part.glb")));
  const glm::dmat4 placed = glb.placed(glb.node("cup"));
  const TriangleMesh back = glb.mesh(glb.json()["meshes"][0]["primitives"][0]);
  EXPECT_LT(glm::length(back.vertices[0]), bounds(mesh).diagonal());
  for (FacetIndex k = 0; k < mesh.facets.size(); ++k) {
    const glm::dvec3 at(placed * glm::dvec4(back.corner(k, 2), 1.0));
    const glm::dvec3& from = mesh.corner(k, 2);
    EXPECT_NEAR(glm::length(at - glm::dvec3(from.x, from.z, -from.y)), 0.0, 1e-5);
  }
}

TEST(GltfWriter, MovesSolidsAlongTheirWays) {
  const ScratchFolder folder;
  const TriangleMesh mesh = test::cup_with_side_hole({}).mesh;
  const std::vector<MeshGroup> groups = {{"part", {200, 200, 200}}};
  const std::vector<std::uint32_t> of_facet(mesh.facets.size(), 0);
  const glm::dvec3 axis_point(3.0, 0.0, 1.0);
  const std::vector<MovingSolid> solids = {
      {.name = "body_of_slide_1", .mesh = mesh, .colour = {255, 0, 0}, .way = {-12.5, 0.0, 0.0}},
      {.name = "body_of_unscrew_2",
       .mesh = mesh,
       .colour = {0, 255, 0},
       .way = {0.0, 0.0, 4.0},
       .point = axis_point,
       .turn_rad = -5.0 * std::numbers::pi}};
  write_glb(folder.file("part.glb"),
            {.mesh = mesh, .groups = groups, .of_facet = of_facet, .solids = solids});
  const Glb glb(file_bytes(folder.file("part.glb")));
  ASSERT_EQ(glb.json()["animations"].size(), 1u);
  const auto& opening = glb.json()["animations"][0];
  EXPECT_EQ(opening["name"], "opening");
  ASSERT_EQ(opening["channels"].size(), 3u);
  const auto values = [&](std::size_t channel, const char* which) {
    return glb.floats(opening["samplers"][opening["channels"][channel]["sampler"].get<std::size_t>()][which]);
  };
  EXPECT_EQ(opening["channels"][0]["target"]["node"], glb.node("body_of_slide_1"));
  EXPECT_EQ(opening["channels"][0]["target"]["path"], "translation");
  EXPECT_EQ(values(0, "input"), (std::vector<float>{0, 2}));
  EXPECT_EQ(values(0, "output"), (std::vector<float>{0, 0, 0, -12.5, 0, 0}));
  // Two turns and a half about z, in steps of a quarter, from where the axis is.
  EXPECT_EQ(values(1, "output"), (std::vector<float>{3, 0, 1, 3, 0, 5}));
  EXPECT_EQ(opening["channels"][2]["target"]["path"], "rotation");
  const std::vector<float> turns = values(2, "output");
  ASSERT_EQ(turns.size(), 4u * 11u);
  EXPECT_EQ(values(2, "input").size(), 11u);
  for (std::size_t k = 0; k < 11; ++k) {
    const double half_rad = -0.25 * std::numbers::pi * static_cast<double>(k);
    EXPECT_NEAR(turns[4 * k + 2], std::sin(half_rad), 1e-6);
    EXPECT_NEAR(turns[4 * k + 3], std::cos(half_rad), 1e-6);
  }
  const auto& node = glb.json()["nodes"][glb.node("body_of_unscrew_2")];
  const TriangleMesh back = glb.mesh(glb.json()["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0]);
  EXPECT_NEAR(glm::length(back.corner(7, 1) + axis_point - mesh.corner(7, 1)), 0.0, 1e-5);
}

}  // namespace
}  // namespace moldlight
