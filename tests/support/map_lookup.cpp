#include "support/map_lookup.hpp"

#include <cmath>

#include <glm/geometric.hpp>

#include "mold/measure.hpp"

namespace moldlight::test {

namespace {
/// As in the shader: rounding of n.p - c at coordinates up to 0.5 in single precision.
constexpr float k_plane_rounding = 2.5e-7F;
}  // namespace

MapLookup::MapLookup(const ScanPart& part, const ScanMaps& maps, double lateral)
    : part_(part),
      maps_(maps),
      direction_(maps.frame().z),
      map_x_(maps.frame().x),
      map_y_(maps.frame().y),
      lateral_(static_cast<float>(lateral)),
      size_(static_cast<float>(maps.resolution())) {}

MapLookup::Place MapLookup::place_of(const glm::vec3& point, FacetIndex facet) const {
  Place place{point, 0, 0, maps_.facet_class(facet)};
  if (place.facet_class == FacetClass::near_vertical) {
    const glm::vec3 normal = part_.normal(facet);
    place.point += lateral_ * glm::normalize(normal - glm::dot(normal, direction_) * direction_);
  }
  place.x = static_cast<int>(std::floor((glm::dot(place.point, map_x_) + 0.5F) * size_));
  place.y = static_cast<int>(std::floor((glm::dot(place.point, map_y_) + 0.5F) * size_));
  return place;
}

std::uint32_t MapLookup::entry(bool plus, int x, int y) const {
  const int size = maps_.resolution();
  return x >= 0 && y >= 0 && x < size && y < size ? maps_.entry(plus, x, y) : 0;
}

bool MapLookup::outside_of(std::uint32_t entry, const glm::vec3& point) const {
  if (entry == 0) return false;
  const FacetPlane& plane = part_.planes()[entry - 1];
  return plane.x * point.x + plane.y * point.y + plane.z * point.z - plane.offset > -k_plane_rounding;
}

std::uint8_t MapLookup::accessible_at(const Place& place, int x, int y) const {
  switch (place.facet_class) {
    case FacetClass::up:
      return outside_of(entry(true, x, y), place.point) ? 0 : verdict::k_accessible_plus;
    case FacetClass::down:
      return outside_of(entry(false, x, y), place.point) ? 0 : verdict::k_accessible_minus;
    case FacetClass::near_vertical:
      break;
  }
  const std::uint32_t plus = entry(true, x, y), minus = entry(false, x, y);
  const bool blocked_plus = outside_of(plus, place.point), blocked_minus = outside_of(minus, place.point);
  // Between the two maps' facets, which face away from each other, there is solid: the look-up fell into a
  // ledge.
  if (plus != 0 && minus != 0 && !blocked_plus && !blocked_minus) return 0;
  return static_cast<std::uint8_t>((blocked_plus ? 0 : verdict::k_accessible_plus) |
                                   (blocked_minus ? 0 : verdict::k_accessible_minus));
}

std::uint8_t MapLookup::accessible_from(const glm::vec3& point, FacetIndex facet) const {
  const Place place = place_of(point, facet);
  return accessible_at(place, place.x, place.y);
}

std::uint8_t MapLookup::verdict(const glm::vec3& point, FacetIndex facet) const {
  const Place place = place_of(point, facet);
  const std::uint8_t bits = accessible_at(place, place.x, place.y);
  bool others = false, undercut_in_doubt = false;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const std::uint8_t beside = accessible_at(place, place.x + dx, place.y + dy);
      others = others || beside != bits;
      undercut_in_doubt = undercut_in_doubt || (beside == 0) != (bits == 0);
    }
  }
  return static_cast<std::uint8_t>(bits | (others ? verdict::k_doubtful : 0) |
                                   (undercut_in_doubt ? verdict::k_undercut_in_doubt : 0));
}

}  // namespace moldlight::test
