// The solids that actions move: closed as files, beside the part at every moment, and of known volume.
#include "actions/action_body.hpp"

#include <cmath>
#include <filesystem>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "actions/actions_files.hpp"
#include "actions/body_figures.hpp"
#include "io/mesh_writer.hpp"
#include "mesh/health.hpp"
#include "support/random.hpp"
#include "support/scratch_folder.hpp"
#include "unit/actions/known_undercuts.hpp"

namespace moldlight {
namespace {

/// Signed solid angle of a closed mesh over 4 pi: 1 inside, 0 outside.
double winding(const TriangleMesh& mesh, const glm::dvec3& point) {
  double sum = 0.0;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const glm::dvec3 a = mesh.corner(facet, 0) - point, b = mesh.corner(facet, 1) - point,
                     c = mesh.corner(facet, 2) - point;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    sum += 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)),
                            la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
  }
  return sum / (4.0 * std::numbers::pi);
}

/// As it reads back from a file: closed, and each edge with two facets.
HealthReport written(const TriangleMesh& body) {
  const test::ScratchFolder folder;
  write_stl(folder.file("body.stl"), body, {});
  return load_part(folder.file("body.stl"), {}, Progress())->health;
}

void expect_sound(const TriangleMesh& body) {
  const HealthReport health = written(body);
  EXPECT_EQ(health.open_edges, 0U);
  EXPECT_EQ(health.nonmanifold_edges, 0U);
  EXPECT_EQ(health.inconsistent_edges, 0U);
  EXPECT_GT(health.volume, 0.0);
}

/// Points inside the body that are farther from its surface than rounding: none is inside the part wherever
/// the body is on its way.
void expect_apart(const Planned& planned, const SideAction& action, const TriangleMesh& body) {
  test::Random random(11);
  const Bounds box = bounds(body);
  const TriangleMesh& part = planned.model->part.mesh;
  int inside = 0;
  for (int tried = 0; tried < 4000 && inside < 40; ++tried) {
    const glm::dvec3 point(random.between(box.min.x, box.max.x), random.between(box.min.y, box.max.y),
                           random.between(box.min.z, box.max.z));
    if (winding(body, point) < 0.5) continue;
    ++inside;
    for (const double share : {0.0, 0.01, 0.1, 0.3, 0.6, 1.0}) {
      const glm::dvec3 moved(action_motion(action, share) * glm::dvec4(point, 1.0));
      EXPECT_LT(winding(part, moved), 0.5) << "at a share of " << share << " of its travel";
    }
  }
  EXPECT_GE(inside, 40) << "too thin to be tested";
}

Planned measured(Planned planned, const BodyPlay& play = {}, bool fine = true) {
  const Progress progress;
  BodyPlayer(*planned.model, planned.result, progress, play).measure(planned.plan, fine);
  return planned;
}
std::shared_ptr<const TriangleMesh> body_of(const Planned& planned) {
  const auto body = measured(planned).plan.actions.front().body;
  return body ? body->solid : nullptr;
}

TEST(ActionBody, OfAStraightHoleIsAPlugThroughIt) {
  for (const bool through : {true, false}) {
    for (const double azimuth_deg : {0.0, 33.0, 211.0}) {
      const Hole hole{.through = through};
      const Planned planned = plan_of(laid(block_with_hole(hole), azimuth_deg));
      ASSERT_EQ(planned.plan.actions.size(), 1U);
      const auto body = body_of(planned);
      ASSERT_TRUE(body);
      expect_sound(*body);
      expect_apart(planned, planned.plan.actions.front(), *body);
      // The hole's depth and, beyond the part, a share of the diagonal.
      const double section =
          0.5 * hole.sides * hole.radius * hole.radius * std::sin(2.0 * std::numbers::pi / hole.sides);
      const double deep = through ? 22.0 : hole.depth;
      EXPECT_NEAR(signed_volume(*body), section * (deep + 0.08 * planned.model->frame.diagonal),
                  0.002 * section * deep)
          << through << " " << azimuth_deg;
    }
  }
}

TEST(ActionBody, UnderAHookMovesOutFromUnderIt) {
  const TriangleMesh mesh = block_with_cavity(
      {{2, 20}, {2, 16}, {5, 16}, {5, 14}, {2, 14}, {2, 2}, {38, 2}, {38, 20}}, {40, 20}, 30.0);
  const Planned planned = plan_of(mesh);
  ASSERT_EQ(planned.plan.actions.size(), 1U);
  const auto body = body_of(planned);
  ASSERT_TRUE(body);
  expect_sound(*body);
  expect_apart(planned, planned.plan.actions.front(), *body);
}

TEST(BodyFigures, OfAPinAreItsVolumeItsSectionAndThatItIsClear) {
  const Hole hole{.through = false};
  const Planned planned = measured(plan_of(laid(block_with_hole(hole), 33.0)));
  const auto& body = planned.plan.actions.front().body;
  ASSERT_TRUE(body);
  EXPECT_EQ(body->volume, signed_volume(*body->solid));
  const double section =
      0.5 * hole.sides * hole.radius * hole.radius * std::sin(2.0 * std::numbers::pi / hole.sides);
  EXPECT_NEAR(body->least_section, section, 0.002 * section);
  EXPECT_FALSE(body->hit);
  EXPECT_EQ(clear_text(planned.plan.actions.front(), planned.plan, "mm"), "clear");
}

TEST(BodyFigures, OfAPinPulledThroughThePartSayWhatItHits) {
  Planned planned = plan_of(laid(block_with_hole({.through = false}), 0.0));
  planned.plan.actions.front().direction *= -1.0;
  planned = measured(planned);
  const auto& body = planned.plan.actions.front().body;
  ASSERT_TRUE(body);
  ASSERT_TRUE(body->hit);
  EXPECT_FALSE(body->hit->action) << "the part";
  EXPECT_EQ(body->hit->stage, HitStage::way) << "where it is deepest";
  EXPECT_GT(body->hit->depth, 2.0);
  const ActionSettings settings;
  const auto json = actions_json({*planned.model, planned.result, settings, planned.plan});
  EXPECT_EQ(json["actions"][0]["clear"]["hits"], "part");
  EXPECT_EQ(json["actions"][0]["clear"]["depth"], body->hit->depth);
  EXPECT_EQ(json["actions"][0]["body"]["volume"], body->volume);
  EXPECT_NE(clear_text(planned.plan.actions.front(), planned.plan, "mm").find("deep in the part on its way"),
            std::string::npos);
}

/// None of the lines of the coarse lattice passes it.
TEST(BodyFigures, OfABodyThinBesideThePointsThatAreTriedFirstAreFound) {
  for (const bool fine : {false, true}) {
    Planned planned = plan_of(laid(block_with_hole({.through = false}), 0.0));
    planned.plan.actions.front().direction *= -1.0;
    planned = measured(planned, {.points = 60}, fine);
    const auto& body = planned.plan.actions.front().body;
    ASSERT_TRUE(body);
    ASSERT_TRUE(body->hit) << fine;
    EXPECT_GT(body->hit->depth, 2.0) << fine;
  }
}

TEST(BodyFigures, AreTheSameForFacetsInAnyOrderAndMirrored) {
  const TriangleMesh mesh = laid(block_with_hole({.through = false}), 0.0);
  std::vector<double> depths;
  for (const TriangleMesh& each :
       {mesh, test::permuted(mesh, 1), test::permuted(mesh, 2), test::mirrored(mesh)}) {
    Planned planned = plan_of(each);
    ASSERT_EQ(actions_text(planned.plan), "1 slide");
    planned.plan.actions.front().direction *= -1.0;
    planned = measured(planned);
    const auto& body = planned.plan.actions.front().body;
    ASSERT_TRUE(body && body->hit);
    depths.push_back(body->hit->depth);
  }
  for (const double depth : depths) EXPECT_NEAR(depth, depths.front(), 1e-4);
}

TEST(ActionBody, OfEachActionIsAFileAndFormerOnesGo) {
  const test::ScratchFolder folder;
  const ActionSettings settings;
  const Planned two = measured(plan_of(block_with_pockets(60.0)));
  const auto written = write_action_bodies(folder.file("bodies"), "block",
                                           {*two.model, two.result, settings, two.plan}, false);
  ASSERT_EQ(written.size(), 2U);
  EXPECT_EQ(written[1], folder.file("bodies/block_slide_2.stl"));
  EXPECT_TRUE(std::filesystem::exists(folder.file("bodies/block_slide_2.stl")));
  const Planned one = measured(plan_of(block_with_pockets(40.0)));
  EXPECT_EQ(
      write_action_bodies(folder.file("bodies"), "block", {*one.model, one.result, settings, one.plan}, false)
          .size(),
      1U);
  EXPECT_FALSE(std::filesystem::exists(folder.file("bodies/block_slide_2.stl")));
  EXPECT_TRUE(std::filesystem::exists(folder.file("bodies/block_slide_1.stl")));
}

TEST(ActionPieces, AreAllOfTheUndercuts) {
  const Planned planned = plan_of(block_with_pockets(60.0));
  std::vector<double> areas(planned.plan.actions.size(), 0.0);
  const SplitMesh& split = *planned.result.split;
  for (std::size_t k = 0; k < split.pieces.size(); ++k) {
    const std::int32_t action = planned.plan.action_of_piece[k];
    EXPECT_EQ(action == k_no_action_of_piece, split.pieces[k].region != Region::undercut);
    const auto& [a, b, c] = split.pieces[k].corners;
    if (action >= 0)
      areas[static_cast<std::size_t>(action)] +=
          0.5 * glm::length(
                    glm::cross(split.vertices[b] - split.vertices[a], split.vertices[c] - split.vertices[a]));
  }
  for (std::size_t k = 0; k < areas.size(); ++k) EXPECT_NEAR(areas[k], planned.plan.actions[k].area, 1e-6);
}

/// Spots over the floor of a hole: each takes a column out of the body, until they are 0.5 % of its surface.
TEST(ActionBody, LeavesSpotsOutAtWhichItHits) {
  const Planned planned = plan_of(laid(block_with_hole({}), 0.0));
  ASSERT_EQ(actions_text(planned.plan), "1 slide");
  BodyShaper shaper(*planned.model, *planned.result.split,
                    exact_query(*planned.model, planned.result.query()), planned.plan, 0);
  const double surface = 5.0 * 5.0 * 3.13 + 2.0 * 3.13 * 5.0 * 14.0;  // floor and wall of 32 sides
  const TriangleMesh whole = shaper.shape(1.0).value();
  const Bounds box = bounds(whole);
  const double length = box.max.x - box.min.x, first = signed_volume(whole);
  double volume = first;
  int spots = 0;
  constexpr int k_most = 100;
  for (int k = 0; k < k_most; ++k) {
    const glm::dvec3 hit(box.max.x - 1.0, -3.0 + 0.6 * (k % 10), -3.0 + 0.6 * (k / 10));
    const bool left_out = shaper.leave_out({&hit, 1});
    const double now = signed_volume(shaper.shape(1.0).value());
    if (!left_out) {
      EXPECT_NEAR(now, volume, 1e-5 * volume) << "what is too much stays";
      continue;
    }
    ++spots;
    EXPECT_LT(now, volume);
    volume = now;
  }
  EXPECT_GT(spots, 2);
  EXPECT_LT(spots, k_most) << "not for ever";
  EXPECT_LT(first - volume, 1.02 * k_blocked_share * surface * length);
}

}  // namespace
}  // namespace moldlight
