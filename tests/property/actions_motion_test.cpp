// Side actions of real parts are played: what a pull or a lifter frees is moved in steps, and no point of it
// ever enters the part by more than the tolerances allow.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "actions/action_body.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

namespace fs = std::filesystem;

constexpr double k_rounding = 1e-6;  // of single precision, in the unit frame

/// Signed solid angle under which a facet is seen from the origin (van Oosterom and Strackee 1983).
double solid_angle(const std::array<glm::dvec3, 3>& corners) {
  const auto& [a, b, c] = corners;
  const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
  const double below = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  return 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)), below);
}

double distance_to_segment(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 along = b - a;
  const double squared = glm::dot(along, along);
  const double at = squared > 0.0 ? std::clamp(-glm::dot(a, along) / squared, 0.0, 1.0) : 0.0;
  return glm::length(a + at * along);
}

/// From the origin.
double distance_to_facet(const std::array<glm::dvec3, 3>& corners) {
  const auto& [a, b, c] = corners;
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const bool above = glm::dot(glm::cross(a, b), normal) > 0.0 && glm::dot(glm::cross(b, c), normal) > 0.0 &&
                     glm::dot(glm::cross(c, a), normal) > 0.0;
  if (above) return std::abs(glm::dot(a, normal)) / glm::length(normal);
  return std::min({distance_to_segment(a, b), distance_to_segment(b, c), distance_to_segment(c, a)});
}

/// By the crossings of a line: those where it leaves a body less those where it enters one. Now and then
/// wrong, where it grazes an edge.
bool seems_inside(const PartModel& model, const glm::dvec3& point, const glm::dvec3& along) {
  constexpr double k_past = 1e-6;
  int depth = 0;
  double gone = 0.0;
  for (int crossings = 0; crossings < 1000; ++crossings) {
    const auto hit = model.rays().first_hit(glm::vec3(point + gone * along), glm::vec3(along), false);
    if (!hit) break;
    gone += static_cast<double>(hit->distance) + k_past;
    depth += glm::dot(model.geometry.normals[hit->facet], along) > 0.0 ? 1 : -1;
  }
  return depth > 0;
}

/// Distance to the surface of a point inside the part, 0 outside. What one of two lines takes to be inside is
/// so if the solid angle of all facets says so, which holds for bodies that touch or overlap, too.
double depth_of(const PartModel& model, const glm::dvec3& point) {
  if (!seems_inside(model, point, glm::normalize(glm::dvec3(0.3612, 0.6173, 0.6990))) &&
      !seems_inside(model, point, glm::normalize(glm::dvec3(-0.5127, 0.4391, -0.7377))))
    return 0.0;
  double angle = 0.0, nearest = std::numeric_limits<double>::infinity();
  for (FacetIndex facet = 0; facet < model.part.mesh.facets.size(); ++facet) {
    std::array<glm::dvec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] =
          (model.part.mesh.corner(facet, static_cast<int>(k)) - model.frame.center) / model.frame.diagonal -
          point;
    angle += solid_angle(corners);
    nearest = std::min(nearest, distance_to_facet(corners));
  }
  return angle > 2.0 * std::numbers::pi ? nearest : 0.0;
}

/// Whether a point of the surface, moved by `travel`, goes into the part by more than the lateral tolerance
/// and what its way inside adds to that at the required draft.
bool enters(const PartModel& model, const ExactQuery& query, const UndercutSample& sample,
            const glm::dvec3& travel) {
  constexpr int k_steps = 50;
  const double sine = std::sin(glm::radians(query.tau_deg)), length = glm::length(travel);
  double outside = 0.0;  // the last share of the travel at which it was
  for (int step = 1; step <= k_steps; ++step) {
    const double gone = static_cast<double>(step) / k_steps;
    const double depth = depth_of(model, glm::dvec3(sample.position) + gone * travel);
    if (depth > query.lateral + (gone - outside) * length * sine + k_rounding) return true;
    if (depth <= 0.0) outside = gone;
  }
  return false;
}

struct Played {
  std::size_t actions = 0, points = 0, inside = 0;
  std::size_t bodies = 0, body_points = 0, body_inside = 0;
};

/// Points all over the surface of a body, from its first place to its last: how many are in the part by more
/// than the tolerances.
void play_body(const PartModel& model, const ExactQuery& query, const SideAction& action,
               const TriangleMesh& body, Played& played) {
  constexpr std::size_t k_points = 60;
  constexpr int k_places = 6;
  const double sine = std::sin(glm::radians(query.tau_deg));
  ++played.bodies;
  const std::size_t step = std::max<std::size_t>(1, body.facets.size() / k_points);
  for (FacetIndex facet = 0; facet < body.facets.size(); facet += static_cast<FacetIndex>(step)) {
    const glm::dvec3 middle = (body.corner(facet, 0) + body.corner(facet, 1) + body.corner(facet, 2)) / 3.0;
    ++played.body_points;
    for (int place = 0; place <= k_places; ++place) {
      const glm::dvec3 moved(action_motion(action, static_cast<double>(place) / k_places) *
                             glm::dvec4(middle, 1.0));
      const double depth = depth_of(model, glm::dvec3(model.frame.to_unit(moved)));
      if (depth <= query.lateral + sine + k_rounding) continue;
      ++played.body_inside;
      break;
    }
  }
}

Played play(const PartModel& model, const Query& query) {
  const Classification result = classify_exact(model, query, Progress(), true);
  const ActionPlan plan = find_actions(model, result, {}, Progress());
  const ExactQuery exact = exact_query(model, query);
  Played played;
  for (std::size_t k = 0; k < plan.actions.size(); ++k) {
    const SideAction& action = plan.actions[k];
    if (!action.about) {
      if (const auto body = action_body(model, result, plan, k))
        play_body(model, exact, action, *body, played);
    }
    if (action.about || action.patches.size() != 1) continue;
    const UndercutReport& patch = plan.patches[action.patches.front()];
    // Parts of an undercut move their own ways.
    if (action.area < 0.99 * patch.undercut.area) continue;
    ++played.actions;
    const glm::dvec3 travel = action.travel / model.frame.diagonal * action.direction;
    for (const UndercutSample& sample : sample_undercut(model, *result.split, patch.undercut, 60)) {
      ++played.points;
      played.inside += enters(model, exact, sample, travel) ? 1 : 0;
    }
  }
  return played;
}

/// Those that are shipped, and shared ones where they are found; or all in the folder that MOLDLIGHT_PARTS
/// names.
std::vector<fs::path> real_parts() {
  std::vector<fs::path> parts;
  const char* const only = std::getenv("MOLDLIGHT_PARTS");
  if (only != nullptr) {
    for (const auto& entry : fs::directory_iterator(only)) {
      if (entry.is_regular_file() && entry.path().extension() != ".tsv") parts.push_back(entry.path());
    }
    std::ranges::sort(parts);
    return parts;
  }
  for (const auto& entry : fs::directory_iterator(test::asset_folder() / "parts"))
    parts.push_back(entry.path());
  if (const auto shared = test::shared_folder()) {
    for (const char* name : {"m5_stamplc_face_shell.stl", "framework_expansion_card.stl",
                             "trimesh_featuretype.stl", "m5_atomic_battery_bottom.obj", "so101_trigger.stl",
                             "odri_hip_cover_64k.stl", "so101_waveshare_plate.stl", "trimesh_fixed_top.ply",
                             "so101_base.stl", "m5_rfid2_face_shell.stl", "trimesh_angle_block_open.stl"})
      parts.push_back(*shared / "parts" / name);
  }
  std::ranges::sort(parts);
  return parts;
}

TEST(ActionsMotion, NeverEntersThePart) {
  const std::vector<fs::path> parts = real_parts();
  std::size_t actions = 0, bodies = 0;
  for (const fs::path& path : parts) {
    const auto model = load_part(path.string(), {}, Progress());
    for (const glm::dvec3 direction : {glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0)}) {
      Query query;
      query.direction = direction;
      const Played played = play(*model, query);
      actions += played.actions;
      bodies += played.bodies;
      EXPECT_LE(static_cast<double>(played.body_inside), 0.02 * static_cast<double>(played.body_points) + 1.0)
          << path.filename() << " along " << direction.x << direction.z << ": " << played.body_inside
          << " of " << played.body_points << " points of bodies";
      // Of an undercut 0.5 % may stay blocked, and a sample is 1.7 % of one.
      EXPECT_LE(static_cast<double>(played.inside), 0.01 * static_cast<double>(played.points) + 1.0)
          << path.filename() << " along " << direction.x << direction.z << ": " << played.inside << " of "
          << played.points;
    }
  }
  std::cout << actions << " actions and " << bodies << " bodies of " << parts.size() << " parts played\n";
  EXPECT_GT(actions, 10U);
}

/// What is said to get away along a pull, whether an action is made of it or not.
TEST(ActionsMotion, OfAFreePointNeverEntersThePart) {
  constexpr std::size_t k_patches = 4;
  constexpr double k_far = 0.6;  // of the diagonal
  std::size_t all = 0;
  for (const fs::path& path : real_parts()) {
    const auto model = load_part(path.string(), {}, Progress());
    Query query;
    query.direction = glm::dvec3(1, 0, 0);
    const Classification result = classify_exact(*model, query, Progress(), true);
    const ExactQuery exact = exact_query(*model, query);
    const Release release(*model, exact);
    const Undercuts found = find_undercuts(*model, *result.split, exact);
    std::size_t points = 0, free = 0, inside = 0;
    for (std::size_t k = 0; k < std::min(k_patches, found.patches.size()); ++k) {
      for (const UndercutSample& sample : sample_undercut(*model, *result.split, found.patches[k], 40)) {
        ++points;
        bool once = false;
        for (int turn_deg = 0; turn_deg < 360; turn_deg += 15) {
          const glm::dvec3 pull = turned_about({0, 1, 0}, exact.direction, turn_deg + 0.3);
          if (std::isfinite(release.free_length(sample, pull))) continue;
          ++free;
          once = once || enters(*model, exact, sample, k_far * pull);
        }
        inside += once ? 1 : 0;
      }
    }
    all += free;
    // One may lie so near the foot of a wall that it starts behind it.
    EXPECT_LE(static_cast<double>(inside), k_blocked_share * static_cast<double>(points) + 1.0)
        << path.filename() << ": " << inside << " of " << points << ", " << free << " pulls";
  }
  EXPECT_GT(all, 2000U);
}

}  // namespace
}  // namespace moldlight
