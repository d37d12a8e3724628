#include "mold/scan/wall_lookup.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "mold/measure.hpp"

namespace moldlight {

namespace {

/// How far outside of the wall the middle of the asked texels lies, in texels, where the lateral tolerance is
/// less.
constexpr float k_reach = 0.75F;
/// Facets whose heights at the texel's centre differ from the sample's by more than this many texels are
/// above or below it without a look at their planes.
constexpr float k_plane_margin = 6.0F;
/// Walls of less slope than this are as good as vertical: rounding of normals.
constexpr float k_upright = 1e-5F;
constexpr float k_plane_rounding = 2.5e-7F;  // as in shaders/common/region.glsl

}  // namespace

WallLookup::WallLookup(const ScanPart& part, const ScanMaps& maps, double lateral)
    : part_(part),
      maps_(maps),
      direction_(maps.frame().z),
      map_x_(maps.frame().x),
      map_y_(maps.frame().y),
      lateral_(static_cast<float>(lateral)),
      size_(static_cast<float>(maps.resolution())) {
  reach_ = std::max(k_reach, lateral_ * size_);
  height_margin_ = k_plane_margin / size_ * scan::k_height_scale;
}

WallLookup::Wall WallLookup::wall(FacetIndex facet) const {
  const glm::vec3 normal = part_.normal(facet);
  const glm::vec3 out = glm::normalize(normal - glm::dot(normal, direction_) * direction_);
  const float slope = glm::dot(normal, direction_);
  const float drop = std::abs(slope) > k_upright ? lateral_ * glm::dot(normal, out) / slope : 2.0F;
  return {out, glm::dot(out, map_x_), glm::dot(out, map_y_), drop};
}

bool WallLookup::outside_of(FacetIndex facet, const glm::vec3& point) const {
  const FacetPlane& plane = part_.planes()[facet];
  return plane.x * point.x + plane.y * point.y + plane.z * point.z - plane.offset > -k_plane_rounding;
}

WallLookup::Column WallLookup::column(int x, int y, const glm::vec3& point, float height) const {
  const std::int64_t plus = maps_.back(scan::k_down_layer, x, y), minus = maps_.back(scan::k_up_layer, x, y);
  const bool has_plus = maps_.is_present(plus), has_minus = maps_.is_present(minus);
  Column column;
  if (has_plus) {
    const float above = static_cast<float>(scan::height_of(plus, false)) - height;
    column.plus_blocked =
        std::abs(above) > height_margin_ ? above > 0.0F : outside_of(scan::facet_of(plus), point);
  }
  if (has_minus) {
    const float below = height - static_cast<float>(scan::height_of(minus, true));
    column.minus_blocked =
        std::abs(below) > height_margin_ ? below > 0.0F : outside_of(scan::facet_of(minus), point);
  }
  // Between the two maps' facets, which face away from each other, there is solid.
  column.is_solid = has_plus && has_minus && !column.plus_blocked && !column.minus_blocked;
  return column;
}

std::uint8_t WallLookup::ask(const Wall& wall, const glm::vec3& position) const {
  const float px = (glm::dot(position, map_x_) + 0.5F) * size_,
              py = (glm::dot(position, map_y_) + 0.5F) * size_;
  const glm::vec3 point = lateral_point(wall, position);
  const float level = glm::dot(point, direction_);
  if (std::abs(level - wall.drop) <= 0.5F) return verdict::k_doubtful;
  const float height = (level + 0.5F) * scan::k_height_scale + scan::k_height_margin;
  const int middle_x = static_cast<int>(std::floor(px + reach_ * wall.out_x)),
            middle_y = static_cast<int>(std::floor(py + reach_ * wall.out_y));
  const int last = maps_.resolution() - 1;
  int found = -1;
  for (int y = middle_y - 1; y <= middle_y + 1; ++y) {
    for (int x = middle_x - 1; x <= middle_x + 1; ++x) {
      const float outside =
          (static_cast<float>(x) + 0.5F - px) * wall.out_x + (static_cast<float>(y) + 0.5F - py) * wall.out_y;
      if (outside < 0.0F) continue;
      Column seen;
      if (x >= 0 && y >= 0 && x <= last && y <= last) seen = column(x, y, point, height);
      const int bits = (seen.plus_blocked ? 0 : verdict::k_accessible_plus) |
                       (seen.minus_blocked ? 0 : verdict::k_accessible_minus);
      if (seen.is_solid || (found >= 0 && found != bits)) return verdict::k_doubtful;
      found = bits;
    }
  }
  return found >= 0 ? static_cast<std::uint8_t>(found) : verdict::k_doubtful;
}

}  // namespace moldlight
