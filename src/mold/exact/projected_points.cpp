// What stands in front of a point of a projected part.
#include <cmath>
#include <optional>

#include "mold/exact/projected_part.hpp"

namespace moldlight {

namespace {

/// Distances of a facet from a point, in the unit frame, up to which they touch.
constexpr double k_edge_touch = 1e-12;
/// Surface nearer than this lies on a facet: more than the rounding of a cut.
constexpr double k_same_surface = 1e-11;
/// Twice the area of a facet whose height over a point is known to k_plane_margin.
constexpr double k_clear_area = 2e-10;

}  // namespace

bool ProjectedPart::blocked(const Ray& ray, FacetIndex& last) const {
  const std::uint8_t facings = blockers(ray.sense, ray.beside);
  const glm::vec3 at(ray.point);
  const FacetIndex own = ray.own == k_no_facet ? k_no_facet : part_->first_equal(ray.own);
  const auto hides = [&](FacetIndex facet) {
    const Extent& extent = extents_[facet];
    return (ray.sense > 0 ? extent.high.z >= at.z : extent.low.z <= at.z) && at.x >= extent.low.x &&
           at.x <= extent.high.x && at.y >= extent.low.y && at.y <= extent.high.y && facet != own &&
           blocks(facet, ray);
  };
  if (last != k_no_facet && (extents_[last].facing & facings) != 0 && hides(last)) return true;
  for (const std::uint8_t facing : {facing::k_up, facing::k_down}) {
    if ((facings & facing) == 0) continue;
    for (const FacetIndex item :
         facet_grids_[facing == facing::k_up ? 0 : 1].items_at(glm::dvec2(ray.point))) {
      if (!hides(item)) continue;
      last = item;
      return true;
    }
  }
  return false;
}

std::optional<double> ProjectedPart::rise_over(const glm::dvec3& point, FacetIndex facet) const {
  const auto& corners = part_->mesh().facets[facet];
  const std::array<const glm::dvec3*, 3> at = {&points_[corners[0]], &points_[corners[1]],
                                               &points_[corners[2]]};
  // Twice the areas that the point spans with the sides, seen along the direction. Each side is taken from
  // its lower vertex to its higher one, so that two facets agree about their common side.
  const double turn = extents_[facet].facing == facing::k_up ? 1.0 : -1.0;
  std::array<double, 3> spans{};
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t from = k, to = (k + 1) % 3;
    const bool swapped = corners[from] > corners[to];
    if (swapped) std::swap(from, to);
    const glm::dvec3& a = *at[from];
    const glm::dvec3& b = *at[to];
    const double span = (b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x);
    spans[(k + 2) % 3] = swapped ? -span : span;
    if (spans[(k + 2) % 3] * turn < 0.0) return std::nullopt;
  }
  const double rise =
      spans[0] * (at[0]->z - point.z) + spans[1] * (at[1]->z - point.z) + spans[2] * (at[2]->z - point.z);
  return rise * turn;
}

bool ProjectedPart::blocks(FacetIndex facet, const Ray& ray) const {
  const std::optional<double> rise = rise_over(ray.point, facet);
  if (!rise) return false;
  const double twice_area = twice_area_of(facet);
  // Where the blockers face the ray, one that touches the point hides it; else it may be the same surface
  // twice.
  const double distance = ray.clearly ? k_plane_margin : part_->closed() ? k_edge_touch : -k_edge_touch;
  return *rise * ray.sense > distance * twice_area && (!ray.clearly || twice_area >= k_clear_area);
}

int ProjectedPart::winding_in_front(const glm::dvec3& point, FacetIndex own) const {
  const std::uint8_t facing = extents_[own].facing;
  const double sense = facing == facing::k_up ? 1.0 : -1.0;
  int winding = 0;
  for (const std::uint8_t side : {facing::k_up, facing::k_down}) {
    for (const FacetIndex facet : facet_grids_[side == facing::k_up ? 0 : 1].items_at(glm::dvec2(point))) {
      const std::optional<double> rise = facet == own ? std::nullopt : rise_over(point, facet);
      if (!rise) continue;
      // What is left through a facet that faces the same way was inside.
      const bool coincides = std::abs(*rise) <= k_same_surface * twice_area_of(facet);
      const bool in_front = coincides ? side == facing && facet < own : *rise * sense > 0.0;
      const auto copies = static_cast<int>(part_->copies(facet));
      if (in_front) winding += side == facing ? copies : -copies;
    }
  }
  return winding;
}

}  // namespace moldlight
