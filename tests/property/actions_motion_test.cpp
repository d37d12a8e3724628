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
#include <numeric>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "actions/action_body.hpp"
#include "actions/body_figures.hpp"
#include "mesh/facet_geometry.hpp"
#include "support/random.hpp"
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

/// By one of two lines: surely outside if not.
bool may_be_inside(const PartModel& model, const glm::dvec3& point) {
  return seems_inside(model, point, glm::normalize(glm::dvec3(0.3612, 0.6173, 0.6990))) ||
         seems_inside(model, point, glm::normalize(glm::dvec3(-0.5127, 0.4391, -0.7377)));
}

/// Distance to the surface of a point inside the part, 0 outside: by the solid angle of all facets, which
/// holds for bodies that touch or overlap, too.
double depth_of(const PartModel& model, const glm::dvec3& point) {
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

/// Whether a point that may be inside the part is so by more than `most`. Surface that one of a few rays
/// finds nearer spares the distance to all of it.
bool is_deeper(const PartModel& model, const glm::dvec3& point, double most) {
  for (int k = 0; k < 27; ++k) {
    const glm::dvec3 way(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
    if (way == glm::dvec3(0.0)) continue;
    const auto hit = model.rays().first_hit(glm::vec3(point), glm::vec3(glm::normalize(way)), false);
    if (!hit || static_cast<double>(hit->distance) <= most) return false;
  }
  return depth_of(model, point) > most;
}

/// Whether a point of the surface goes into the part on its way by more than the lateral tolerance and what
/// its way inside adds to that at the required draft. `way` shows where it is at a share of it, unit frame.
template <typename Way>
bool enters(const PartModel& model, const ExactQuery& query, double length, const Way& way,
            double play = 0.0) {
  constexpr int k_steps = 50;
  const double sine = std::sin(glm::radians(query.tau_deg));
  double outside = 0.0;  // the last share of the way at which it was
  for (int step = 1; step <= k_steps; ++step) {
    const double gone = static_cast<double>(step) / k_steps;
    const glm::dvec3 at = way(gone);
    if (!may_be_inside(model, at))
      outside = gone;
    else if (is_deeper(model, at, query.lateral + play + (gone - outside) * length * sine + k_rounding))
      return true;
  }
  return false;
}

/// Where a point of the unit frame is at a share of an action's travel.
glm::dvec3 moved(const PartModel& model, const SideAction& action, const glm::dvec3& point, double share) {
  const glm::dvec3 place = model.frame.center + model.frame.diagonal * point;
  return glm::dvec3(model.frame.to_unit(glm::dvec3(action_motion(action, share) * glm::dvec4(place, 1.0))));
}

struct Played {
  std::size_t actions = 0, points = 0, inside = 0;
  std::string noted;       // which actions have points inside, and how many
  std::size_t astray = 0;  // points of facets that an action frees in part only, and goes with whole
  std::size_t bodies = 0, clear_bodies = 0, body_points = 0, body_inside = 0;
};

/// Points all over the surface of a body that is said to be clear, evenly by area, from its first place to
/// its last: how many are in the part by more than twice the lateral tolerance.
void play_body(const PartModel& model, const ExactQuery& query, const SideAction& action,
               const TriangleMesh& body, Played& played) {
  constexpr std::size_t k_points = 200;
  constexpr int k_places = 40;
  const double most = 2.0 * query.lateral + k_rounding;
  ++played.clear_bodies;
  std::vector<double> areas(body.facets.size());
  for (FacetIndex facet = 0; facet < body.facets.size(); ++facet)
    areas[facet] = 0.5 * glm::length(twice_area_vector(body, facet));
  const double each = std::accumulate(areas.begin(), areas.end(), 0.0) / k_points;
  test::Random random(3);
  double passed = 0.0;
  for (FacetIndex facet = 0; facet < body.facets.size(); ++facet) {
    for (passed += areas[facet]; passed >= each; passed -= each) {
      const double turn = std::sqrt(random.between(0.0, 1.0)), share = random.between(0.0, 1.0);
      const glm::dvec3 point = (1.0 - turn) * body.corner(facet, 0) +
                               turn * ((1.0 - share) * body.corner(facet, 1) + share * body.corner(facet, 2));
      const glm::dvec3 from(model.frame.to_unit(point));
      ++played.body_points;
      for (int place = 0; place <= k_places; ++place) {
        const glm::dvec3 at = moved(model, action, from, static_cast<double>(place) / k_places);
        if (!may_be_inside(model, at) || !is_deeper(model, at, most)) continue;
        ++played.body_inside;
        break;
      }
    }
  }
}

/// What the action's own rays say of a point.
bool is_said_free(const Release& release, const ExactQuery& query, const PartModel& model,
                  const SideAction& action, const UndercutSample& sample) {
  if (release.is_covered(sample)) return false;
  if (action.kind == ActionKind::insert && release.covered(sample, action.direction)) return false;
  const double length = release.free_length(sample, action.direction);
  if (action.kind != ActionKind::lifter) return length == std::numeric_limits<double>::infinity();
  const double travel = action.travel / model.frame.diagonal;
  return length >= travel && release.clear(sample, action.direction, travel,
                                           action.core_side ? query.direction : -query.direction);
}

/// Every action, but what is stripped, as the part itself moves there.
Played play(const PartModel& model, const Query& query) {
  constexpr std::size_t k_points = 60;
  constexpr double k_thread_play = 0.04;  // of the pitch: threads of facets leave their helix by so much
  const Classification result = classify_exact(model, query, Progress(), true);
  ActionPlan plan = find_actions(model, result, {}, Progress());
  const Progress progress;
  BodyPlayer(model, result, progress).measure(plan);
  const ExactQuery exact = exact_query(model, query);
  std::vector<Undercut> surfaces(plan.actions.size());
  for (std::uint32_t piece = 0; piece < result.split->pieces.size(); ++piece) {
    if (plan.action_of_piece[piece] < 0) continue;
    Undercut& surface = surfaces[static_cast<std::size_t>(plan.action_of_piece[piece])];
    surface.pieces.push_back(piece);
    surface.area += piece_area(*result.split, result.split->pieces[piece]);
  }
  const Release release(model, exact);
  Played played;
  for (std::size_t k = 0; k < plan.actions.size(); ++k) {
    const SideAction& action = plan.actions[k];
    if (action.kind == ActionKind::strip) continue;
    ++played.actions;
    const bool turns = action.kind == ActionKind::unscrew;
    const double length =
        (action.travel + (turns ? action.about->turns * model.frame.diagonal : 0.0)) / model.frame.diagonal;
    // Parts of an undercut that was split end within facets.
    const double whole = std::accumulate(
        action.undercuts.begin(), action.undercuts.end(), 0.0,
        [&](double sum, std::size_t undercut) { return sum + plan.undercuts[undercut].undercut.area; });
    const bool in_parts = action.area < 0.999 * whole;
    const double play = turns ? k_thread_play * std::abs(action.about->pitch) / model.frame.diagonal : 0.0;
    // Slivers of an action whose facets went with others are not worth as many points.
    const auto count = static_cast<std::size_t>(
        std::lround(static_cast<double>(k_points) * std::min(1.0, surfaces[k].area / action.area)));
    std::size_t inside = 0;
    for (const UndercutSample& sample : sample_undercut(model, *result.split, surfaces[k], count)) {
      ++played.points;
      if (in_parts && !is_said_free(release, exact, model, action, sample)) {
        ++played.astray;
        continue;
      }
      const auto way = [&](double share) { return moved(model, action, glm::dvec3(sample.position), share); };
      inside += enters(model, exact, length, way, play) ? 1 : 0;
    }
    played.inside += inside;
    if (inside > 0)
      played.noted += "; " + std::string(facts(action.kind).name) + " " + std::to_string(k + 1) + ": " +
                      std::to_string(inside);
    if (!action.body || turns) continue;
    ++played.bodies;
    if (!action.body->hit) play_body(model, exact, action, *action.body->solid, played);
  }
  return played;
}

/// Only a closed part that is wound in one way, outward, has an inside in which a point can be; empty for one
/// that has.
std::string why_no_inside(const PartModel& model) {
  const HealthReport& health = model.health;
  if (!health.closed)
    return std::to_string(health.open_edges) + " edges are open, " +
           std::to_string(health.inconsistent_edges) + " between facets wound in two ways, " +
           std::to_string(health.nonmanifold_edges) + " of more than two facets";
  return health.volume > 0.0 ? "" : "it is inside out, its volume " + std::to_string(health.volume);
}
bool has_inside(const PartModel& model) { return why_no_inside(model).empty(); }

constexpr std::uintmax_t k_most_bytes = 700'000;

/// Those that are shipped, and shared ones that are not large where they are found; or all in the folder that
/// MOLDLIGHT_PARTS names.
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
    for (const auto& entry : fs::directory_iterator(*shared / "parts")) {
      if (entry.is_regular_file() && entry.path().extension() != ".tsv" && entry.file_size() <= k_most_bytes)
        parts.push_back(entry.path());
    }
  }
  std::ranges::sort(parts);
  return parts;
}

TEST(ActionsMotion, NeverEntersThePart) {
  const std::vector<fs::path> parts = real_parts();
  std::size_t actions = 0, bodies = 0, clear_bodies = 0, played_parts = 0, noted = 0, points = 0, astray = 0;
  for (const fs::path& path : parts) {
    const auto model = load_part(path.string(), {}, Progress());
    if (const std::string why = why_no_inside(*model); !why.empty()) {
      std::cout << path.filename().string() << " has no inside that could be entered: " << why << "\n";
      ++noted;
      continue;
    }
    ++played_parts;
    for (const glm::dvec3 direction : {glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0)}) {
      Query query;
      query.direction = direction;
      const Played played = play(*model, query);
      actions += played.actions;
      bodies += played.bodies;
      clear_bodies += played.clear_bodies;
      points += played.points;
      astray += played.astray;
      EXPECT_LE(static_cast<double>(played.body_inside), 0.01 * static_cast<double>(played.body_points) + 1.0)
          << path.filename() << " along " << direction.x << direction.z << ": " << played.body_inside
          << " of " << played.body_points << " points of bodies";
      // Of an undercut 0.5 % may stay blocked, and a sample is 1.7 % of one.
      EXPECT_LE(static_cast<double>(played.inside), 0.01 * static_cast<double>(played.points) + 1.0)
          << path.filename() << " along " << direction.x << direction.z << ": " << played.inside << " of "
          << played.points << played.noted;
    }
  }
  std::cout << actions << " actions and " << bodies << " bodies, " << clear_bodies << " of them clear, of "
            << played_parts << " of " << parts.size() << " parts played; " << astray << " of " << points
            << " points astray\n";
  EXPECT_EQ(played_parts + noted, parts.size());
  EXPECT_GT(actions, 10U);
  EXPECT_LT(static_cast<double>(astray), 0.1 * static_cast<double>(points));
}

/// What is said to get away along a pull, whether an action is made of it or not.
TEST(ActionsMotion, OfAFreePointNeverEntersThePart) {
  constexpr std::size_t k_patches = 4;
  constexpr double k_far = 0.6;  // of the diagonal
  std::size_t all = 0;
  for (const fs::path& path : real_parts()) {
    const auto model = load_part(path.string(), {}, Progress());
    if (!has_inside(*model)) continue;
    Query query;
    query.direction = glm::dvec3(1, 0, 0);
    const Classification result = classify_exact(*model, query, Progress(), true);
    const ExactQuery exact = exact_query(*model, query);
    const Release release(*model, exact);
    const Undercuts found = find_undercuts(*model, *result.split, exact, Progress());
    std::size_t points = 0, free = 0, inside = 0;
    for (std::size_t k = 0; k < std::min(k_patches, found.counted.size()); ++k) {
      for (const UndercutSample& sample : sample_undercut(*model, *result.split, found.counted[k], 40)) {
        if (release.is_covered(sample)) continue;  // by another body: nothing is said to free it
        ++points;
        bool once = false;
        for (int turn_deg = 0; turn_deg < 360; turn_deg += 15) {
          const glm::dvec3 pull = turned_about({0, 1, 0}, exact.direction, turn_deg + 0.3);
          if (std::isfinite(release.free_length(sample, pull))) continue;
          ++free;
          // What leans against the pull by less than the required draft glides along its own plane.
          const double lean = std::min(0.0, glm::dot(pull, sample.normal));
          const glm::dvec3 along = glm::normalize(pull - lean * sample.normal);
          const auto way = [&](double share) { return glm::dvec3(sample.position) + share * k_far * along; };
          once = once || enters(*model, exact, k_far, way);
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

/// Plans are found by few points of each body; what they have in the end was tried by all of them.
TEST(ActionsMotion, BodiesOfAPlanAreAsClearAsOnTheirOwn) {
  const auto model = load_part((test::asset_folder() / "parts/enclosure_lid.stl").string(), {}, Progress());
  std::size_t bodies = 0;
  for (const glm::dvec3& direction : {glm::dvec3(-0.262, 0.011, 0.965), glm::dvec3(0.315, 0.0, 0.949)}) {
    Query query;
    query.direction = glm::normalize(direction);
    const Classification result = classify_exact(*model, query, Progress(), true);
    const ActionPlan plan = find_actions(*model, result, {}, Progress());
    ActionPlan alone = plan;
    const Progress progress;
    BodyPlayer(*model, result, progress).measure(alone);
    for (std::size_t k = 0; k < plan.actions.size(); ++k) {
      const auto &its = plan.actions[k].body, &own = alone.actions[k].body;
      ASSERT_EQ(its.has_value(), own.has_value());
      if (!its) continue;
      ++bodies;
      EXPECT_EQ(its->hit.has_value(), own->hit.has_value())
          << facts(plan.actions[k].kind).name << " " << k + 1 << " along " << direction.x;
    }
  }
  EXPECT_GT(bodies, 10U);
}

}  // namespace
}  // namespace moldlight
