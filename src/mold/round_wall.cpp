#include "mold/round_wall.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mold/direction.hpp"

namespace moldlight {

namespace {

constexpr double k_flat_deg = 0.5,
                 k_strip_deg = 45.0;    // bends within a strip of the wall, and between strips
constexpr double k_off_axis_deg = 2.0;  // by which a normal's angle to the axis may differ
constexpr double k_least_turn_deg = 60.0;
constexpr std::size_t k_most_facets = 20'000;  // walls of more are judged by this part of them
constexpr std::size_t k_most_guesses = 8;

double bend_deg(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

struct Wall {
  glm::dvec3 turning{0.0};  // sum of the normals' cross products over its bent edges: along the axis
  double area = 0.0;
  double turn_deg = 0.0;
};

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

Wall wall_about(const FacetGeometry& geometry, const Adjacency& adjacency, FacetIndex start,
                const glm::dvec3& axis) {
  const glm::dvec3& normal = geometry.normals[start];
  const double height = glm::dot(normal, axis);
  const double tolerance = std::sin(glm::radians(k_off_axis_deg));
  const glm::dvec3 zero = glm::normalize(normal - height * axis), quarter = glm::cross(axis, zero);
  Wall wall{.turning = glm::dvec3(0.0), .area = geometry.areas[start], .turn_deg = 0.0};
  std::vector<double> angles = {0.0};
  grow(adjacency, start, [&](FacetIndex facet, FacetIndex next) {
    const glm::dvec3 &a = geometry.normals[facet], &b = geometry.normals[next];
    if (geometry.areas[next] <= 0.0 || std::abs(glm::dot(b, axis) - height) > tolerance ||
        bend_deg(a, b) > k_strip_deg)
      return false;
    glm::dvec3 cross = glm::cross(a, b);
    if (glm::dot(cross, axis) < 0.0) cross = -cross;
    wall.turning += cross;
    wall.area += geometry.areas[next];
    angles.push_back(glm::degrees(std::atan2(glm::dot(b, quarter), glm::dot(b, zero))));
    return true;
  });
  // The turn is a full one less the widest gap between neighbouring normals.
  std::sort(angles.begin(), angles.end());
  double gap = 360.0 - (angles.back() - angles.front());
  for (std::size_t k = 1; k < angles.size(); ++k) gap = std::max(gap, angles[k] - angles[k - 1]);
  wall.turn_deg = 360.0 - gap;
  return wall;
}

}  // namespace

std::optional<glm::dvec3> round_wall_axis(const FacetGeometry& geometry, const Adjacency& adjacency,
                                          FacetIndex facet) {
  if (geometry.areas[facet] <= 0.0) return std::nullopt;
  const glm::dvec3& normal = geometry.normals[facet];
  std::vector<glm::dvec3> guesses;
  grow(adjacency, facet, [&](FacetIndex from, FacetIndex next) {
    if (geometry.areas[next] <= 0.0) return false;
    const double bend = bend_deg(geometry.normals[from], geometry.normals[next]);
    if (bend <= k_flat_deg) return true;
    if (bend > k_strip_deg) return false;
    const glm::dvec3 axis = glm::normalize(glm::cross(normal, geometry.normals[next]));
    const bool known = std::any_of(guesses.begin(), guesses.end(), [&](const glm::dvec3& guess) {
      return std::abs(glm::dot(guess, axis)) > std::cos(glm::radians(k_off_axis_deg));
    });
    if (!known && guesses.size() < k_most_guesses) guesses.push_back(axis);
    return false;
  });
  Wall best;
  for (const glm::dvec3& guess : guesses) {
    const Wall wall = wall_about(geometry, adjacency, facet, guess);
    if (wall.turn_deg >= k_least_turn_deg && wall.area > best.area) best = wall;
  }
  if (best.area <= 0.0) return std::nullopt;
  return half_sphere(glm::normalize(best.turning));
}

}  // namespace moldlight
