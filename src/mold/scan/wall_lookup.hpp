// Accessibility of near-vertical surface from maps of any texel size: the texels on the outer side of the
// wall must agree, else exact rays decide.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "mold/scan/scan_maps.hpp"

namespace moldlight {

/// The one-sided look-up of the classification asks one texel, which must not be larger than the lateral
/// tolerance. Here the texel may be several times larger: the centres of the three by three texels just
/// outside of the wall are asked at the height of the sample's lateral point, those behind the wall left out.
/// Where all see the same sides open, and none sees solid, that is the answer.
class WallLookup {
 public:
  /// `lateral`: the lateral tolerance in the unit frame. References must outlive it.
  WallLookup(const ScanPart& part, const ScanMaps& maps, double lateral);

  /// A near-vertical facet.
  struct Wall {
    glm::vec3 out{0.0F};         // unit vector out of it, perpendicular to the direction
    float out_x = 0, out_y = 0;  // the same in the maps
    float drop = 0;  // height of a lateral point above the facet's plane, negative below it; unit frame
  };
  [[nodiscard]] Wall wall(FacetIndex facet) const;

  /// Verdict bits (mold/measure.hpp) of a point of the wall; k_doubtful alone where the texels disagree, or
  /// where the wall, if it goes on so far, gets in its own way.
  [[nodiscard]] std::uint8_t ask(const Wall& wall, const glm::vec3& position) const;

  /// Where the exact rays of a point of the wall start.
  [[nodiscard]] glm::vec3 lateral_point(const Wall& wall, const glm::vec3& position) const {
    return position + lateral_ * wall.out;
  }

 private:
  struct Column {
    bool plus_blocked = false, minus_blocked = false, is_solid = false;
  };
  [[nodiscard]] Column column(int x, int y, const glm::vec3& point, float height) const;
  [[nodiscard]] bool outside_of(FacetIndex facet, const glm::vec3& point) const;

  const ScanPart& part_;
  const ScanMaps& maps_;
  glm::vec3 direction_, map_x_, map_y_;
  float lateral_, reach_, size_, height_margin_;
};

}  // namespace moldlight
