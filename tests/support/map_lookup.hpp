// Looks surface points up in the scan-converted maps: the twin of the one-sided look-up in
// shaders/common/region.glsl, to compare the two by.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "mold/scan/scan_maps.hpp"

namespace moldlight::test {

/// References must outlive it; valid until the maps are drawn again.
class MapLookup {
 public:
  /// `lateral`: the lateral tolerance in the unit frame.
  MapLookup(const ScanPart& part, const ScanMaps& maps, double lateral);

  /// Verdict bits (mold/measure.hpp) of a surface point in the unit frame, without doubt.
  [[nodiscard]] std::uint8_t accessible_from(const glm::vec3& point, FacetIndex facet) const;

  /// The same, with doubt where one of the eight texels around says otherwise.
  [[nodiscard]] std::uint8_t verdict(const glm::vec3& point, FacetIndex facet) const;

 private:
  struct Place {
    glm::vec3 point;  // where planes are evaluated
    int x, y;         // its texel
    FacetClass facet_class;
  };
  [[nodiscard]] Place place_of(const glm::vec3& point, FacetIndex facet) const;
  [[nodiscard]] std::uint8_t accessible_at(const Place& place, int x, int y) const;
  [[nodiscard]] std::uint32_t entry(bool plus, int x, int y) const;
  [[nodiscard]] bool outside_of(std::uint32_t entry, const glm::vec3& point) const;

  const ScanPart& part_;
  const ScanMaps& maps_;
  glm::vec3 direction_, map_x_, map_y_;
  float lateral_, size_;
};

}  // namespace moldlight::test
