// Slides as solids of the mold: with halves, part and inserts they fill the block, and they move out.
#include "parting/mold_pieces.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mesh/health.hpp"
#include "parting/halves/depth_columns.hpp"
#include "parting/slide_blank.hpp"
#include "study/study.hpp"
#include "support/boxes.hpp"
#include "support/mold_checks.hpp"
#include "support/shapes.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

Study study_of(const TriangleMesh& mesh) {
  Part part;
  part.unit = "mm";
  part.mesh = mesh;
  part.bodies = {{"", 0, static_cast<FacetIndex>(mesh.facets.size())}};
  Questions questions;
  questions.with_actions = true;
  return Study(prepare_part(std::move(part), Progress()), questions);
}

class SlidesOf : public ::testing::TestWithParam<test::Shape (*)(const test::ShapeSettings&)> {};

TEST_P(SlidesOf, FillTheBlockWithTheHalvesAndMoveOut) {
  const TriangleMesh mesh = GetParam()({}).mesh;
  Study study = study_of(mesh);
  const MoldPieces& pieces = study.find<MoldPieces>(Progress());
  const MoldHalves& halves = pieces.halves;
  ASSERT_EQ(pieces.of_slides.size(), 1U) << (pieces.unmade.empty() ? "" : pieces.unmade.front().why);
  EXPECT_TRUE(halves.certified());
  EXPECT_LE(std::abs(halves.volume_gap), 1e-9);
  ASSERT_EQ(halves.inserts.size(), 1U);
  EXPECT_EQ(halves.inserts[0].name, "slide_1");
  EXPECT_EQ(halves.inserts[0].crossed_facets, 0U);
  ASSERT_EQ(halves.written.bodies.size(), 3U);
  std::vector<TriangleMesh> bodies = {mesh};
  for (const WrittenBody& body : halves.written.bodies) {
    EXPECT_TRUE(body.closed) << body.name;
    bodies.push_back(body.mesh);
  }
  EXPECT_EQ(test::misplaced_points(bodies, 20000, 7), 0U);
  // Out of the block's side, past the part; the other way the part holds it.
  const glm::dvec3 way = study.find<ActionPlan>(Progress()).actions[pieces.of_slides[0]].direction;
  const double diagonal = study.model().frame.diagonal;
  EXPECT_LE(way_out(halves.written.bodies[2].mesh, mesh, way).blocked, diagonal / 2048.0);
  EXPECT_GT(way_out(halves.written.bodies[2].mesh, mesh, -way).blocked, 0.01 * diagonal);
}

INSTANTIATE_TEST_SUITE_P(MoldPieces, SlidesOf,
                         ::testing::Values(&test::cup_with_side_hole, &test::plate_with_side_pocket));

TEST(MoldPieces, AreListedWithTheirOrderAndTravel) {
  Study study = study_of(test::plate_with_side_pocket({}).mesh);
  const auto json = mold_json(study, Progress());
  const auto& pieces = json["pieces"];
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[0]["kind"], "core");
  EXPECT_EQ(pieces[0]["sequence"], 2);
  EXPECT_EQ(pieces[2]["name"], "slide_1");
  EXPECT_EQ(pieces[2]["kind"], "slide");
  EXPECT_EQ(pieces[2]["sequence"], 1);
  EXPECT_EQ(pieces[2]["crossings"], 0);
  EXPECT_TRUE(pieces[2]["closed"]);
  EXPECT_GT(pieces[2]["travel"].get<double>(), 3.0);
  EXPECT_GT(pieces[2]["thinnest"].get<double>(), 0.0);
  const auto made = json["made"].get<std::string>();
  EXPECT_EQ(made.find("no shut-off, planar parting surface, flat edge"), 0U) << made;
  EXPECT_NE(made.find(", 1 slide; block of "), std::string::npos) << made;
  EXPECT_EQ(json["transform"][3], (nlohmann::ordered_json{0.0, 0.0, 0.0, 1.0}));
}

TEST(MoldPieces, ASlideWithThePartInItsWayIsNone) {
  Questions questions;
  questions.with_actions = true;
  const std::string clip = (test::asset_folder() / "parts" / "cable_clip.stl").string();
  Study study(load_part(clip, {.unit = "mm"}, Progress()), questions);
  const MoldPieces& pieces = study.find<MoldPieces>(Progress());
  EXPECT_TRUE(pieces.of_slides.empty());
  EXPECT_TRUE(std::ranges::any_of(pieces.unmade, [](const UnmadeAction& unmade) {
    return unmade.why.starts_with("the part stands in its way");
  }));
}

TEST(MoldPieces, ThinnestIsTheLeastWayBetweenOppositeFaces) {
  EXPECT_NEAR(*thinnest_of(test::box_mesh({0, 0, 0}, {4, 3, 0.5})), 0.5, 1e-12);
}

}  // namespace
}  // namespace moldlight
