#include "parting/halves/outline_plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace moldlight {

namespace {

constexpr int k_most_cut_rounds = 8;

struct Outline {
  std::vector<std::array<PlanePoint, 2>> segments;
};

/// The segments at which the upper sheet ends as a whole.
std::optional<MoldFault> find_outline(const Sheets& sheets, Outline& outline) {
  for (const SegmentEdges& segment : sheets.by_segment(sheets.ends(Sheets::bit(Sheet::upper)))) {
    int sum = 0;
    for (const SegmentEdge& edge : segment.edges) sum += edge.sign;
    if (sum == 0) continue;
    if (std::abs(sum) > 1)
      return MoldFault{"the surface seen from above overlaps itself", k_mend_surface,
                       sheets.vertices[segment.edges.front().a]};
    outline.segments.push_back({segment.a, segment.b});
  }
  if (outline.segments.empty())
    return MoldFault{"the part is too thin along the direction and has no outline",
                     "choose a direction across the part's faces, not along them"};
  return std::nullopt;
}

/// Cuts where a point or a segment stands in the way of another; empty where the mesh was made.
std::vector<SegmentCut> triangulate(Sheets& sheets, const Outline& outline, OutlinePlane& plane) {
  std::unordered_map<PlanePoint, std::uint32_t> point_of;
  const auto point = [&](PlanePoint column) {
    const auto [entry, fresh] = point_of.try_emplace(column, 0);
    if (fresh) {
      entry->second = plane.mesh.add_point(sheets.columns[column]);
      plane.column_of.resize(plane.mesh.points().size(), k_no_plane_point);
      plane.column_of[entry->second] = column;
    }
    return entry->second;
  };
  // Neighbours one after the other, so that each is found near the last.
  std::vector<std::array<PlanePoint, 2>> segments = outline.segments;
  std::ranges::sort(segments, {}, [&](const auto& s) {
    const glm::dvec2& at = sheets.columns[s[0]];
    const auto band = static_cast<std::int64_t>(std::floor(64.0 * at.y));
    return std::tuple(band, band % 2 == 0 ? at.x : -at.x);
  });
  for (const auto& [a, b] : segments) {
    static_cast<void>(point(a));
    static_cast<void>(point(b));
  }
  std::vector<SegmentCut> cuts;
  for (const auto& [a, b] : segments) {
    const auto obstacle = plane.mesh.add_segment(point(a), point(b), PlaneMesh::k_outline);
    if (!obstacle) continue;
    if (obstacle->point != PlaneMesh::k_none) {
      cuts.push_back({a, b, plane.column_of[obstacle->point]});
    } else if (obstacle->segment[0] != PlaneMesh::k_none) {
      const PlanePoint c = plane.column_of[obstacle->segment[0]], d = plane.column_of[obstacle->segment[1]];
      if (c == k_no_plane_point || d == k_no_plane_point) continue;
      const glm::dvec2 &pa = sheets.columns[a], &pb = sheets.columns[b], &pc = sheets.columns[c],
                       &pd = sheets.columns[d];
      const glm::dvec2 r = pb - pa, s = pd - pc;
      const double t = ((pc.x - pa.x) * s.y - (pc.y - pa.y) * s.x) / (r.x * s.y - r.y * s.x);
      const PlanePoint at = sheets.add_column(pa + t * r);
      cuts.push_back({a, b, at});
      cuts.push_back({c, d, at});
    }
  }
  return cuts;
}

/// Sides of the outline, as points in rising order.
std::set<std::array<std::uint32_t, 2>> outline_sides(const PlaneMesh& mesh) {
  std::set<std::array<std::uint32_t, 2>> sides;
  for (const PlaneMesh::Triangle& t : mesh.triangles()) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (t.fixed[k] != PlaneMesh::k_outline) continue;
      const auto [low, high] = std::minmax(t.corners[k], t.corners[(k + 1) % 3]);
      sides.insert({low, high});
    }
  }
  return sides;
}

/// Columns for the points of the outline from number `before` on.
std::vector<SegmentCut> columns_of_parts(Sheets& sheets, std::size_t before, OutlinePlane& plane) {
  const auto sides = outline_sides(plane.mesh);
  // Chains of new points between two that had a column.
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> next;
  for (const auto& [a, b] : sides) {
    if (a < before && b < before) continue;
    next[a].push_back(b);
    next[b].push_back(a);
  }
  std::vector<SegmentCut> cuts;
  for (const auto& side : sides) {
    for (std::size_t end = 0; end < 2; ++end) {
      std::uint32_t from = side[end], to = side[1 - end];
      if (from >= before || to < before) continue;
      const PlanePoint first = plane.column_of[from];
      std::vector<std::uint32_t> chain;
      while (to >= before) {
        chain.push_back(to);
        const auto& ways = next.at(to);
        const std::uint32_t onward = ways[0] == from ? ways[1] : ways[0];
        from = to;
        to = onward;
      }
      const PlanePoint last = plane.column_of[to];
      if (first > last) continue;  // it comes from the other end, too
      for (const std::uint32_t point : chain) {
        plane.column_of[point] = sheets.add_column(plane.mesh.points()[point]);
        cuts.push_back({first, last, plane.column_of[point]});
      }
    }
  }
  return cuts;
}

}  // namespace

void cut_segments(Sheets& sheets, const std::vector<SegmentCut>& cuts) {
  std::unordered_map<std::uint64_t, std::vector<PlanePoint>> on_segment;
  for (const SegmentCut& cut : cuts) on_segment[Sheets::edge_key(cut.a, cut.b)].push_back(cut.at);
  Sheets::OnEdges on_edges;
  for (const Sheet sheet : {Sheet::upper, Sheet::lower, Sheet::hidden, Sheet::beside, Sheet::parting}) {
    for (const SheetEdge& edge : sheets.ends(Sheets::bit(sheet))) {
      const auto [low, high] = std::minmax(edge.from, edge.to);
      const auto found = on_segment.find(Sheets::edge_key(sheets.column_of[low], sheets.column_of[high]));
      if (sheets.column_of[low] == k_no_plane_point || sheets.column_of[high] == k_no_plane_point ||
          found == on_segment.end() || on_edges.contains(Sheets::edge_key(low, high)))
        continue;
      const glm::dvec2 a(sheets.vertices[low]), b(sheets.vertices[high]);
      std::vector<std::pair<double, PlanePoint>> places;
      for (const PlanePoint column : found->second)
        places.emplace_back(glm::dot(sheets.columns[column] - a, b - a) / glm::dot(b - a, b - a), column);
      std::ranges::sort(places);
      std::vector<SheetVertex>& list = on_edges[Sheets::edge_key(low, high)];
      const double z_low = sheets.vertices[low].z, z_high = sheets.vertices[high].z;
      for (const auto& [share, column] : places) {
        if (!list.empty() && sheets.column_of[list.back()] == column) continue;
        list.push_back(sheets.add_vertex(column, glm::mix(z_low, z_high, share)));
      }
    }
  }
  sheets.divide_edges(on_edges);
}

std::optional<MoldFault> lay_outline(Sheets& sheets, double tolerance, double height, OutlinePlane& plane) {
  const OutlinePlane empty = plane;
  for (int round = 0;; ++round) {
    Outline outline;
    if (auto fault = find_outline(sheets, outline)) return fault;
    plane = empty;
    const std::vector<SegmentCut> cuts = triangulate(sheets, outline, plane);
    if (cuts.empty()) {
      plane.mesh.find_inside();
      return std::nullopt;
    }
    if (round == k_most_cut_rounds) {
      return MoldFault{"the outline crosses itself", k_mend_surface,
                       glm::dvec3(sheets.columns[cuts.front().at], height)};
    }
    cut_segments(sheets, cuts);
    sheets.weld_columns(tolerance);
  }
}

void put_in_columns(Sheets& sheets, std::size_t before, double tolerance, OutlinePlane& plane) {
  plane.column_of.resize(plane.mesh.points().size(), k_no_plane_point);
  const std::vector<SegmentCut> cuts = columns_of_parts(sheets, before, plane);
  if (cuts.empty()) return;
  cut_segments(sheets, cuts);
  sheets.weld_columns(tolerance);
}

}  // namespace moldlight
