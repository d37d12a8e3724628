#include "mold/round_wall.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <unordered_set>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mold/direction.hpp"

namespace moldlight {

namespace {

constexpr double k_flat_deg = 0.5,
                 k_strip_deg = 37.5;    // bends within a strip of the wall, and between strips: no chamfer's
constexpr double k_off_axis_deg = 2.0;  // by which a normal's angle to the axis may differ
constexpr double k_least_turn_deg = 60.0;
constexpr std::size_t k_least_strips = 4;  // any three normals end on a circle: a chamfered edge is no wall
constexpr double k_one_wall_deg = 10.0;    // between the axis of a wall and that of most of it
constexpr double k_wide_deg = 20.0;        // a bend at which another surface may begin
constexpr std::size_t k_most_facets = 20'000;  // walls of more are judged by this part of them
constexpr std::size_t k_most_guesses = 8;

double bend_deg(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

struct Wall {
  glm::dvec3 axis{0.0};  // unit
  double area = 0.0;
  double turn_deg = 0.0;
  std::size_t strips = 1;  // that face different ways
  bool one = true;         // what lies on either side of its widest bend has the same axis
};

/// A normal of the wall, and where it points about the axis.
struct Spoke {
  double angle_deg = 0.0;
  glm::dvec3 normal{0.0};
};

/// How many ways they face; by their angle. Facets of one strip of a cone face ways that differ a little.
std::size_t strips_of(std::span<const Spoke> spokes) {
  std::size_t strips = 0;
  double last_deg = -360.0;
  for (const Spoke& spoke : spokes) {
    if (spoke.angle_deg - last_deg <= k_off_axis_deg) continue;
    ++strips;
    last_deg = spoke.angle_deg;
  }
  return strips;
}

/// Spreads from `start` over edges; accept(facet, next) says whether to go on to a facet not reached yet.
template <typename Accept>
void grow(const Adjacency& adjacency, FacetIndex start, Accept&& accept) {
  std::unordered_set<FacetIndex> seen = {start};
  std::vector<FacetIndex> front = {start};
  while (!front.empty() && seen.size() < k_most_facets) {
    const FacetIndex facet = front.back();
    front.pop_back();
    for (const FacetIndex next : adjacency.across[facet]) {
      if (next == k_no_facet || seen.contains(next) || !accept(facet, next)) continue;
      seen.insert(next);
      front.push_back(next);
    }
  }
}

/// Normals of a cylinder or a cone end on a circle about its axis, so that it is the area vector of the
/// polygon that they span.
glm::dvec3 area_vector(std::span<const Spoke> spokes) {
  glm::dvec3 area = glm::cross(spokes.back().normal, spokes.front().normal);
  for (std::size_t k = 1; k < spokes.size(); ++k) area += glm::cross(spokes[k - 1].normal, spokes[k].normal);
  return area;
}

/// Some circle goes through the normals of a cone and of a plane that it begins in, too. The spokes by their
/// angle.
bool is_one_wall(std::span<const Spoke> spokes, const glm::dvec3& axis) {
  std::size_t widest = 0;
  double step_deg = k_wide_deg;
  for (std::size_t k = 1; k < spokes.size(); ++k) {
    if (const double step = spokes[k].angle_deg - spokes[k - 1].angle_deg; step > step_deg)
      step_deg = step, widest = k;
  }
  const std::array sides = {spokes.first(widest), spokes.subspan(widest)};
  return std::ranges::all_of(sides, [&](std::span<const Spoke> side) {
    const glm::dvec3 area = side.empty() ? glm::dvec3(0.0) : area_vector(side);
    return strips_of(side) < k_least_strips ||
           std::abs(glm::dot(area, axis)) >= std::cos(glm::radians(k_one_wall_deg)) * glm::length(area);
  });
}

/// The facets around `start` whose normals have the same angle to a guess at the axis, and their axis.
Wall wall_about(const FacetGeometry& geometry, const Adjacency& adjacency, FacetIndex start,
                const glm::dvec3& guess) {
  const glm::dvec3& normal = geometry.normals[start];
  const double height = glm::dot(normal, guess);
  const double tolerance = std::sin(glm::radians(k_off_axis_deg));
  const glm::dvec3 zero = glm::normalize(normal - height * guess), quarter = glm::cross(guess, zero);
  Wall wall{.area = geometry.areas[start]};
  std::vector<Spoke> spokes = {{0.0, normal}};
  grow(adjacency, start, [&](FacetIndex facet, FacetIndex next) {
    const glm::dvec3& b = geometry.normals[next];
    if (geometry.areas[next] <= 0.0 || std::abs(glm::dot(b, guess) - height) > tolerance ||
        bend_deg(geometry.normals[facet], b) > k_strip_deg)
      return false;
    wall.area += geometry.areas[next];
    spokes.push_back({glm::degrees(std::atan2(glm::dot(b, quarter), glm::dot(b, zero))), b});
    return true;
  });
  // The turn is a full one less the widest gap between neighbouring normals.
  std::ranges::sort(spokes, {}, &Spoke::angle_deg);
  const glm::dvec3 area = area_vector(spokes);
  double gap = 360.0 - (spokes.back().angle_deg - spokes.front().angle_deg);
  for (std::size_t k = 1; k < spokes.size(); ++k)
    gap = std::max(gap, spokes[k].angle_deg - spokes[k - 1].angle_deg);
  wall.strips = strips_of(spokes);
  wall.turn_deg = 360.0 - gap;
  wall.axis = glm::length(area) > 0.0 ? glm::normalize(area) : guess;
  wall.one = is_one_wall(spokes, wall.axis);
  return wall;
}

}  // namespace

std::optional<RoundWall> round_wall(const FacetGeometry& geometry, const Adjacency& adjacency,
                                    FacetIndex facet) {
  if (geometry.areas[facet] <= 0.0) return std::nullopt;
  const glm::dvec3& normal = geometry.normals[facet];
  std::vector<glm::dvec3> guesses, beside;
  const auto guess = [&](const glm::dvec3& along) {
    if (glm::length(along) <= 0.0 || guesses.size() == k_most_guesses) return;
    const glm::dvec3 axis = glm::normalize(along);
    const bool known = std::ranges::any_of(guesses, [&](const glm::dvec3& other) {
      return std::abs(glm::dot(other, axis)) > std::cos(glm::radians(k_off_axis_deg));
    });
    if (!known) guesses.push_back(axis);
  };
  grow(adjacency, facet, [&](FacetIndex from, FacetIndex next) {
    if (geometry.areas[next] <= 0.0) return false;
    const double bend = bend_deg(geometry.normals[from], geometry.normals[next]);
    if (bend <= k_flat_deg) return true;
    if (bend > k_strip_deg) return false;
    const glm::dvec3& other = geometry.normals[next];
    // Two normals know the axis of a cylinder, three that of a cone.
    for (const glm::dvec3& third : beside) guess(glm::cross(normal - third, other - normal));
    guess(glm::cross(normal, other));
    if (beside.size() < k_most_guesses) beside.push_back(other);
    return false;
  });
  Wall best;
  for (const glm::dvec3& axis : guesses) {
    // The second time about the axis that the first time has found.
    const Wall rough = wall_about(geometry, adjacency, facet, axis);
    const Wall wall = wall_about(geometry, adjacency, facet, rough.axis);
    if (wall.one && wall.turn_deg >= k_least_turn_deg && wall.strips >= k_least_strips &&
        wall.area > best.area)
      best = wall;
  }
  if (best.area <= 0.0) return std::nullopt;
  return RoundWall{half_sphere(best.axis), best.area};
}

}  // namespace moldlight
