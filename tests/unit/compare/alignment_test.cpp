// Parts that were turned, moved and changed find back onto the first revision.
#include "compare/alignment.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "compare/comparison.hpp"
#include "unit/compare/revisions.hpp"

namespace moldlight {
namespace {

TriangleMesh turned_away(const TriangleMesh& mesh, std::uint32_t seed) {
  return test::rounded_to_float(
      test::translated(test::rotated(mesh, test::random_rotation(seed)), {40.0, -15.0, 7.0}));
}

Comparison aligned(const TriangleMesh& a, const TriangleMesh& b) {
  CompareSettings settings;
  settings.align = true;
  settings.with_actions = false;
  Comparison comparison = prepare_comparison(test::model_of(a), test::model_of(b), settings, Progress());
  compare_parts(comparison, {}, Progress());
  return comparison;
}

TEST(Alignment, TellsNothingOfAPartThatWasOnlyTurned) {
  const TriangleMesh mesh = plate_mesh({.hole_radius = 3.0});
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    const Comparison comparison = aligned(mesh, turned_away(mesh, seed));
    EXPECT_FALSE(comparison.surface.any()) << seed;
    EXPECT_LT(comparison.alignment->largest, 1e-5 * comparison.a.model->frame.diagonal);
    EXPECT_FALSE(comparison.alignment->mirrored);
  }
}

TEST(Alignment, LeavesWhatChangedAsItIs) {
  const PlateWithBoss holed{.hole_radius = 3.0};
  const Comparison comparison = aligned(plate_mesh({}), turned_away(plate_mesh(holed), 5));
  ASSERT_EQ(comparison.surface.places.size(), 1U);
  const double hole = polygon_area(regular_polygon(holed.sides, holed.hole_radius));
  EXPECT_NEAR(comparison.surface.gone.area, 2.0 * hole, 0.01 * hole);
  EXPECT_NEAR(comparison.surface.places.front().centre.x, holed.hole.x, 0.02);
  EXPECT_LT(comparison.alignment->median, 1e-6 * comparison.a.model->frame.diagonal);
}

/// A cylinder on a square plate: two moments are alike.
TEST(Alignment, FindsPartsThatAreNearlySymmetric) {
  SolidBuilder solid;
  const Loop2 round = placed(regular_polygon(40, 4.0), {5.0, 0.0});
  solid.box({-10, -10, 0}, {10, 10, 3}, {5});
  solid.face(box_face({-10, -10, 0}, {10, 10, 3}, 5), {at_height(round, 3.0)});
  solid.walls(at_height(round, 3.0), at_height(round, 4.0));
  solid.face(at_height(round, 4.0));
  const TriangleMesh mesh = solid.mesh();
  EXPECT_FALSE(aligned(mesh, turned_away(mesh, 8)).surface.any());
}

TEST(Alignment, TellsAMirrorImage) {
  PlateWithBoss part{.hole_radius = 3.0, .rib = 2.0};
  TriangleMesh mirrored = plate_mesh(part);
  for (glm::dvec3& vertex : mirrored.vertices) vertex.x = -vertex.x;
  for (auto& facet : mirrored.facets) std::swap(facet[1], facet[2]);
  const Comparison comparison = aligned(plate_mesh(part), turned_away(mirrored, 4));
  EXPECT_TRUE(comparison.alignment->mirrored);
  EXPECT_TRUE(comparison.surface.any());
}

TEST(Alignment, DoesNotScale) {
  const TriangleMesh mesh = plate_mesh({.hole_radius = 3.0});
  const Comparison comparison = aligned(mesh, test::scaled(mesh, 1.01));
  EXPECT_GT(comparison.alignment->rms, 1e-3);
  EXPECT_TRUE(comparison.surface.any());
}

}  // namespace
}  // namespace moldlight
