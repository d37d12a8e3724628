// A part and its equal.
#include <gtest/gtest.h>

#include "compare/comparison.hpp"
#include "unit/compare/revisions.hpp"

namespace moldlight {
namespace {

std::shared_ptr<const PartModel> model_of(const TriangleMesh& mesh) {
  Part part;
  part.unit = "mm";
  part.mesh = mesh;
  part.bodies = {{"", 0, static_cast<FacetIndex>(mesh.facets.size())}};
  return prepare_part(std::move(part), Progress());
}

Comparison compared(const TriangleMesh& a, const TriangleMesh& b, const glm::dvec3& direction, bool aligned) {
  CompareSettings settings;
  settings.align = aligned;
  Comparison comparison = prepare_comparison(model_of(a), model_of(b), settings, Progress());
  compare_parts(comparison, {.a = direction, .b = direction, .method = {}}, Progress());
  return comparison;
}

TEST(EqualParts, AreComputedOnce) {
  const TriangleMesh mesh = plate_mesh({.hole_radius = 3.0});
  for (const bool aligned : {false, true}) {
    const Comparison found = compared(mesh, mesh, {1, 0, 0}, aligned);
    EXPECT_EQ(found.a.result.split, found.b.result.split);
    EXPECT_FALSE(found.surface.any());
    double shared = 0.0;
    for (const PieceShare& share : found.surface.of_b.shares) shared += share.area;
    EXPECT_NEAR(shared, found.a.result.total_area, 1e-9 * shared);
    ASSERT_FALSE(found.undercuts.empty()) << "the hole across the direction";
    for (const auto& changes : {found.undercuts, found.actions})
      for (const MatchedChange& change : changes) EXPECT_EQ(change.kind, ChangeKind::same);
    EXPECT_EQ(found.alignment.has_value(), aligned);
  }
}

TEST(EqualParts, AreTheSameAsPartsThatAreMerelyAlike) {
  const TriangleMesh mesh = plate_mesh({.hole_radius = 3.0});
  const Comparison equal = compared(mesh, mesh, {1, 0, 0}, false),
                   alike = compared(mesh, test::permuted(mesh, 3), {1, 0, 0}, false);
  EXPECT_NE(alike.a.result.split, alike.b.result.split);
  EXPECT_EQ(comparison_verdict(equal), comparison_verdict(alike));
  EXPECT_EQ(equal.undercuts.size(), alike.undercuts.size());
  EXPECT_EQ(equal.surface.chords, alike.surface.chords);
}

TEST(EqualParts, AreEqualHoweverFarFromTheirOrigin) {
  const TriangleMesh mesh = test::translated(plate_mesh({}), {1e15, 0, 0});
  EXPECT_FALSE(compared(mesh, mesh, {0, 0, 1}, false).surface.any());
}

}  // namespace
}  // namespace moldlight
