// What counts as an undercut: one that nowhere is deeper than the lateral tolerance does not.
#include <numbers>

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

std::size_t count_of(const Planned& planned) {
  std::vector<FacetIndex> facets;
  for (FacetIndex facet = 0; facet < planned.result.facet_fractions.size(); ++facet) {
    if (planned.result.facet_fractions[facet][static_cast<std::size_t>(Region::undercut)] > 0.0)
      facets.push_back(facet);
  }
  return count_undercuts(*planned.model, exact_query(*planned.model, planned.result.query()), facets,
                         Progress())
      .count;
}

/// Of the boxes and pillars below, in their own unit.
double tolerance_of(const TriangleMesh& mesh) { return plan_of(mesh).result.lateral_tolerance; }

TEST(UndercutCount, LeavesOutAHookThatIsShorterThanTheTolerance) {
  const double tolerance = tolerance_of(box_with_hook(1.0));
  const Planned shorter = plan_of(box_with_hook(0.9 * tolerance));
  EXPECT_GT(shorter.result.areas[Region::undercut], 3.0 * tolerance) << "there is undercut";
  EXPECT_EQ(count_of(shorter), 0U);
  EXPECT_TRUE(shorter.plan.patches.empty());
  EXPECT_EQ(shorter.plan.dropped, 2U) << "what it hides, and its own underside";
  const Planned longer = plan_of(box_with_hook(1.2 * tolerance));
  EXPECT_EQ(count_of(longer), 1U);
  EXPECT_EQ(longer.plan.patches.size(), 1U);
}

/// Every point of it is near where it is free, if each in another direction.
TEST(UndercutCount, LeavesOutARingThatIsShallowerThanTheTolerance) {
  const double tolerance = tolerance_of(pillar_with_groove(1.0));
  const Planned shallow = plan_of(pillar_with_groove(0.9 * tolerance));
  EXPECT_GT(shallow.result.areas[Region::undercut], 0.0);
  EXPECT_EQ(count_of(shallow), 0U);
  const Planned deep = plan_of(pillar_with_groove(1.2 * tolerance));
  EXPECT_EQ(count_of(deep), 1U);
}

TEST(UndercutCount, IsThatOfTheListWhateverIsAskedOfTheActions) {
  ActionSettings strict;
  strict.incline_deg = strict.slide_angle_deg = 0.0;
  for (const ActionSettings& settings : {ActionSettings(), strict}) {
    const Planned pockets = plan_of(block_with_pockets(60.0), settings);
    EXPECT_EQ(pockets.plan.patches.size(), 2U);
    EXPECT_EQ(count_of(pockets), 2U);
  }
}

}  // namespace
}  // namespace moldlight
