// Pieces of a mold as solids: with the part they fill the block, and each moves out.
#include "pieces/piece_solids.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "parting/slide_blank.hpp"
#include "study/study.hpp"
#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"
#include "support/mold_checks.hpp"
#include "support/shapes.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

constexpr glm::dvec3 k_up(0, 0, 1);

/// A mold that opens along z, of a plate with a pocket in its side.
Study pocket_study() {
  Questions questions;
  questions.pieces.fixed = {k_up, -k_up};
  return Study(test::model_of(test::plate_with_side_pocket({}).mesh), questions);
}

TEST(PieceSolids, FillTheBlockWithThePartAndMoveOut) {
  Study study = pocket_study();
  const PieceSolids& solids = study.find<PieceSolids>(Progress());
  const PiecesResult& result = study.find<PiecesResult>(Progress());
  ASSERT_EQ(solids.refusal, "");
  ASSERT_EQ(result.count(), 3U);
  ASSERT_EQ(solids.solids.size(), 3U);
  const MoldHalves& halves = solids.halves;
  EXPECT_LE(std::abs(halves.volume_gap), 1e-9);
  const TriangleMesh& part = study.model().part.mesh;
  std::vector<TriangleMesh> bodies = {part};
  for (std::size_t k = 0; k < 3; ++k) {
    const WrittenBody& body = halves.written.bodies[k];
    EXPECT_EQ(body.name, "piece_" + std::to_string(k + 1));
    EXPECT_EQ(solids.solids[k].direction, k);
    EXPECT_TRUE(body.closed);
    bodies.push_back(body.mesh);
  }
  EXPECT_EQ(test::misplaced_points(bodies, 20000, 7), 0U);
  const glm::dvec3 way = result.directions[2].direction;
  const double diagonal = study.model().frame.diagonal;
  EXPECT_NEAR(glm::dot(way, k_up), 0.0, 1e-9);
  EXPECT_LE(way_out(bodies[3], part, way).blocked, diagonal / 2048.0);
  EXPECT_GT(way_out(bodies[3], part, -way).blocked, 0.01 * diagonal);
  // As deep as the pocket is: its far end comes out to the plate's side.
  double deepest = INFINITY, side = -INFINITY;
  for (const glm::dvec3& vertex : bodies[3].vertices) deepest = std::min(deepest, glm::dot(vertex, way));
  for (const glm::dvec3& vertex : part.vertices) side = std::max(side, glm::dot(vertex, way));
  EXPECT_NEAR(solids.solids[2].travel, side - deepest, 1e-6 * diagonal);
}

TEST(PieceSolids, AreToldInJson) {
  Study study = pocket_study();
  EXPECT_TRUE(pieces_json(study, Progress())["solids"].is_null());
  const PieceSolids& solids = study.find<PieceSolids>(Progress());
  const Json json = pieces_json(study, Progress())["solids"];
  EXPECT_TRUE(json["refused"].is_null());
  ASSERT_EQ(json["bodies"].size(), 3U);
  EXPECT_EQ(json["bodies"][0]["sequence"], 1);
  EXPECT_EQ(json["bodies"][1]["sequence"], 1);
  EXPECT_EQ(json["bodies"][2]["sequence"], 2);
  EXPECT_EQ(json["bodies"][2]["order"], 3);
  EXPECT_EQ(json["bodies"][2]["volume"], solids.halves.written.bodies[2].volume);
  EXPECT_EQ(json["transform"].size(), 4U);
}

TEST(PieceSolids, ABodyThatNothingReleasesIsRefusedWithItsPlace) {
  Study study = pocket_study();
  PiecesResult wrong = study.find<PiecesResult>(Progress());
  wrong.directions[2].direction = -wrong.directions[2].direction;
  Questions along = study.questions();
  along.query.direction = k_up;
  const MoldHalves halves = Study(study.shared_model(), along).find<MoldHalves>(Progress());
  const PieceSolids refused = piece_solids(study.model(), wrong, 0, halves, Progress());
  EXPECT_EQ(refused.refusal, "no single direction releases a body between the halves");
  EXPECT_TRUE(refused.solids.empty());
  ASSERT_TRUE(refused.refused_at.has_value());
  const Bounds& box = study.model().health.bounds;
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_GE((*refused.refused_at)[axis], box.min[axis]);
    EXPECT_LE((*refused.refused_at)[axis], box.max[axis]);
  }
  // Where so much may be left over, it is.
  wrong.settings.eps = 0.2;
  const PieceSolids left = piece_solids(study.model(), wrong, 0, halves, Progress());
  ASSERT_EQ(left.solids.size(), 3U);
  EXPECT_EQ(left.halves.written.bodies[2].name, "left_1");
  EXPECT_EQ(left.solids[2].direction, std::nullopt);
}

/// Something around all of the part, which nothing releases, stands in the way of the body in the pocket.
TEST(PieceSolids, ABodyThatWouldHitAnotherIsRefused) {
  Study study = pocket_study();
  PiecesResult result = study.find<PiecesResult>(Progress());
  MoldHalves halves = study.find<PieceSolids>(Progress()).halves;
  const double far = 2.0 * study.model().frame.diagonal;
  halves.inserts.push_back(halves.inserts.front());
  halves.inserts.back().mesh = test::box_mesh(glm::dvec3(-far), glm::dvec3(far));
  halves.written.bodies.push_back(halves.written.bodies.back());
  const PieceSolids solids = piece_solids(study.model(), result, 0, halves, Progress());
  EXPECT_NE(solids.refusal.find("would hit one that is removed later"), std::string::npos) << solids.refusal;
  EXPECT_TRUE(solids.refused_at.has_value());
}

TEST(PieceSolids, CanBeCancelled) {
  Study study = pocket_study();
  const PiecesResult& result = study.find<PiecesResult>(Progress());
  MoldHalves halves = study.find<PieceSolids>(Progress()).halves;
  halves.inserts.push_back(halves.inserts.front());
  halves.written.bodies.push_back(halves.written.bodies.back());
  for (int calls = 1; calls <= 2; ++calls) {
    Progress* watched = nullptr;
    int left = calls;
    Progress progress([&](std::string_view, double) {
      if (--left == 0) watched->cancel();
    });
    watched = &progress;
    EXPECT_THROW(static_cast<void>(piece_solids(study.model(), result, 0, halves, progress)), Cancelled)
        << calls;
  }
}

/// A block with a tunnel along x around a post.
TriangleMesh tunnel_with_post() {
  test::SolidBuilder builder;
  const glm::dvec3 low(-20, -15, -12), high(20, 15, 12), tunnel_low(-20, -6, -5), tunnel_high(20, 6, 5);
  const test::Loop2 post = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
  builder.box(low, high, {0, 1});
  for (const int face : {0, 1})
    builder.face(test::box_face(low, high, face), {test::box_face(tunnel_low, tunnel_high, face)});
  builder.box(tunnel_low, tunnel_high, {0, 1, 4, 5}, true);
  for (const int face : {4, 5}) {
    test::Loop inward = test::box_face(tunnel_low, tunnel_high, face);
    std::ranges::reverse(inward);
    builder.face(inward, {test::at_height(post, face == 4 ? -5 : 5)});
  }
  builder.walls(test::at_height(post, -5), test::at_height(post, 5));
  return builder.mesh();
}

/// What fills the tunnel goes around the post: it comes out at both ends.
TEST(PieceSolids, ABodyIsDividedWhereNoDirectionReleasesItWhole) {
  Questions questions;
  questions.pieces.fixed = {k_up, -k_up, {1, 0, 0}, {-1, 0, 0}};
  Study study(test::model_of(tunnel_with_post()), questions);
  const PieceSolids& solids = study.find<PieceSolids>(Progress());
  ASSERT_EQ(solids.refusal, "");
  ASSERT_EQ(solids.solids.size(), 4U);
  EXPECT_LE(std::abs(solids.halves.volume_gap), 1e-9);
  const TriangleMesh& part = study.model().part.mesh;
  std::vector<TriangleMesh> bodies = {part};
  for (const WrittenBody& body : solids.halves.written.bodies) {
    EXPECT_TRUE(body.closed) << body.name;
    bodies.push_back(body.mesh);
  }
  EXPECT_EQ(test::misplaced_points(bodies, 20000, 7), 0U);
  const double slack = study.model().frame.diagonal / 2048.0;
  for (const std::size_t k : {2U, 3U}) {
    ASSERT_TRUE(solids.solids[k].direction);
    const glm::dvec3 way = solids.directions[*solids.solids[k].direction];
    EXPECT_EQ(std::abs(way.x), 1.0);
    EXPECT_EQ(solids.halves.written.bodies[k].name,
              "piece_" + std::to_string(*solids.solids[k].direction + 1));
    EXPECT_LE(way_out(bodies[k + 1], part, way).blocked, slack);
    const std::size_t other = 5 - k;
    if (solids.solids[k].sequence < solids.solids[other].sequence) {
      EXPECT_LE(way_out(bodies[k + 1], bodies[other + 1], way).blocked, slack);
    }
  }
  EXPECT_EQ(solids.solids[2].sequence + solids.solids[3].sequence, 5U);
}

TEST(PieceSolids, AskForAPieceMoreWhereNoTwoDirectionsAreOpposite) {
  Study study = pocket_study();
  PiecesResult one_sided = study.find<PiecesResult>(Progress());
  EXPECT_EQ(halves_directions(one_sided), std::vector<std::size_t>{0});
  one_sided.directions.erase(one_sided.directions.begin() + 1);
  EXPECT_EQ(halves_directions(one_sided), (std::vector<std::size_t>{0, 1}));
  Questions along = study.questions();
  along.query.direction = k_up;
  const MoldHalves halves = Study(study.shared_model(), along).find<MoldHalves>(Progress());
  const PieceSolids solids = piece_solids(study.model(), one_sided, 0, halves, Progress());
  ASSERT_EQ(solids.refusal, "");
  ASSERT_EQ(solids.directions.size(), 3U);
  EXPECT_EQ(solids.directions[2], -k_up);
  EXPECT_EQ(solids.solids[1].direction, 2U);
  EXPECT_EQ(solids.halves.written.bodies[1].name, "piece_3");
  EXPECT_EQ(solids.halves.written.bodies[2].name, "piece_2");
}

}  // namespace
}  // namespace moldlight
