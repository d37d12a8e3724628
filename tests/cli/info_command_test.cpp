// What `moldlight info` says of parts that are well and of parts that are not.
#include <iostream>

#include <gtest/gtest.h>

#include "cli/small_part.hpp"
#include "support/manifest.hpp"
#include "support/mesh_edits.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

using test::json_of;
using test::run_moldlight;
using test::SmallPart;

TEST(Info, FindsNothingWrongWithAHealthyPart) {
  const SmallPart part;
  const auto run = run_moldlight({"info", part.file()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_NE(run.out.find("The mesh is sound"), std::string::npos) << run.out;
  const auto json = json_of(run_moldlight({"info", part.file(), "--json", "-"}).out);
  EXPECT_EQ(json["schema"], "moldlight.info/1");
  EXPECT_EQ(json["part"]["facets"], part.shape().mesh.facets.size());
  EXPECT_EQ(json["part"]["closed"], true);
  EXPECT_EQ(json["defects"]["open"]["edges"], 0);
  EXPECT_EQ(json["bodies"].size(), 1u);
}

TEST(Info, SaysWhereThePartIsOpenAndByHowMuch) {
  test::ScratchFolder folder;
  TriangleMesh mesh = test::box_shape(test::ShapeSettings{}).mesh;
  const auto missing = mesh.facets.back();
  mesh.facets.pop_back();
  double rim = 0.0;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    rim += glm::distance(mesh.vertices[missing[corner]], mesh.vertices[missing[(corner + 1) % 3]]);
  }
  const std::vector<Region> regions(mesh.facets.size(), Region::core);
  write_coloured_mesh(folder.file("open.obj"), {mesh, regions});
  const auto run = run_moldlight({"info", folder.file("open.obj"), "--json", folder.file("info.json")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("open edges: 1 chain of"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("not closed"), std::string::npos) << run.out;
  const auto json = json_of(test::file_bytes(folder.file("info.json")));
  EXPECT_EQ(json["part"]["closed"], false);
  const auto& open = json["defects"]["open"];
  EXPECT_EQ(open["edges"], 3);
  ASSERT_EQ(open["places"].size(), 1u);
  EXPECT_EQ(open["places"][0]["closed"], true);
  EXPECT_NEAR(open["places"][0]["length"].get<double>(), rim, 1e-9 * rim);
}

TEST(Info, CountsOfSharedPartsAgreeWithTheirPlaces) {
  const auto shared = test::shared_folder();
  if (!shared) GTEST_SKIP() << "no shared parts";
  std::size_t used = 0;
  for (const test::ManifestRow& row : test::read_manifest()) {
    if (row.file.starts_with("bad/")) continue;
    const auto run = run_moldlight({"info", (*shared / "parts" / row.file).string(), "--json", "-"});
    if (run.exit_code == 1 && run.err.find("not supported") != std::string::npos) continue;
    ASSERT_EQ(run.exit_code, 0) << row.file << ": " << run.err;
    ++used;
    const auto json = json_of(run.out);
    for (const char* kind : {"open", "nonmanifold", "inconsistent"}) {
      const auto& defect = json["defects"][kind];
      std::size_t edges = 0;
      for (const auto& place : defect["places"]) edges += place["edges"].get<std::size_t>();
      if (defect["chains"] <= 1000) {
        EXPECT_EQ(defect["edges"], edges) << row.file << " " << kind;
      }
    }
    if (row.format != "STEP") {
      EXPECT_EQ(json["defects"]["open"]["edges"], row.defect_count("bnd")) << row.file;
    }
    std::size_t facets = 0;
    for (const auto& body : json["bodies"]) facets += body["facets"].get<std::size_t>();
    EXPECT_EQ(json["part"]["facets"], facets) << row.file;
  }
  std::cout << used << " shared parts used\n";
  EXPECT_GE(used, 30u);
}

}  // namespace
}  // namespace moldlight
