// Proofs on parts whose answer is known, and against exact regions of random directions.
#include "proof/direction_proof.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include "mold/direction.hpp"
#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/proof_model.hpp"
#include "support/shapes.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

double open_share(const DirectionProof& proof) { return 1.0 - proof.proved_share; }

TEST(DirectionProof, AConvexPartHasNothingAnywhere) {
  const test::ProofModel model(test::model_of(test::box_mesh({0, 0, 0}, {3, 2, 1})));
  const auto elements = model.samples(2000);
  const DirectionProof none = prove_directions(model.part(), elements, {.query = model.query()});
  EXPECT_NEAR(none.proved_share, 1.0, 1e-12);
  EXPECT_TRUE(std::ranges::all_of(none.cells, [](const ProofCell& cell) { return cell.bound == 0.0; }));
  const DirectionProof some =
      prove_directions(model.part(), elements, {.query = model.query(), .bound = 0.01, .finest_deg = 2.0});
  EXPECT_EQ(some.proved_share, 0.0);
  const std::vector<DirectionCap> caps = open_caps(some.cells);
  ASSERT_EQ(caps.size(), 1U);
  EXPECT_EQ(caps[0].radius_deg, 90.0);
}

TEST(DirectionProof, AClosedVoidIsUndercutEverywhere) {
  test::SolidBuilder solid;
  solid.box({0, 0, 0}, {3, 3, 3});
  solid.box({1, 1, 1}, {2, 2, 2}, {}, true);
  const test::ProofModel model(test::model_of(solid.mesh()));
  const double area = 6.0;
  const SurfacePieces pieces = model.pieces(5000);
  const DirectionProof by_area =
      prove_directions(model.part(), pieces, {.query = model.query(), .bound = 0.9 * area});
  EXPECT_NEAR(by_area.proved_share, 1.0, 1e-12);
  const auto points = model.samples(5000);
  const auto inside = static_cast<double>(std::ranges::count_if(points, [&](const SurfaceElement& point) {
    return glm::length(point.middle()) < 0.9 / model.model().frame.diagonal;
  }));
  const DirectionProof by_points = prove_directions(
      model.part(), points, {.query = model.query(), .bound = 0.97 * inside * points.front().area});
  EXPECT_NEAR(by_points.proved_share, 1.0, 1e-12);
  EXPECT_NEAR(by_points.bound, 0.97 * area, 0.03 * area);
}

/// A block with square blind holes, half a unit wide and a hundred deep, one along each axis given. The axes
/// all but agree with z.
TriangleMesh block_with_needle_holes(const std::vector<glm::dvec3>& axes) {
  test::SolidBuilder solid;
  const double height = 105.0, half = 0.25;
  const double length = 8.0 * static_cast<double>(axes.size());
  solid.box({-4, -4, 0}, {length - 4.0, 4, height}, {5});
  std::vector<test::Loop> mouths;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const glm::dvec2 at(8.0 * static_cast<double>(k), 0.0);
    test::Loop mouth, bottom;
    for (const glm::dvec2& corner : {glm::dvec2(-half, -half), {half, -half}, {half, half}, {-half, half}}) {
      mouth.emplace_back(at + corner, height);
      bottom.push_back(mouth.back() - 100.0 / axes[k].z * axes[k]);
    }
    mouths.push_back(mouth);
    // The bottom looks up; the walls look to the hole's middle.
    solid.face(bottom);
    std::vector<glm::dvec3> high(mouth.rbegin(), mouth.rend()), low(bottom.rbegin(), bottom.rend());
    solid.walls(low, high);
  }
  solid.face(test::box_face({-4, -4, 0}, {length - 4.0, 4, height}, 5), mouths);
  return solid.mesh();
}

ProofQuery needle_query(const test::ProofModel& model) {
  return {.tau_deg = 0.1, .lateral = 0.02 / model.model().frame.diagonal};
}

TEST(DirectionProof, OfATiltedNeedleLeavesItsAxisAlone) {
  const glm::dvec3 axis = glm::normalize(glm::dvec3(0.01, 0.012, 1.0));
  const test::ProofModel model(test::model_of(block_with_needle_holes({axis})));
  const double hole = 4.0 * 0.5 * 100.0;
  ASSERT_LT(model.undercut(axis, needle_query(model)), 0.01 * hole);
  const ProofTask task{.query = needle_query(model), .bound = 0.5 * hole, .finest_deg = 0.05};
  const DirectionProof proof = prove_directions(model.part(), model.samples(20'000), task);
  EXPECT_LT(open_share(proof), 1e-4);
  const std::vector<DirectionCap> caps = open_caps(proof.cells);
  ASSERT_EQ(caps.size(), 1U);
  EXPECT_LT(line_angle_deg(caps[0].direction, axis), 0.1);
  EXPECT_LT(caps[0].radius_deg, 0.6);
}

TEST(DirectionProof, OfTwoNeedlesADegreeApartLeavesExactlyTheirCaps) {
  const double half = glm::radians(0.5);
  const glm::dvec3 one(std::sin(half), 0, std::cos(half)), other(-std::sin(half), 0, std::cos(half));
  const test::ProofModel model(test::model_of(block_with_needle_holes({one, other})));
  const double hole = 4.0 * 0.5 * 100.0;
  const ProofTask task{.query = needle_query(model), .bound = 1.2 * hole, .finest_deg = 0.03};
  const DirectionProof proof = prove_directions(model.part(), model.samples(40'000), task);
  const std::vector<DirectionCap> caps = open_caps(proof.cells);
  ASSERT_EQ(caps.size(), 2U);
  for (const DirectionCap& cap : caps) {
    const glm::dvec3& axis = cap.direction.x > 0.0 ? one : other;
    EXPECT_LT(line_angle_deg(cap.direction, axis), 0.1);
    EXPECT_LT(cap.radius_deg, 0.5);
    EXPECT_LT(model.undercut(axis, task.query), task.bound);
  }
  EXPECT_LT(caps[0].direction.x * caps[1].direction.x, 0.0);
}

TEST(DirectionProof, IsNeverAboveExactRegions) {
  for (const test::Shape& shape : {test::snap_hook({}), test::t_slot({}), test::cup_with_side_hole({})}) {
    const test::ProofModel model(test::model_of(shape.mesh));
    const double total = model.part().geometry.total_area;
    const ProofTask task{
        .query = model.query(), .bound = 0.03 * total, .finest_deg = 3.0, .finest_length = 0.02};
    const DirectionProof proof = prove_directions(model.part(), model.pieces(2000), task);
    EXPECT_GT(proof.proved_share, 0.2) << shape.name;
    test::Random random(5);
    for (const ProofCell& cell : proof.cells) {
      const glm::dvec3 direction = test::random_direction(cell.cell, random);
      // What is certain holds for open cells, too.
      EXPECT_GE(model.undercut(direction), cell.bound) << shape.name;
      EXPECT_EQ(cell.proved, cell.bound >= task.bound);
    }
  }
}

/// Pieces are found from the points' side, and must not be fewer by much.
TEST(DirectionProof, ByAreaProvesNearlyWhatPointsTell) {
  for (const test::Shape& shape : {test::snap_hook({}), test::t_slot({})}) {
    const test::ProofModel model(test::model_of(test::subdivided(shape.mesh, 1000)));
    const ProofTask task{
        .query = model.query(), .bound = 0.02 * model.part().geometry.total_area, .finest_deg = 3.0};
    const DirectionProof by_points = prove_directions(model.part(), model.samples(3000), task);
    const DirectionProof by_area = prove_directions(model.part(), model.pieces(3000), task);
    EXPECT_GT(by_points.proved_share, 0.5) << shape.name;
    EXPECT_GT(by_area.proved_share, by_points.proved_share - 0.01) << shape.name;
  }
}

TEST(DirectionProof, IsTheSameForAnyNumberOfThreads) {
  const test::ProofModel model(test::model_of(test::snap_hook({}).mesh));
  const SurfacePieces pieces = model.pieces(2000);
  const ProofTask task{.query = model.query(),
                       .bound = 0.05 * model.part().geometry.total_area,
                       .finest_deg = 3.0,
                       .finest_length = 0.02};
  std::vector<DirectionProof> proofs;
  for (const int threads : {1, 4}) {
    tbb::task_arena arena(threads);
    arena.execute([&] { proofs.push_back(prove_directions(model.part(), pieces, task)); });
  }
  ASSERT_EQ(proofs[0].cells.size(), proofs[1].cells.size());
  EXPECT_EQ(proofs[0].looked_at, proofs[1].looked_at);
  EXPECT_EQ(proofs[0].proved_share, proofs[1].proved_share);
  for (std::size_t k = 0; k < proofs[0].cells.size(); ++k)
    EXPECT_EQ(proofs[0].cells[k].bound, proofs[1].cells[k].bound);
}

TEST(DirectionProof, StoppedKeepsWhatItHas) {
  const test::ProofModel model(test::model_of(test::snap_hook({}).mesh));
  std::atomic<int> asked = 0;
  double last_open = 2.0;
  const ProofTask task{.query = model.query(),
                       .bound = 0.02 * model.part().geometry.total_area,
                       .stop = [&] { return ++asked > 40; },
                       .progress =
                           [&](double open) {
                             EXPECT_LE(open, last_open);
                             last_open = open;
                           }};
  const DirectionProof proof = prove_directions(model.part(), model.samples(3000), task);
  EXPECT_FALSE(proof.complete);
  EXPECT_LT(proof.proved_share, 1.0);
  double share = 0.0;
  for (const ProofCell& cell : proof.cells) share += cell.cell.share();
  EXPECT_NEAR(share, 1.0, 1e-12);
}

/// From inside a body that is inside out a ray enters what it never leaves.
TEST(DirectionProof, ABodyInsideOutMakesNothingCertain) {
  TriangleMesh mesh = test::box_mesh({0, 0, 0}, {3, 2, 1});
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) test::reverse_facet(mesh, facet);
  const test::ProofModel model(test::model_of(mesh));
  const DirectionProof proof = prove_directions(model.part(), model.samples(1000),
                                                {.query = model.query(), .bound = 1.0, .finest_deg = 5.0});
  EXPECT_EQ(proof.proved_share, 0.0);
}

}  // namespace
}  // namespace moldlight
