// What counts as an undercut: one that nowhere is deeper than the lateral tolerance does not.
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "unit/actions/known_undercuts.hpp"

namespace moldlight {
namespace {

/// A pillar, polygonal, with a groove of `depth` all around: nothing that moves one way clears it.
TriangleMesh pillar_with_groove(double depth) {
  constexpr int k_sides = 48;
  constexpr double k_radius = 10.0;
  const Loop2 outer = regular_polygon(k_sides, k_radius), inner = regular_polygon(k_sides, k_radius - depth);
  const Loop2 in_hole(inner.rbegin(), inner.rend());
  SolidBuilder solid;
  test::Loop bottom = at_height(outer, 0.0);
  std::ranges::reverse(bottom);
  solid.face(bottom);
  solid.walls(at_height(outer, 0.0), at_height(outer, 8.0));
  solid.face(at_height(outer, 8.0), {at_height(inner, 8.0)});
  solid.walls(at_height(inner, 8.0), at_height(inner, 12.0));
  test::Loop under = at_height(outer, 12.0);
  std::ranges::reverse(under);
  solid.face(under, {at_height(inner, 12.0)});
  solid.walls(at_height(outer, 12.0), at_height(outer, 20.0));
  solid.face(at_height(outer, 20.0));
  return solid.mesh();
}

std::size_t count_of(const Planned& planned, double least_travel_mm = k_least_travel_mm) {
  std::vector<FacetIndex> facets;
  for (FacetIndex facet = 0; facet < planned.result.facet_fractions.size(); ++facet) {
    if (planned.result.facet_fractions[facet][static_cast<std::size_t>(Region::undercut)] > 0.0)
      facets.push_back(facet);
  }
  const ExactQuery query = exact_query(*planned.model, planned.result.query());
  return count_undercuts(*planned.model,
                         {.query = query, .facets = facets, .least_travel_mm = least_travel_mm}, Progress())
      .count;
}

/// The tolerance alone decides.
ActionSettings any_travel() {
  ActionSettings settings;
  settings.least_travel_mm = 0.0;
  return settings;
}

/// Of the boxes and pillars below, in their own unit.
double tolerance_of(const TriangleMesh& mesh) { return plan_of(mesh).result.lateral_tolerance; }

TEST(UndercutCount, LeavesOutAHookThatIsShorterThanTheTolerance) {
  const double tolerance = tolerance_of(box_with_hook(1.0));
  const Planned shorter = plan_of(box_with_hook(0.9 * tolerance), any_travel());
  EXPECT_GT(shorter.result.areas[Region::undercut], 3.0 * tolerance) << "there is undercut";
  EXPECT_EQ(count_of(shorter, 0.0), 0U);
  EXPECT_TRUE(shorter.plan.undercuts.empty());
  ASSERT_EQ(shorter.plan.specks.size(), 2U) << "what it hides, and its own underside";
  EXPECT_NE(shorter.plan.specks[0].reason, SpeckReason::small);
  EXPECT_NEAR(shorter.plan.specks[1].area, 0.9 * tolerance * k_hook_width, 1e-3);
  EXPECT_EQ(shorter.plan.specks[1].reason, SpeckReason::narrow);
  EXPECT_NEAR(shorter.plan.specks[1].place.z, 14.0, 1e-9);
  const Planned longer = plan_of(box_with_hook(1.2 * tolerance), any_travel());
  EXPECT_EQ(count_of(longer, 0.0), 1U);
  EXPECT_EQ(longer.plan.undercuts.size(), 1U);
}

/// Every point of it is near where it is free, if each in another direction.
TEST(UndercutCount, LeavesOutARingThatIsShallowerThanTheTolerance) {
  const double tolerance = tolerance_of(pillar_with_groove(1.0));
  const Planned shallow = plan_of(pillar_with_groove(0.9 * tolerance), any_travel());
  EXPECT_GT(shallow.result.areas[Region::undercut], 0.0);
  EXPECT_EQ(count_of(shallow, 0.0), 0U);
  const Planned deep = plan_of(pillar_with_groove(1.2 * tolerance), any_travel());
  EXPECT_EQ(count_of(deep, 0.0), 1U);
}

TEST(UndercutCount, IsThatOfTheListWhateverIsAskedOfTheActions) {
  ActionSettings strict;
  strict.incline_deg = strict.slide_angle_deg = 0.0;
  for (const ActionSettings& settings : {ActionSettings(), strict}) {
    const Planned pockets = plan_of(block_with_pockets(60.0), settings);
    EXPECT_EQ(pockets.plan.undercuts.size(), 2U);
    EXPECT_EQ(count_of(pockets), 2U);
  }
}

TEST(UndercutCount, LeavesOutWhatALessThanTheLeastTravelClears) {
  constexpr double k_hook = 0.4;
  const TriangleMesh mesh = box_with_hook(k_hook);
  for (const double least : {0.5 * k_hook, 2.0 * k_hook}) {
    ActionSettings settings;
    settings.least_travel_mm = least;
    const Planned planned = plan_of(mesh, settings);
    const std::size_t number = least > k_hook ? 0 : 1;
    EXPECT_EQ(planned.plan.undercuts.size(), number);
    EXPECT_EQ(count_of(planned, least), number);
    EXPECT_EQ(planned.plan.actions.size(), number);
    EXPECT_EQ(planned.plan.specks.size(), 1 - number);
    EXPECT_TRUE(planned.plan.unreleased.empty());
  }
}

/// A dimple beside two pockets that are a thousand times as large.
TEST(UndercutCount, LeavesOutAThousandthOfTheWhole) {
  for (const double width : {0.4, 1.2}) {
    const glm::dvec3 low(0, 0, 0), high(40, 100, 20);
    const glm::dvec3 pocket_low(20, 10, 5), pocket_high(40, 50, 15);
    const glm::dvec3 low_of_dimple(40.0 - width, 80, 10), high_of_dimple(40, 80.0 + width, 10.0 + width);
    SolidBuilder solid;
    solid.box(low, high, {1});
    solid.box(pocket_low, pocket_high, {1}, true);
    solid.box(low_of_dimple, high_of_dimple, {1}, true);
    solid.face(box_face(low, high, 1),
               {box_face(pocket_low, pocket_high, 1), box_face(low_of_dimple, high_of_dimple, 1)});
    const Planned planned = plan_of(solid.mesh());
    const bool counts = 5.0 * width * width > 1e-3 * planned.result.areas[Region::undercut];
    EXPECT_EQ(counts, width > 1.0) << "one of either";
    EXPECT_EQ(planned.plan.undercuts.size(), counts ? 2U : 1U);
    EXPECT_EQ(count_of(planned), planned.plan.undercuts.size());
    ASSERT_EQ(planned.plan.specks.size(), counts ? 0U : 1U);
    if (counts) continue;
    EXPECT_EQ(planned.plan.specks[0].reason, SpeckReason::small);
    EXPECT_LT(glm::distance(planned.plan.specks[0].place, low_of_dimple), 2.0 * width);
  }
}

}  // namespace
}  // namespace moldlight
