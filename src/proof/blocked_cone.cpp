#include "proof/blocked_cone.hpp"

#include <array>

#include <glm/geometric.hpp>

namespace moldlight {

namespace {

/// How far a facet's plane must be from all starting points, in the unit frame.
constexpr double k_clear_of_plane = 1e-9;
constexpr std::size_t k_largest_sheet = 300;
constexpr int k_most_tries = 4;
constexpr float k_past_hit = 1e-6F;

}  // namespace

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
