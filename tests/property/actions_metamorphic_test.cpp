// What must not change, or change in a known way, when a part or a question does.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "actions/action_kind.hpp"
#include "support/box_pile.hpp"
#include "support/mesh_edits.hpp"
#include "unit/actions/known_undercuts.hpp"

namespace moldlight {
namespace {

constexpr std::uint32_t k_piles = 12;

/// Random solids that have undercuts along z.
struct UndercutPile {
  test::BoxPile pile;
  TriangleMesh mesh;
};
std::vector<UndercutPile> undercut_piles() {
  std::vector<UndercutPile> found;
  for (std::uint32_t seed = 1; found.size() < k_piles && seed < 2000; ++seed) {
    test::BoxPile pile = test::random_pile(seed);
    if (test::column_areas(pile, 2, true, 1e-3)[Region::undercut] <= 1.0) continue;
    TriangleMesh mesh = test::pile_mesh(pile, seed);
    found.push_back({std::move(pile), std::move(mesh)});
  }
  return found;
}

bool is_filled(const test::BoxPile& pile, const glm::dvec3& point) {
  std::array<int, 3> cell{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto& planes = pile.planes[static_cast<std::size_t>(axis)];
    cell[static_cast<std::size_t>(axis)] =
        static_cast<int>(std::ranges::upper_bound(planes, point[axis]) - planes.begin()) - 1;
  }
  return pile.is_filled(cell);
}

double weight(const ActionPlan& plan) {
  double sum = 0.0;
  for (const SideAction& action : plan.actions) sum += facts(action.kind).weight;
  return sum;
}

std::vector<double> areas(const ActionPlan& plan) {
  std::vector<double> found;
  for (const UndercutReport& noted : plan.undercuts) found.push_back(noted.undercut.area);
  return found;
}

void expect_near(const std::vector<double>& a, const std::vector<double>& b, double factor) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], factor * b[k], 1e-6 * (1.0 + a[k]));
}

TEST(ActionsMetamorphic, ADirectionTheOtherWayRoundSwapsTheSides) {
  std::size_t actions = 0;
  for (const auto& [pile, mesh] : undercut_piles()) {
    const Planned up = plan_of(mesh, {}, {0, 0, 1}), down = plan_of(mesh, {}, {0, 0, -1});
    expect_near(areas(up.plan), areas(down.plan), 1.0);
    EXPECT_EQ(actions_text(up.plan), actions_text(down.plan));
    EXPECT_NEAR(up.plan.unreleased_area, down.plan.unreleased_area, 1e-6);
    actions += up.plan.actions.size();
  }
  EXPECT_GT(actions, k_piles) << "there is something to swap";
}

TEST(ActionsMetamorphic, APartOfAnotherSizeHasTheSameActions) {
  for (const auto& [pile, mesh] : undercut_piles()) {
    ActionSettings large;
    large.bundle_across_mm *= 4.0;
    large.bundle_along_mm *= 4.0;
    large.clearance_mm *= 4.0;
    const Planned own = plan_of(mesh), scaled = plan_of(test::scaled(mesh, 4.0), large);
    expect_near(areas(scaled.plan), areas(own.plan), 16.0);
    ASSERT_EQ(actions_text(own.plan), actions_text(scaled.plan));
    for (std::size_t k = 0; k < own.plan.actions.size(); ++k)
      EXPECT_NEAR(scaled.plan.actions[k].travel, 4.0 * own.plan.actions[k].travel, 1e-6);
  }
}

TEST(ActionsMetamorphic, ATurnedPartHasTheSameActions) {
  constexpr double k_turn_deg = 27.0;
  const glm::dquat turn =
      glm::angleAxis(glm::radians(k_turn_deg), glm::normalize(glm::dvec3(0.3, -0.5, 0.8)));
  for (const bool through : {false, true}) {
    const TriangleMesh mesh = laid(block_with_hole({.draft_deg = 2.0, .through = through}), 0.0);
    const Planned own = plan_of(mesh),
                  turned = plan_of(test::rotated(mesh, turn), {}, turn * glm::dvec3(0, 0, 1));
    ASSERT_EQ(own.plan.actions.size(), 1U);
    ASSERT_EQ(actions_text(own.plan), actions_text(turned.plan));
    const SideAction &a = own.plan.actions.front(), &b = turned.plan.actions.front();
    EXPECT_LT(glm::distance(turn * a.direction, b.direction), 2e-4);
    EXPECT_NEAR(a.travel, b.travel, 1e-3 * own.model->frame.diagonal);
    EXPECT_NEAR(a.interval.from_deg, b.interval.from_deg, 0.02);
    EXPECT_NEAR(a.interval.to_deg, b.interval.to_deg, 0.02);
  }
}

/// A wall some way off stands in a slide's way.
TEST(ActionsMetamorphic, ABodyFarOffBlocksASlideAndChangesNothingElse) {
  const TriangleMesh hole = laid(block_with_hole({}), 0.0);
  const Planned alone = plan_of(hole);
  ASSERT_EQ(actions_text(alone.plan), "1 slide");
  const glm::dvec3 pull = alone.plan.actions.front().direction;
  ASSERT_NEAR(std::abs(pull.x), 1.0, 1e-6);
  SolidBuilder wall;
  const double at = pull.x > 0.0 ? 100.0 : -104.0;
  wall.box({at, -60, -60}, {at + 4.0, 60, 60});
  TriangleMesh both = hole;
  const TriangleMesh other = wall.mesh();
  const auto first = static_cast<VertexIndex>(both.vertices.size());
  both.vertices.insert(both.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.facets) both.facets.push_back({a + first, b + first, c + first});
  const Planned blocked = plan_of(both);
  expect_near(areas(blocked.plan), areas(alone.plan), 1.0);
  for (const SideAction& action : blocked.plan.actions) EXPECT_NE(action.kind, ActionKind::slide);
}

TEST(ActionsMetamorphic, MoreCandidatesNeverRaiseTheCost) {
  for (const auto& [pile, mesh] : undercut_piles()) {
    ActionSettings wishes;
    for (int k = 0; k < 8; ++k) {
      const double angle = glm::radians(45.0 * k + 7.0);
      wishes.side_directions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    }
    const Planned own = plan_of(mesh), more = plan_of(mesh, wishes);
    EXPECT_LE(more.plan.unreleased_area, own.plan.unreleased_area + 1e-6);
    if (std::abs(more.plan.unreleased_area - own.plan.unreleased_area) < 1e-6) {
      EXPECT_LE(weight(more.plan), weight(own.plan) + 1e-9);
    }
  }
}

TEST(ActionsMetamorphic, AddedMaterialFreesNothing) {
  const double infinite = std::numeric_limits<double>::infinity();
  std::size_t free = 0, blocked = 0;
  for (const auto& [pile, mesh] : undercut_piles()) {
    test::BoxPile more = pile;
    // Every third empty cell.
    std::size_t empty = 0;
    for (char& cell : more.filled) {
      if (cell == 0 && ++empty % 3 == 0) cell = 1;
    }
    const Planned less = plan_of(mesh);
    Part part;
    part.mesh = test::pile_mesh(more, 1);
    part.bodies = {{"", 0, static_cast<FacetIndex>(part.mesh.facets.size())}};
    const auto fuller = prepare_part(std::move(part), Progress());
    const ExactQuery query = exact_query(*less.model, less.result.query());
    const Release before(*less.model, query), after(*fuller, query);
    for (const UndercutReport& noted : less.plan.undercuts) {
      for (const UndercutSample& sample :
           sample_undercut(*less.model, *less.result.split, noted.undercut, 40)) {
        const glm::dvec3 point =
            less.model->frame.center + less.model->frame.diagonal * glm::dvec3(sample.position);
        if (is_filled(more, point + 0.01 * sample.normal)) continue;  // covered now
        for (int k = 0; k < 8; ++k) {
          const double angle = glm::radians(45.0 * k + 3.0);
          const glm::dvec3 pull(std::cos(angle), std::sin(angle), 0.0);
          const double was = before.free_length(sample, pull) * less.model->frame.diagonal;
          UndercutSample same = sample;
          same.position = fuller->frame.to_unit(point);
          const double is = after.free_length(same, pull) * fuller->frame.diagonal;
          free += was == infinite ? 1 : 0;
          blocked += is < was ? 1 : 0;
          EXPECT_LE(is, was * (1.0 + 1e-4) + 1e-4);
        }
      }
    }
  }
  EXPECT_GT(free, 100U);
  EXPECT_GT(blocked, 100U);
}

}  // namespace
}  // namespace moldlight
