#include "parting/halves/assigned_walls.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace moldlight {

namespace {

/// A wall as a triangle in its own plane: along its foot, and up.
struct FlatWall {
  glm::dvec2 start{0.0}, along{0.0};  // unit
  double length = 0.0;
  std::array<glm::dvec2, 3> corners{};  // along, height

  explicit FlatWall(const AssignedWall& wall) {
    glm::dvec2 end(0.0);
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec2 a(wall.corners[k]), b(wall.corners[(k + 1) % 3]);
      if (glm::distance(a, b) < length) continue;
      length = glm::distance(a, b);
      start = a;
      end = b;
    }
    if (length > 0.0) along = (end - start) / length;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = {glm::dot(glm::dvec2(wall.corners[k]) - start, along), wall.corners[k].z};
  }

  [[nodiscard]] double place_of(const glm::dvec2& at) const { return glm::dot(at - start, along); }
  [[nodiscard]] bool passes(const glm::dvec2& at, double reach) const {
    const glm::dvec2 away = at - start;
    return std::abs(away.x * along.y - away.y * along.x) <= reach && place_of(at) >= -reach &&
           place_of(at) <= length + reach;
  }
  /// Heights over a place of the foot.
  [[nodiscard]] HeightRange heights_at(double place, double reach) const {
    HeightRange found{INFINITY, -INFINITY};
    const auto add = [&](double z) { found = {std::min(found.low, z), std::max(found.high, z)}; };
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec2 &a = corners[k], &b = corners[(k + 1) % 3];
      if (std::abs(a.x - place) <= reach) add(a.y);
      if ((a.x - place) * (b.x - place) < 0.0) add(glm::mix(a.y, b.y, (place - a.x) / (b.x - a.x)));
    }
    return found;
  }
};

using Polygon = std::vector<glm::dvec2>;

/// What of a convex polygon is where `depth` is not negative; `depth` is linear.
Polygon clipped(const Polygon& polygon, const std::function<double(const glm::dvec2&)>& depth) {
  Polygon kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double at_a = depth(a), at_b = depth(b);
    if (at_a >= 0.0) kept.push_back(a);
    if (at_a * at_b < 0.0) kept.push_back(glm::mix(a, b, at_a / (at_a - at_b)));
  }
  return kept;
}

double area_of(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const glm::dvec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * std::abs(twice);
}

/// Over a segment of the outline: where the part is below, where above, and the parting surface, at its ends.
struct OutlineWall {
  std::array<glm::dvec2, 2> ends{};
  std::array<double, 2> low{-INFINITY, -INFINITY}, high{INFINITY, INFINITY}, parting{};
  int meetings = 0;
};

std::vector<OutlineWall> outline_walls(const Sheets& sheets) {
  std::unordered_map<std::uint64_t, OutlineWall> walls;
  const auto heights = [&](const SegmentEdge& edge) {
    return std::array{sheets.vertices[edge.a].z, sheets.vertices[edge.b].z};
  };
  const auto lower_of = [](const std::array<double, 2>& p, const std::array<double, 2>& q) {
    return p[0] + p[1] < q[0] + q[1] ? p : q;
  };
  const auto upper_of = [](const std::array<double, 2>& p, const std::array<double, 2>& q) {
    return p[0] + p[1] > q[0] + q[1] ? p : q;
  };
  std::vector<std::uint64_t> order;
  for (const SegmentEdges& segment : sheets.by_segment(sheets.ends(Sheets::bit(Sheet::parting)))) {
    OutlineWall& wall = walls[Sheets::edge_key(segment.a, segment.b)];
    wall.ends = {sheets.columns[segment.a], sheets.columns[segment.b]};
    wall.meetings = static_cast<int>(segment.edges.size());
    wall.parting = heights(segment.edges.front());
    order.push_back(Sheets::edge_key(segment.a, segment.b));
  }
  for (const Sheet sheet : {Sheet::lower, Sheet::upper}) {
    for (const SegmentEdges& segment : sheets.by_segment(sheets.ends(Sheets::bit(sheet)))) {
      const auto found = walls.find(Sheets::edge_key(segment.a, segment.b));
      if (found == walls.end()) continue;
      OutlineWall& wall = found->second;
      for (const SegmentEdge& edge : segment.edges) {
        if (sheet == Sheet::lower) wall.low = upper_of(wall.low, heights(edge));
        if (sheet == Sheet::upper) wall.high = lower_of(wall.high, heights(edge));
      }
    }
  }
  std::vector<OutlineWall> list;
  for (const std::uint64_t key : order) {
    const OutlineWall& wall = walls.at(key);
    if (wall.meetings == 1 && std::isfinite(wall.low[0]) && std::isfinite(wall.high[0])) list.push_back(wall);
  }
  return list;
}

/// What of a wall is over a segment of the outline, and what of that the wrong half forms.
struct MetPart {
  double area = 0.0;
  Polygon missed;
};
MetPart met_part(const FlatWall& wall, bool core, const OutlineWall& over) {
  const std::array<double, 2> at = {wall.place_of(over.ends[0]), wall.place_of(over.ends[1])};
  const auto height = [&](const std::array<double, 2>& z, double place) {
    return glm::mix(z[0], z[1], (place - at[0]) / (at[1] - at[0]));
  };
  Polygon polygon(wall.corners.begin(), wall.corners.end());
  polygon = clipped(polygon, [&](const glm::dvec2& p) { return p.x - std::min(at[0], at[1]); });
  polygon = clipped(polygon, [&](const glm::dvec2& p) { return std::max(at[0], at[1]) - p.x; });
  polygon = clipped(polygon, [&](const glm::dvec2& p) { return p.y - height(over.low, p.x); });
  polygon = clipped(polygon, [&](const glm::dvec2& p) { return height(over.high, p.x) - p.y; });
  return {area_of(polygon), clipped(polygon, [&](const glm::dvec2& p) {
            return core ? height(over.parting, p.x) - p.y : p.y - height(over.parting, p.x);
          })};
}

}  // namespace

std::vector<HeightRange> wall_ranges(std::span<const OutlinePoint> points,
                                     std::span<const AssignedWall> walls, double reach) {
  std::vector<HeightRange> ranges(points.size());
  for (const AssignedWall& assigned : walls) {
    const FlatWall wall(assigned);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto& [at, part] = points[k];
      if (!points[k].on_outline() || part.high - part.low <= reach || !wall.passes(at, reach)) continue;
      const HeightRange over = wall.heights_at(std::clamp(wall.place_of(at), 0.0, wall.length), reach);
      if (over.high <= part.low + reach || over.low >= part.high - reach || over.high - over.low <= reach)
        continue;
      if (assigned.core) {
        ranges[k].high = std::min(ranges[k].high, std::max(over.low, part.low));
      } else {
        ranges[k].low = std::max(ranges[k].low, std::min(over.high, part.high));
      }
    }
  }
  for (auto& [low, high] : ranges) {
    if (low > high) low = high = 0.5 * (low + high);
  }
  return ranges;
}

std::vector<HeightRange> line_ranges(std::span<const OutlinePoint> points, std::span<const LinePiece> line,
                                     double reach, const Progress& progress) {
  std::vector<HeightRange> ranges(points.size());
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (points[k].on_outline() && points[k].part.low < points[k].part.high) order.push_back(k);
  }
  std::ranges::sort(order, {}, [&](std::size_t k) { return std::pair(points[k].at.x, k); });
  for (const auto& [from, to] : line) {
    progress.report(k_halves_stage, 0.0);
    const glm::dvec2 a(from), b(to);
    const double squared = glm::dot(b - a, b - a);
    auto next = std::ranges::lower_bound(order, std::min(a.x, b.x) - reach, {},
                                         [&](std::size_t k) { return points[k].at.x; });
    for (; next != order.end() && points[*next].at.x <= std::max(a.x, b.x) + reach; ++next) {
      const glm::dvec2& at = points[*next].at;
      const HeightRange& part = points[*next].part;
      const double share =
          squared > reach * reach ? std::clamp(glm::dot(at - a, b - a) / squared, 0.0, 1.0) : 0.0;
      if (glm::distance(at, glm::mix(a, b, share)) > reach) continue;
      HeightRange& range = ranges[*next];
      const auto add = [&](double z) {
        z = std::clamp(z, part.low, part.high);
        range = std::isfinite(range.low) ? HeightRange{std::min(range.low, z), std::max(range.high, z)}
                                         : HeightRange{z, z};
      };
      add(glm::mix(from.z, to.z, share));
      if (squared <= reach * reach) add(to.z);
    }
  }
  return ranges;
}

MissedWalls missed_walls(const Sheets& sheets, std::span<const AssignedWall> walls, double reach) {
  MissedWalls missed;
  if (walls.empty()) return missed;
  const std::vector<OutlineWall> outline = outline_walls(sheets);
  double most = 0.0;
  for (const AssignedWall& assigned : walls) {
    const FlatWall wall(assigned);
    double& met = missed.met_area.emplace_back(0.0);
    for (const OutlineWall& over : outline) {
      const glm::dvec2 middle = 0.5 * (over.ends[0] + over.ends[1]);
      const glm::dvec2 side = over.ends[1] - over.ends[0];
      const double lean = std::abs(side.x * wall.along.y - side.y * wall.along.x);
      const glm::dvec2 away = middle - wall.start;
      if (lean > 2.0 * reach || std::abs(away.x * wall.along.y - away.y * wall.along.x) > reach) continue;
      const MetPart part = met_part(wall, assigned.core, over);
      met += part.area;
      const double area = area_of(part.missed);
      missed.area += area;
      if (area <= most) continue;
      most = area;
      glm::dvec2 centre(0.0);
      for (const glm::dvec2& p : part.missed) centre += p / static_cast<double>(part.missed.size());
      missed.at = glm::dvec3(wall.start + centre.x * wall.along, centre.y);
    }
  }
  return missed;
}

}  // namespace moldlight
