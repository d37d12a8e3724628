// The split part as GLB and VTP: what a viewer finds in them is what the report says.
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "cli/small_part.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/health.hpp"
#include "mold/draft.hpp"
#include "support/process.hpp"
#include "support/read_glb.hpp"
#include "support/read_vtp.hpp"

namespace moldlight {
namespace {

using test::file_bytes;
using test::Glb;
using test::json_of;
using test::run_moldlight;
using test::SmallPart;
using test::with;

const std::vector<std::string> k_tilted = {"--direction", "0.36,0.48,0.8"};

TEST(MeshFormats, GlbHasTheAreasOfTheReport) {
  const SmallPart part;
  const std::string path = part.output("out.glb");
  const auto arguments =
      with(part.classify({"--unit", "mm", "--mesh", path, "--json", "-"}), k_tilted[0], k_tilted[1]);
  const auto run = run_moldlight(arguments);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::string bytes = file_bytes(path);
  const Glb glb(bytes);
  const auto json = json_of(run.out);
  const std::size_t node = glb.node("cup.obj");
  std::vector<TriangleMesh> meshes;
  std::map<std::string, double> areas;  // 0 of a region without facets
  for (const auto& primitive :
       glb.json()["meshes"][glb.json()["nodes"][node]["mesh"].get<std::size_t>()]["primitives"]) {
    meshes.push_back(glb.mesh(primitive));
    areas[glb.material(primitive)] = facet_geometry(meshes.back()).total_area;
  }
  for (const Region region : k_regions) {
    const std::string name(region_name(region));
    EXPECT_NEAR(areas[name], json["areas"][name].get<double>(), 1e-6 * json["areas"]["total"].get<double>());
  }
  const TriangleMesh whole = test::joined(meshes);
  EXPECT_TRUE(health_report(whole, facet_geometry(whole)).closed);
  test::ProcessSettings one_thread;
  one_thread.environment = {"MOLDLIGHT_THREADS=1"};
  ASSERT_EQ(run_moldlight(arguments, one_thread).exit_code, 0);
  EXPECT_EQ(file_bytes(path), bytes);
}

TEST(MeshFormats, VtpHasTheFiguresOfEachFacet) {
  const SmallPart part;
  const std::string path = part.output("out.vtp"), table = part.output("faces.csv");
  const auto run = run_moldlight(
      with(part.classify({"--mesh", path, "--faces", table, "--json", "-"}), k_tilted[0], k_tilted[1]));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const test::Vtp vtp = test::read_vtp(file_bytes(path));
  const auto json = json_of(run.out);
  const FacetGeometry geometry = facet_geometry(vtp.mesh);
  EXPECT_TRUE(health_report(vtp.mesh, geometry).closed);
  const glm::dvec3 direction(0.36, 0.48, 0.8);
  RegionValues areas;
  std::vector<double> of_face;
  for (FacetIndex k = 0; k < vtp.mesh.facets.size(); ++k) {
    const auto value = [&](const char* name) { return vtp.of_facets.at(name).values[k]; };
    areas[k_regions.at(static_cast<std::size_t>(value("region")))] += geometry.areas[k];
    if (geometry.areas[k] > 1e-6 * geometry.total_area) {
      EXPECT_NEAR(value("draft_deg"), draft_angle_deg(geometry.normals[k], direction), 1e-6);
    }
    EXPECT_NEAR(value("height"), glm::dot(vtp.mesh.middle(k), direction), 1e-9);
    EXPECT_EQ(value("body"), 1.0);
    const auto face = static_cast<std::size_t>(value("face"));
    if (of_face.size() <= face) of_face.resize(face + 1);
    of_face[face] += geometry.areas[k];
  }
  for (const Region region : k_regions) {
    EXPECT_NEAR(areas[region], json["areas"][std::string(region_name(region))].get<double>(),
                1e-9 * geometry.total_area);
  }
  std::istringstream lines(file_bytes(table));
  std::string line;
  std::getline(lines, line);
  std::size_t faces = 0;
  for (; std::getline(lines, line); ++faces) {
    std::size_t end = 0;
    const std::size_t face = std::stoul(line, &end);
    EXPECT_NEAR(of_face.at(face), std::stod(line.substr(end + 1)), 1e-9 * geometry.total_area);
  }
  EXPECT_EQ(faces, of_face.size());
}

TEST(MeshFormats, GlbMovesTheBodiesOfSideActions) {
  const SmallPart part;
  const std::string path = part.output("actions.glb");
  const auto run = run_moldlight(
      {"actions", part.file(), "--direction", "z", "--unit", "mm", "--mesh", path, "--json", "-"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto action = json_of(run.out)["actions"][0];
  const Glb glb(file_bytes(path));
  const std::size_t node = glb.node("body_of_slide_1");
  const auto& primitive =
      glb.json()["meshes"][glb.json()["nodes"][node]["mesh"].get<std::size_t>()]["primitives"][0];
  const TriangleMesh body = glb.mesh(primitive);
  const HealthReport health = health_report(body, facet_geometry(body));
  EXPECT_TRUE(health.closed);
  const double volume = action["body"]["volume"];
  EXPECT_NEAR(health.volume, volume, 1e-4 * volume);
  const auto& opening = glb.json()["animations"][0];
  EXPECT_EQ(opening["channels"][0]["target"]["node"], node);
  const std::vector<float> places = glb.floats(opening["samplers"][0]["output"]);
  ASSERT_EQ(places.size(), 6u);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(places[3 + axis] - places[axis],
                action["travel"].get<double>() * action["direction"][axis].get<double>(), 1e-5);
  }
  bool found = false;
  for (const auto& material : glb.json()["materials"]) found = found || material["name"] == "slide_1";
  EXPECT_TRUE(found) << "the surface that it forms";
}

TEST(MeshFormats, AreNamedWhereAFileHasNone) {
  const SmallPart part;
  const auto run = run_moldlight(part.classify({"--mesh", part.output("out.gltf")}));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.error_lines(), 1u) << run.err;
  for (const std::string extension : {".ply", ".obj", ".stl", ".glb", ".vtp"})
    EXPECT_NE(run.err.find(extension), std::string::npos) << run.err;
}

}  // namespace
}  // namespace moldlight
