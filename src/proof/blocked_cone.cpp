#include "proof/blocked_cone.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <glm/geometric.hpp>

#include "base/check.hpp"

namespace moldlight {

namespace {

/// By which the region is made larger, in the unit frame: far above the rounding of double.
constexpr double k_margin = 1e-9;
/// Sine of an angle below which a plane through an edge and a direction is not known well enough.
constexpr double k_least_sine = 1e-6;
constexpr double k_along = 1e-13;

/// How far a facet's plane must be from all starting points, in the unit frame.
constexpr double k_clear_of_plane = 1e-9;
constexpr std::size_t k_largest_sheet = 300;
constexpr int k_most_tries = 4;
constexpr float k_past_hit = 1e-6F;

}  // namespace

SweptRegion::SweptRegion(const RayBundle& bundle) {
  CHECK(bundle.directions.size() >= 3 && bundle.directions.size() <= 8);
  for (std::size_t k = 0; k < bundle.directions.size(); ++k) {
    const glm::dvec3 normal =
        glm::cross(bundle.directions[k], bundle.directions[(k + 1) % bundle.directions.size()]);
    const double sine = glm::length(normal);
    if (sine > k_least_sine) add(bundle, normal / sine);
  }
  add(bundle, bundle.centre);
  if (bundle.points.size() == 3) add_edge_planes(bundle);
}

/// The sides of a swept triangle: the planes through one of its edges along a direction that leave all other
/// directions and the third corner on one side. The triangle's own plane is among them where all directions
/// leave it to one side.
void SweptRegion::add_edge_planes(const RayBundle& bundle) {
  const auto& points = bundle.points;
  const auto add_if_outer = [&](glm::dvec3 normal) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const glm::dvec3& direction : bundle.directions) {
      const double cosine = glm::dot(normal, direction);
      least = std::min(least, cosine);
      most = std::max(most, cosine);
    }
    if (least < -k_along && most > k_along) return;
    if (count_ < half_spaces_.size()) add(bundle, least < -k_along ? -normal : normal);
  };
  const glm::dvec3 across = glm::cross(points[1] - points[0], points[2] - points[0]);
  if (glm::length(across) <= 0.0) return;
  add_if_outer(glm::normalize(across));
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 along = points[(k + 1) % 3] - points[k];
    const double length = glm::length(along);
    for (const glm::dvec3& direction : bundle.directions) {
      const glm::dvec3 normal = glm::cross(along, direction);
      const double sine = glm::length(normal);
      if (sine > k_least_sine * length) add_if_outer(normal / sine);
    }
  }
}

/// Any half-space that holds all directions is one of the region's, if it begins at the first of the points.
void SweptRegion::add(const RayBundle& bundle, const glm::dvec3& normal) {
  double first = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& point : bundle.points) first = std::min(first, glm::dot(normal, point));
  half_spaces_[count_++] = {normal, first - bundle.radius - k_margin};
}

bool SweptRegion::meets(const glm::dvec3& a, const glm::dvec3& b) const {
  double begin = 0.0, end = 1.0;
  for (std::size_t k = 0; k < count_; ++k) {
    const double from = glm::dot(half_spaces_[k].normal, a) - half_spaces_[k].offset;
    const double to = glm::dot(half_spaces_[k].normal, b) - half_spaces_[k].offset;
    if (from < 0.0 && to < 0.0) return false;
    if (from < 0.0) begin = std::max(begin, from / (from - to));
    if (to < 0.0) end = std::min(end, from / (from - to));
    if (begin > end) return false;
  }
  return true;
}

bool BlockedCone::faces(FacetIndex facet, const RayBundle& bundle) const {
  const glm::dvec3& normal = part_.geometry.normals[facet];
  const double plane = glm::dot(normal, part_.positions[part_.mesh.facets[facet][0]]);
  for (const glm::dvec3& point : bundle.points) {
    if (glm::dot(normal, point) - plane <= bundle.radius + k_clear_of_plane) return false;
  }
  return true;
}

/// The ray caster's single precision may meet the neighbour of what it names.
bool BlockedCone::truly_hit(FacetIndex facet, const glm::dvec3& origin, const glm::dvec3& direction) const {
  const auto& vertices = part_.mesh.facets[facet];
  std::array<glm::dvec3, 3> to;
  for (std::size_t k = 0; k < 3; ++k) to[k] = part_.positions[vertices[k]] - origin;
  for (std::size_t k = 0; k < 3; ++k) {
    // Seen from the front corners run counter-clockwise, so against the ray they turn to the right.
    if (glm::dot(glm::cross(to[k], to[(k + 1) % 3]), direction) >= 0.0) return false;
  }
  return true;
}

bool BlockedCone::covered_from(FacetIndex first, const RayBundle& bundle, const SweptRegion& region) {
  ++round_;
  sheet_.assign(1, first);
  met_[first] = round_;
  for (std::size_t next = 0; next < sheet_.size(); ++next) {
    const auto& vertices = part_.mesh.facets[sheet_[next]];
    const auto& across = part_.adjacency.across[sheet_[next]];
    for (std::size_t side = 0; side < 3; ++side) {
      const FacetIndex other = across[side];
      if (other != k_no_facet && met_[other] == round_) continue;
      if (!region.meets(part_.positions[vertices[side]], part_.positions[vertices[(side + 1) % 3]])) continue;
      if (other == k_no_facet || sheet_.size() == k_largest_sheet || !faces(other, bundle)) return false;
      met_[other] = round_;
      sheet_.push_back(other);
    }
  }
  return true;
}

ConeAnswer BlockedCone::ask(const RayBundle& bundle) {
  ConeAnswer answer;
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& point : bundle.points) middle += point / static_cast<double>(bundle.points.size());
  const glm::vec3 direction(bundle.centre);
  glm::vec3 origin(middle);
  std::optional<SweptRegion> region;
  double travelled = 0.0;
  for (int tried = 0; tried < k_most_tries; ++tried) {
    const auto hit = part_.rays.first_hit(origin, direction, true);
    if (!hit) return answer;
    travelled += hit->distance;
    if (!answer.hit) answer = {.blocked = false, .hit = true, .distance = travelled};
    if (faces(hit->facet, bundle) && truly_hit(hit->facet, middle, bundle.centre)) {
      if (!region) region.emplace(bundle);
      answer.blocked = covered_from(hit->facet, bundle, *region);
      if (answer.blocked) return answer;
    }
    origin += (hit->distance + k_past_hit) * direction;
    travelled += k_past_hit;
  }
  return answer;
}

}  // namespace moldlight
