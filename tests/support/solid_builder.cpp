#include "support/solid_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/check.hpp"
#include "mesh/health.hpp"
#include "mesh/weld.hpp"

namespace moldlight::test {
namespace {

/// A corner of a planar face: where it is and where that is in the face's plane.
struct Corner {
  glm::dvec3 point;
  glm::dvec2 flat;
};
using FlatLoop = std::vector<Corner>;

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double signed_area(const FlatLoop& loop) {
  double twice = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const glm::dvec2 &a = loop[i].flat, &b = loop[(i + 1) % loop.size()].flat;
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

glm::dvec3 loop_normal(const Loop& loop) {
  glm::dvec3 normal(0.0);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    normal += glm::cross(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]);
  }
  return glm::normalize(normal);
}

FlatLoop flattened(const Loop& loop, const glm::dvec3& origin, const glm::dvec3& u, const glm::dvec3& v) {
  FlatLoop flat;
  for (const glm::dvec3& point : loop) {
    flat.push_back({point, glm::dvec2(glm::dot(point - origin, u), glm::dot(point - origin, v))});
  }
  return flat;
}

bool segments_touch(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  return turn(a, b, c) * turn(a, b, d) <= 0.0 && turn(c, d, a) * turn(c, d, b) <= 0.0;
}

/// The segment from `a` to `b` meets no edge of the loop but those that end in `a` or `b`.
bool is_clear(const FlatLoop& loop, const glm::dvec2& a, const glm::dvec2& b) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const glm::dvec2 &c = loop[i].flat, &d = loop[(i + 1) % loop.size()].flat;
    if (c == a || c == b || d == a || d == b) continue;
    if (segments_touch(a, b, c, d)) return false;
  }
  return true;
}

/// Joins a hole to the loop by the shortest clear bridge, run through in both senses.
void bridge(FlatLoop& loop, FlatLoop hole, const std::vector<FlatLoop>& all_holes) {
  std::size_t best_i = loop.size(), best_j = 0;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    for (std::size_t j = 0; j < hole.size(); ++j) {
      const glm::dvec2 &a = loop[i].flat, &b = hole[j].flat;
      const double length = glm::distance(a, b);
      if (length >= best || !is_clear(loop, a, b)) continue;
      if (!std::all_of(all_holes.begin(), all_holes.end(),
                       [&](const FlatLoop& h) { return is_clear(h, a, b); }))
        continue;
      best = length;
      best_i = i;
      best_j = j;
    }
  }
  CHECK(best_i < loop.size());
  std::rotate(hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(best_j), hole.end());
  hole.push_back(hole.front());
  hole.push_back(loop[best_i]);
  loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(best_i) + 1, hole.begin(), hole.end());
}

/// Least height of the triangle relative to its longest side: 0 for a needle; negative for a reflex corner.
double ear_quality(const FlatLoop& loop, std::size_t tip) {
  const std::size_t n = loop.size();
  const glm::dvec2 &a = loop[(tip + n - 1) % n].flat, &b = loop[tip].flat, &c = loop[(tip + 1) % n].flat;
  const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
  const double quality = turn(a, b, c) / (longest * longest);
  if (quality <= 1e-12) return -1.0;
  for (const Corner& corner : loop) {
    const glm::dvec2& p = corner.flat;
    if (p == a || p == b || p == c) continue;
    if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return -1.0;
  }
  return quality;
}

}  // namespace

double polygon_area(const Loop2& loop) {
  double twice = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const glm::dvec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

double polygon_perimeter(const Loop2& loop) {
  double perimeter = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    perimeter += glm::distance(loop[i], loop[(i + 1) % loop.size()]);
  return perimeter;
}

Loop2 regular_polygon(int sides, double radius, double turn_deg) {
  Loop2 loop;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / sides + glm::radians(turn_deg);
    loop.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return loop;
}

Loop at_height(const Loop2& loop, double z) {
  Loop raised;
  for (const glm::dvec2& point : loop) raised.emplace_back(point.x, point.y, z);
  return raised;
}

Loop box_face(const glm::dvec3& low, const glm::dvec3& high, int face) {
  const double x0 = low.x, y0 = low.y, z0 = low.z, x1 = high.x, y1 = high.y, z1 = high.z;
  switch (face) {
    case 0:
      return {{x0, y0, z0}, {x0, y0, z1}, {x0, y1, z1}, {x0, y1, z0}};
    case 1:
      return {{x1, y0, z0}, {x1, y1, z0}, {x1, y1, z1}, {x1, y0, z1}};
    case 2:
      return {{x0, y0, z0}, {x1, y0, z0}, {x1, y0, z1}, {x0, y0, z1}};
    case 3:
      return {{x0, y1, z0}, {x0, y1, z1}, {x1, y1, z1}, {x1, y1, z0}};
    case 4:
      return {{x0, y0, z0}, {x0, y1, z0}, {x1, y1, z0}, {x1, y0, z0}};
    default:
      return {{x0, y0, z1}, {x1, y0, z1}, {x1, y1, z1}, {x0, y1, z1}};
  }
}

void SolidBuilder::face(const Loop& outer, const std::vector<Loop>& holes) {
  const glm::dvec3 normal = loop_normal(outer);
  const glm::dvec3 u = glm::normalize(outer[1] - outer[0]), v = glm::cross(normal, u);
  FlatLoop loop = flattened(outer, outer[0], u, v);
  std::vector<FlatLoop> flat_holes;
  for (const Loop& hole : holes) {
    flat_holes.push_back(flattened(hole, outer[0], u, v));
    if (signed_area(flat_holes.back()) > 0.0)
      std::reverse(flat_holes.back().begin(), flat_holes.back().end());
  }
  for (const FlatLoop& hole : flat_holes) bridge(loop, hole, flat_holes);

  while (loop.size() >= 3) {
    std::size_t best = 0;
    double best_quality = -1.0;
    for (std::size_t tip = 0; tip < loop.size(); ++tip) {
      const double quality = ear_quality(loop, tip);
      if (quality > best_quality) {
        best_quality = quality;
        best = tip;
      }
    }
    CHECK(best_quality > 0.0);
    corners_.push_back(loop[(best + loop.size() - 1) % loop.size()].point);
    corners_.push_back(loop[best].point);
    corners_.push_back(loop[(best + 1) % loop.size()].point);
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(best));
  }
}

void SolidBuilder::walls(const Loop& low, const Loop& high) {
  CHECK(low.size() == high.size());
  for (std::size_t i = 0; i < low.size(); ++i) {
    const std::size_t next = (i + 1) % low.size();
    face({low[i], low[next], high[next], high[i]});
  }
}

void SolidBuilder::extrude(const Loop2& outer, const std::vector<Loop2>& holes, double length) {
  const auto placed = [](const Loop2& loop, double y) {
    Loop result;
    for (const glm::dvec2& point : loop) result.emplace_back(point.x, y, point.y);
    return result;
  };
  const auto reversed = [](auto loop) {
    std::reverse(loop.begin(), loop.end());
    return loop;
  };
  std::vector<Loop> near_holes, far_holes;
  for (Loop2 hole : holes) {
    if (polygon_area(hole) > 0.0) hole = reversed(hole);
    near_holes.push_back(placed(hole, 0.0));
    far_holes.push_back(placed(hole, length));
    walls(far_holes.back(), near_holes.back());
  }
  CHECK(polygon_area(outer) > 0.0);
  face(placed(outer, 0.0), near_holes);
  face(reversed(placed(outer, length)), far_holes);
  walls(placed(outer, length), placed(outer, 0.0));
}

void SolidBuilder::box(const glm::dvec3& low, const glm::dvec3& high, const std::vector<int>& left_out,
                       bool inward) {
  for (int number = 0; number < 6; ++number) {
    if (std::find(left_out.begin(), left_out.end(), number) != left_out.end()) continue;
    Loop loop = box_face(low, high, number);
    if (inward) std::reverse(loop.begin(), loop.end());
    face(loop);
  }
}

TriangleMesh SolidBuilder::mesh() const {
  TriangleMesh welded = weld_corners(corners_);
  const HealthReport report = health_report(welded, facet_geometry(welded));
  CHECK(report.closed && report.nonmanifold_edges == 0 && report.degenerate_facets == 0);
  return welded;
}

}  // namespace moldlight::test
