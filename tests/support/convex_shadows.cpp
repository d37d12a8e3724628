#include "support/convex_shadows.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "mold/draft.hpp"

namespace moldlight::test {
namespace {

/// Directions that run in a face's plane have a sine of at most this.
constexpr double k_in_plane = 1e-10;
/// Heights above a plane that are rounding, as a share of the bodies' size.
constexpr double k_on_plane = 1e-12;

double turn_of(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

Loop2 hull(std::vector<glm::dvec2> points) {
  std::sort(points.begin(), points.end(),
            [](const glm::dvec2& a, const glm::dvec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  Loop2 loop;
  for (int half = 0; half < 2; ++half) {
    const std::size_t first = loop.size();
    for (const glm::dvec2& point : points) {
      while (loop.size() >= first + 2 && turn_of(loop[loop.size() - 2], loop.back(), point) <= 0.0)
        loop.pop_back();
      loop.push_back(point);
    }
    loop.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return loop;
}

/// The part of a convex polygon inside another one.
Loop2 clipped(Loop2 loop, const Loop2& by) {
  for (std::size_t side = 0; side < by.size() && !loop.empty(); ++side) {
    const glm::dvec2 &from = by[side], &to = by[(side + 1) % by.size()];
    Loop2 kept;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const glm::dvec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
      const double at_a = turn_of(from, to, a), at_b = turn_of(from, to, b);
      if (at_a >= 0.0) kept.push_back(a);
      if ((at_a > 0.0 && at_b < 0.0) || (at_a < 0.0 && at_b > 0.0))
        kept.push_back(a + at_a / (at_a - at_b) * (b - a));
    }
    loop = kept;
  }
  return loop;
}

struct Edge2 {
  glm::dvec2 low, high;  // low.x <= high.x
  std::size_t polygon;
};

/// A plane with coordinates of its own: where faces and shadows are compared.
struct Plane {
  glm::dvec3 origin, normal, u, v;
  Plane(const glm::dvec3& origin_, const glm::dvec3& normal_) : origin(origin_), normal(normal_) {
    const glm::dvec3 helper = std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    u = glm::normalize(glm::cross(helper, normal));
    v = glm::cross(normal, u);
  }
  [[nodiscard]] glm::dvec2 flat(const glm::dvec3& point) const {
    return {glm::dot(point - origin, u), glm::dot(point - origin, v)};
  }
};

/// Where in the plane a ray along `along` runs into the body.
Loop2 hidden_by(const ConvexBody& body, const Plane& plane, const glm::dvec3& along, double size) {
  const double sine = glm::dot(along, plane.normal);
  const bool in_plane = std::abs(sine) < k_in_plane;
  const double side = sine < 0.0 ? -1.0 : 1.0;
  std::vector<double> heights;
  double lowest = 0.0, highest = 0.0;
  for (const glm::dvec3& point : body) {
    heights.push_back(side * glm::dot(point - plane.origin, plane.normal));
    lowest = std::min(lowest, heights.back());
    highest = std::max(highest, heights.back());
  }
  if (highest <= k_on_plane * size || (in_plane && lowest >= -k_on_plane * size)) return {};
  std::vector<glm::dvec2> points;
  for (std::size_t i = 0; i < body.size(); ++i) {
    if (heights[i] >= 0.0 && !in_plane)
      points.push_back(plane.flat(body[i] - side * heights[i] / sine * along));
    for (std::size_t j = 0; j < body.size(); ++j) {
      if (heights[i] <= 0.0 || heights[j] > 0.0) continue;
      const glm::dvec3 crossing = body[i] + heights[i] / (heights[i] - heights[j]) * (body[j] - body[i]);
      points.push_back(plane.flat(crossing));
      if (in_plane) points.push_back(plane.flat(crossing - 10.0 * size * along));
    }
  }
  return hull(points);
}

/// The parts of the face from which a ray along `along` runs into a body.
std::vector<Loop2> hidden_parts(const Loop2& face, const std::vector<ConvexBody>& bodies, const Plane& plane,
                                const glm::dvec3& along, double size) {
  std::vector<Loop2> parts;
  for (const ConvexBody& body : bodies) {
    Loop2 part = clipped(hidden_by(body, plane, along, size), face);
    if (part.size() >= 3) parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace

double union_area(const std::vector<Loop2>& polygons) {
  std::vector<Edge2> edges;
  std::vector<double> stops;  // between two of them no edges cross and none ends
  for (std::size_t polygon = 0; polygon < polygons.size(); ++polygon) {
    const Loop2& loop = polygons[polygon];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const glm::dvec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
      edges.push_back(a.x <= b.x ? Edge2{a, b, polygon} : Edge2{b, a, polygon});
      stops.push_back(a.x);
    }
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const Edge2 &e = edges[i], &f = edges[j];
      if (e.polygon == f.polygon || e.high.x <= f.low.x || f.high.x <= e.low.x) continue;
      const double at_low = turn_of(e.low, e.high, f.low), at_high = turn_of(e.low, e.high, f.high);
      if ((at_low > 0.0) == (at_high > 0.0)) continue;
      stops.push_back(f.low.x + at_low / (at_low - at_high) * (f.high.x - f.low.x));
    }
  }
  std::sort(stops.begin(), stops.end());
  double area = 0.0;
  std::vector<glm::dvec2> spans;
  std::vector<std::optional<glm::dvec2>> span_of(polygons.size());
  for (std::size_t stop = 0; stop + 1 < stops.size(); ++stop) {
    const double width = stops[stop + 1] - stops[stop], x = 0.5 * (stops[stop] + stops[stop + 1]);
    if (width <= 0.0) continue;
    std::fill(span_of.begin(), span_of.end(), std::nullopt);
    for (const Edge2& edge : edges) {
      if (edge.low.x >= x || edge.high.x <= x) continue;
      const double y =
          edge.low.y + (x - edge.low.x) / (edge.high.x - edge.low.x) * (edge.high.y - edge.low.y);
      std::optional<glm::dvec2>& span = span_of[edge.polygon];
      span = span ? glm::dvec2(std::min(span->x, y), std::max(span->y, y)) : glm::dvec2(y, y);
    }
    spans.clear();
    for (const auto& span : span_of) {
      if (span) spans.push_back(*span);
    }
    std::sort(spans.begin(), spans.end(), [](const glm::dvec2& a, const glm::dvec2& b) { return a.x < b.x; });
    double covered_to = -std::numeric_limits<double>::infinity();
    for (const glm::dvec2& span : spans) {
      area += width * std::max(0.0, span.y - std::max(span.x, covered_to));
      covered_to = std::max(covered_to, span.y);
    }
  }
  return area;
}

RegionValues face_areas(const std::vector<PlanarFace>& faces, const std::vector<ConvexBody>& bodies,
                        const glm::dvec3& direction, const ShapeSettings& settings) {
  Bounds box;
  for (const ConvexBody& body : bodies) {
    for (const glm::dvec3& point : body) {
      box.min = glm::min(box.min, point);
      box.max = glm::max(box.max, point);
    }
  }
  const double size = box.diagonal();
  RegionValues areas;
  for (const PlanarFace& face : faces) {
    const FacetClass facet = facet_class(face.normal, direction, settings.tau_deg);
    glm::dvec3 shift(0.0);
    if (facet == FacetClass::near_vertical) {
      shift = settings.lateral_tolerance *
              glm::normalize(face.normal - glm::dot(face.normal, direction) * direction);
    }
    const Plane plane(face.corners[0] + shift, face.normal);
    Loop2 loop;
    for (const glm::dvec3& corner : face.corners) loop.push_back(plane.flat(corner + shift));
    const double whole = polygon_area(loop);
    if (facet != FacetClass::near_vertical) {
      const bool up = facet == FacetClass::up;
      const double hidden = union_area(hidden_parts(loop, bodies, plane, up ? direction : -direction, size));
      areas[up ? Region::core : Region::cavity] += whole - hidden;
      areas[Region::undercut] += hidden;
      continue;
    }
    std::vector<Loop2> plus = hidden_parts(loop, bodies, plane, direction, size);
    const std::vector<Loop2> minus = hidden_parts(loop, bodies, plane, -direction, size);
    const double hidden_plus = union_area(plus), hidden_minus = union_area(minus);
    plus.insert(plus.end(), minus.begin(), minus.end());
    const double hidden = union_area(plus);
    areas[Region::both] += whole - hidden;
    areas[Region::core] += hidden - hidden_plus;
    areas[Region::cavity] += hidden - hidden_minus;
    areas[Region::undercut] += hidden_plus + hidden_minus - hidden;
  }
  return areas;
}

double shadow_area(const std::vector<ConvexBody>& bodies, const glm::dvec3& direction) {
  const Plane plane(glm::dvec3(0.0), direction);
  std::vector<Loop2> shadows;
  for (const ConvexBody& body : bodies) {
    std::vector<glm::dvec2> points;
    for (const glm::dvec3& point : body) points.push_back(plane.flat(point));
    shadows.push_back(hull(points));
  }
  return union_area(shadows);
}

}  // namespace moldlight::test
