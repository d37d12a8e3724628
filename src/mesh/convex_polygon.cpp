#include "mesh/convex_polygon.hpp"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace moldlight {

namespace {

/// Squared distance of two segments (Ericson, Real-Time Collision Detection, 2005, section 5.1.9).
double squared_distance(const glm::dvec3& p, const glm::dvec3& p_end, const glm::dvec3& q,
                        const glm::dvec3& q_end) {
  const glm::dvec3 along_p = p_end - p, along_q = q_end - q, apart = p - q;
  const double a = glm::dot(along_p, along_p), e = glm::dot(along_q, along_q), f = glm::dot(along_q, apart);
  if (a <= 0.0 && e <= 0.0) return glm::dot(apart, apart);
  const double c = glm::dot(along_p, apart), b = glm::dot(along_p, along_q);
  double s = 0.0, t = 0.0;
  if (a <= 0.0) {
    t = glm::clamp(f / e, 0.0, 1.0);
  } else if (e <= 0.0) {
    s = glm::clamp(-c / a, 0.0, 1.0);
  } else {
    const double denominator = a * e - b * b;
    s = denominator > 0.0 ? glm::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
    t = (b * s + f) / e;
    if (t < 0.0 || t > 1.0) {
      t = glm::clamp(t, 0.0, 1.0);
      s = glm::clamp((b * t - c) / a, 0.0, 1.0);
    }
  }
  const glm::dvec3 between = p + s * along_p - q - t * along_q;
  return glm::dot(between, between);
}

}  // namespace

double beyond(const glm::dvec3& point, const HalfSpace& half) {
  return glm::dot(half.normal, point) - half.offset;
}

PartedPolygon parted(const ConvexPolygon& polygon, const HalfSpace& half, double rounding) {
  PartedPolygon parts;
  parts.inside.reserve(polygon.size() + 1);
  parts.outside.reserve(polygon.size() + 1);
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double over_a = beyond(a, half), over_b = beyond(b, half);
    if (over_a <= rounding) parts.inside.push_back(a);
    if (over_a >= -rounding) parts.outside.push_back(a);
    if ((over_a < -rounding && over_b > rounding) || (over_a > rounding && over_b < -rounding)) {
      const glm::dvec3 at = glm::mix(a, b, over_a / (over_a - over_b));
      parts.inside.push_back(at);
      parts.outside.push_back(at);
    }
  }
  return parts;
}

double polygon_area(const ConvexPolygon& polygon) {
  glm::dvec3 twice(0.0);
  for (std::size_t k = 2; k < polygon.size(); ++k)
    twice += glm::cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
  return 0.5 * glm::length(twice);
}

glm::dvec3 polygon_centre(const ConvexPolygon& polygon) {
  glm::dvec3 sum(0.0), of_corners(0.0);
  double weights = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    of_corners += polygon[k];
    if (k < 2) continue;
    const double weight = glm::length(glm::cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]));
    weights += weight;
    sum += weight * (polygon[0] + polygon[k - 1] + polygon[k]) / 3.0;
  }
  if (weights > 0.0) return sum / weights;
  return polygon.empty() ? of_corners : of_corners / static_cast<double>(polygon.size());
}

double reach_from(const glm::dvec3& point, const ConvexPolygon& polygon) {
  double most = 0.0;
  for (const glm::dvec3& corner : polygon) most = std::max(most, glm::distance(corner, point));
  return most;
}

double distance_to_segment(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 along = b - a, way = point - a;
  const double square = glm::dot(along, along);
  const double share = square > 0.0 ? glm::clamp(glm::dot(way, along) / square, 0.0, 1.0) : 0.0;
  return glm::length(way - share * along);
}

TriangleHull hull_around(const std::array<glm::dvec3, 3>& corners, const glm::dvec3& normal,
                         const Nearness& nearness) {
  TriangleHull hull;
  std::array<glm::dvec3, 3> outward;
  for (std::size_t k = 0; k < 3; ++k) {
    outward[k] = glm::normalize(glm::cross(corners[(k + 1) % 3] - corners[k], normal));
    hull[k] = {outward[k], glm::dot(outward[k], corners[k]) + nearness.lateral};
  }
  // Beyond a sharp corner the planes of its edges meet far away.
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 sum = outward[k] + outward[(k + 2) % 3];
    const double length = glm::length(sum);
    const glm::dvec3 bisector = length > 0.0 ? sum / length : outward[k];
    hull[3 + k] = {bisector, glm::dot(bisector, corners[k]) + nearness.lateral};
  }
  hull[6] = {normal, glm::dot(normal, corners[0]) + nearness.normal};
  hull[7] = {-normal, -glm::dot(normal, corners[0]) + nearness.normal};
  return hull;
}

HullSide side_of(const ConvexPolygon& polygon, const TriangleHull& hull, double rounding) {
  bool inside = true;
  for (const HalfSpace& half : hull) {
    bool all_beyond = true;
    for (const glm::dvec3& corner : polygon) {
      const double over = beyond(corner, half);
      all_beyond = all_beyond && over > -rounding;
      inside = inside && over <= rounding;
    }
    if (all_beyond && !inside) return HullSide::outside;
  }
  return inside ? HullSide::inside : HullSide::across;
}

ConvexPolygon cut_by(const ConvexPolygon& polygon, const TriangleHull& hull, double rounding,
                     std::vector<ConvexPolygon>& outside) {
  ConvexPolygon inside = polygon;
  const std::size_t before = outside.size();
  for (const HalfSpace& half : hull) {
    // What is left is within most planes; only the first finds a polygon without area.
    const auto within = [&](const glm::dvec3& corner) { return beyond(corner, half) < -rounding; };
    if (&half != hull.data() && std::ranges::all_of(inside, within)) continue;
    PartedPolygon parts = parted(inside, half, rounding);
    if (parts.inside.size() < 3 || polygon_area(parts.inside) <= rounding * rounding) {
      outside.resize(before);
      outside.push_back(polygon);
      return {};
    }
    inside = std::move(parts.inside);
    if (parts.outside.size() >= 3 && polygon_area(parts.outside) > rounding * rounding)
      outside.push_back(std::move(parts.outside));
  }
  return inside;
}

bool rims_touch(const ConvexPolygon& a, const ConvexPolygon& b, double reach) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) {
      if (squared_distance(a[i], a[(i + 1) % a.size()], b[k], b[(k + 1) % b.size()]) <= reach * reach)
        return true;
    }
  }
  return false;
}

}  // namespace moldlight
