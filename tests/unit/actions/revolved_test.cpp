// Threads and rings made by formula: their pitch, axis and strain.
#include "actions/revolved.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include "actions/side_action.hpp"
#include "mold/direction.hpp"
#include "support/mesh_edits.hpp"
#include "support/random.hpp"
#include "support/solid_builder.hpp"

namespace moldlight {
namespace {

using test::at_height;
using test::Loop;
using test::Loop2;
using test::regular_polygon;
using test::SolidBuilder;

constexpr double k_pi = std::numbers::pi;

ActionPlan turned_plan(const TriangleMesh& mesh, const glm::dvec3& direction,
                       double strip_strain_pct = 100.0) {
  Part part;
  part.mesh = mesh;
  part.bodies = {{"", 0, static_cast<FacetIndex>(mesh.facets.size())}};
  const auto model = prepare_part(std::move(part), Progress());
  Query query;
  query.direction = direction;
  ActionSettings settings;
  settings.strip_strain_pct = strip_strain_pct;
  settings.least_travel_mm = settings.pin_diameter_mm = 0.0;
  return find_actions(*model, classify_exact(*model, query, Progress(), true), settings, Progress());
}

struct Screw {
  double lead = 4.0;  // along the axis for a whole turn; negative: left-handed
  int starts = 1;
  double depth = 0.8;
  int round = 48;  // facets for a turn
};

/// A tube with a thread of that lead inside, its flanks at about 40 degrees; the thread fades out at both
/// ends. Facets follow the helix: a step round is a step up.
TriangleMesh nut(const Screw& screw) {
  const int round = screw.round;
  constexpr double k_bore = 8.0, k_outer = 14.0, k_height = 16.0;
  const double rise = std::abs(screw.lead) / round;
  const int levels = static_cast<int>(std::lround(k_height / rise));
  const double sense = screw.lead > 0.0 ? 1.0 : -1.0;
  const auto corner = [&](int i, int level) {
    const double turn = static_cast<double>(i) / round, z = rise * level;
    const double phase = screw.starts * (z / std::abs(screw.lead) - sense * turn);
    const double tooth = std::abs(2.0 * (phase - std::floor(phase + 0.5)));
    const double ends = std::min({1.0, z / 3.0, (k_height - z) / 3.0});
    const double radius =
        k_bore - screw.depth * std::max(0.0, ends) * std::clamp(2.0 * tooth - 0.5, 0.0, 1.0);
    return glm::dvec3(radius * std::cos(2.0 * k_pi * turn), radius * std::sin(2.0 * k_pi * turn), z);
  };
  SolidBuilder solid;
  Loop low, high;
  for (int i = 0; i < round; ++i) {
    low.push_back(corner(i, 0));
    high.push_back(corner(i, levels));
    for (int level = 0; level < levels; ++level) {
      const glm::dvec3 a = corner(i, level), b = corner((i + 1) % round, level),
                       c = corner((i + 1) % round, level + 1), d = corner(i, level + 1);
      // Seen from the bore; the diagonal along the helix.
      if (sense > 0.0) {
        solid.face({a, c, b});
        solid.face({a, d, c});
      } else {
        solid.face({a, d, b});
        solid.face({b, d, c});
      }
    }
  }
  const Loop2 outer = regular_polygon(round, k_outer);
  solid.walls(at_height(outer, 0.0), at_height(outer, rise * levels));
  Loop2 down(outer.rbegin(), outer.rend());
  solid.face(at_height(down, 0.0), {low});
  solid.face(at_height(outer, rise * levels), {high});
  return solid.mesh();
}

TEST(Thread, IsUnscrewedByItsPitch) {
  std::uint32_t seed = 3;
  for (const Screw& screw : {Screw{}, Screw{.lead = -4.0}, Screw{.lead = 6.0, .starts = 2},
                             Screw{.lead = -6.0, .starts = 2}, Screw{.lead = 2.5, .depth = 0.5}}) {
    const glm::dquat turn = test::random_rotation(seed++);
    const glm::dvec3 direction = turn * glm::dvec3(0, 0, 1);
    const ActionPlan plan = turned_plan(test::rotated(nut(screw), turn), direction);
    ASSERT_FALSE(plan.actions.empty()) << screw.lead;
    const SideAction& action = plan.actions.front();
    ASSERT_EQ(action.kind, ActionKind::unscrew) << screw.lead << " " << screw.starts;
    EXPECT_NEAR(action.about->pitch, screw.lead, 0.005 * std::abs(screw.lead)) << screw.starts;
    EXPECT_LT(line_angle_deg(action.about->direction, direction), 0.05);
    const glm::dvec3 off = action.about->point - glm::dot(action.about->point, direction) * direction;
    EXPECT_LT(glm::length(off), 0.05) << "the axis goes through the origin";
    EXPECT_GT(action.about->turns, 0.5);
    EXPECT_NEAR(action.about->turns * std::abs(action.about->pitch), action.travel, 1e-9);
  }
}

TEST(Thread, IsUnscrewedInAnySizeAndPlace) {
  test::Random random(5);
  for (int k = 0; k < 10; ++k) {
    Screw screw{.lead = random.between(2.0, 5.0) * (random.chance(0.5) ? 1.0 : -1.0),
                .starts = static_cast<int>(1 + random.below(2)),
                .depth = random.between(0.5, 1.0),
                .round = static_cast<int>(36 + random.below(40))};
    screw.lead *= screw.starts;
    constexpr double k_scales[] = {1e-3, 1.0, 1e3};
    const double scale = k_scales[random.below(3)];
    const glm::dvec3 offset = random.in_cube(1e4);
    const ActionPlan plan = turned_plan(test::scaled(test::translated(nut(screw), offset), scale), {0, 0, 1});
    SCOPED_TRACE(::testing::Message()
                 << k << ": lead " << screw.lead << ", starts " << screw.starts << ", depth " << screw.depth
                 << ", " << screw.round << " sides, scale " << scale);
    ASSERT_FALSE(plan.actions.empty());
    const SideAction& action = plan.actions.front();
    ASSERT_EQ(action.kind, ActionKind::unscrew);
    EXPECT_NEAR(action.about->pitch, screw.lead * scale, 0.005 * std::abs(screw.lead) * scale);
    const glm::dvec3 off = action.about->point / scale - offset;
    EXPECT_LT(std::hypot(off.x, off.y), 0.05);
  }
}

struct Groove {
  double depth = 0.5;
  bool inside = true;
};

/// A tube with a ring groove inside, or outside.
TriangleMesh grooved(const Groove& groove) {
  constexpr int k_round = 72;
  constexpr double k_bore = 9.0, k_outer = 13.0, k_height = 20.0, k_low = 8.0, k_high = 10.0;
  const double plain = groove.inside ? k_bore : k_outer;
  const double deep = groove.inside ? plain + groove.depth : plain - groove.depth;
  const Loop2 near = regular_polygon(k_round, plain), far = regular_polygon(k_round, deep);
  const Loop2 other = regular_polygon(k_round, groove.inside ? k_outer : k_bore);
  SolidBuilder solid;
  const auto reversed = [](const Loop2& loop) { return Loop2(loop.rbegin(), loop.rend()); };
  const auto wall = [&](const Loop2& loop, double from, double to, bool inward) {
    const Loop2 way = inward ? reversed(loop) : loop;
    solid.walls(at_height(way, from), at_height(way, to));
  };
  wall(near, 0.0, k_low, groove.inside);
  wall(far, k_low, k_high, groove.inside);
  wall(near, k_high, k_height, groove.inside);
  wall(other, 0.0, k_height, !groove.inside);
  const Loop2& outer = groove.inside ? other : near;
  const Loop2& inner = groove.inside ? near : other;
  solid.face(at_height(reversed(outer), 0.0), {at_height(inner, 0.0)});
  solid.face(at_height(outer, k_height), {at_height(inner, k_height)});
  const Loop2& wide = groove.inside ? far : near;
  const Loop2& narrow = groove.inside ? near : far;
  // Inside, the groove's floor looks up and its ceiling down; outside the same.
  solid.face(at_height(wide, k_low), {at_height(narrow, k_low)});
  solid.face(at_height(reversed(wide), k_high), {at_height(narrow, k_high)});
  return solid.mesh();
}

TEST(Ring, IsStrippedAtItsStrain) {
  for (const auto& [groove, strain] :
       {std::pair(Groove{}, 0.5 / 9.0), std::pair(Groove{.depth = 0.2}, 0.2 / 9.0),
        std::pair(Groove{.depth = 0.4, .inside = false}, 0.4 / 13.0)}) {
    const ActionPlan plan = turned_plan(grooved(groove), {0, 0, 1});
    ASSERT_EQ(plan.actions.size(), 1U) << groove.depth << groove.inside;
    const SideAction& action = plan.actions.front();
    ASSERT_EQ(action.kind, ActionKind::strip);
    EXPECT_NEAR(action.about->strain, strain, 0.001) << groove.depth << groove.inside;
    EXPECT_EQ(action.about->pitch, 0.0);
    EXPECT_TRUE(plan.unreleased.empty());
    const auto limited = [&ring = groove](double pct) { return turned_plan(grooved(ring), {0, 0, 1}, pct); };
    EXPECT_EQ(limited(100.0 * strain + 0.2).actions.size(), 1U);
    // Slides close around an outer groove; no set of lifters frees all of one inside.
    const ActionPlan refused = limited(100.0 * strain - 0.2);
    EXPECT_EQ(refused.actions.empty(), groove.inside);
    EXPECT_EQ(refused.unreleased.size(), groove.inside ? 1U : 0U);
    for (const SideAction& each : refused.actions)
      EXPECT_NE(each.kind, ActionKind::strip) << "more than the user allows";
    const auto told =
        std::ranges::find(refused.rejected, RejectReason::too_strained, &RejectedAction::reason);
    ASSERT_EQ(told != refused.rejected.end(), groove.inside) << "slides release the other";
    if (!groove.inside) continue;
    EXPECT_NEAR(told->strain, strain, 0.001);
    EXPECT_NEAR(told->depth, groove.depth, 0.02);
    EXPECT_EQ(told->kind, ActionKind::strip);
  }
}

/// A ring groove turns about its axis, but that releases nothing.
TEST(Ring, IsNoThread) {
  for (const SideAction& action : turned_plan(grooved({}), {0, 0, 1}).actions)
    EXPECT_NE(action.kind, ActionKind::unscrew);
}

}  // namespace
}  // namespace moldlight
