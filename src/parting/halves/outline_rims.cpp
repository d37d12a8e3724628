#include "parting/halves/outline_rims.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/union_find.hpp"

namespace moldlight {

namespace {

/// Holes narrower than this, in diagonals of the part, or than their outline is off the plane, get a plane
/// whatever that is: what leads from one height to the other there is an upright wall.
constexpr double k_small_hole = 0.005;
/// How far in the plane the line, which may be a little off the surface, is from the outline, in diagonals of
/// the part.
constexpr double k_line_reach = 1.5e-4;
/// Slack of a hole's plane, in diagonals.
constexpr double k_plane_slack = 1e-5;
/// Shorter stretches of the outline than this, in diagonals, do not pull the surface along.
constexpr double k_tongue = 2e-3;
using EndRanges = std::array<HeightRange, 2>;

std::unordered_map<std::uint64_t, EndRanges> segment_ranges(const Sheets& sheets) {
  std::unordered_map<std::uint64_t, EndRanges> ranges;
  for (const Sheet sheet : {Sheet::lower, Sheet::upper}) {
    for (const SegmentEdges& segment : sheets.by_segment(sheets.ends(Sheets::bit(sheet)))) {
      EndRanges& found = ranges[Sheets::edge_key(segment.a, segment.b)];
      for (const SegmentEdge& edge : segment.edges) {
        const std::array<double, 2> z = {sheets.vertices[edge.a].z, sheets.vertices[edge.b].z};
        for (std::size_t k = 0; k < 2; ++k) {
          if (sheet == Sheet::lower) found[k].low = std::max(found[k].low, z[k]);
          if (sheet == Sheet::upper) found[k].high = std::min(found[k].high, z[k]);
        }
      }
    }
  }
  return ranges;
}

/// Both ends of each, somewhat within it, so that what is said of a wall across a corner is not said of it.
std::vector<OutlinePoint> points_within(const std::vector<RimSegment>& rims, double inset) {
  std::vector<OutlinePoint> points;
  for (const RimSegment& rim : rims) {
    const double share = std::min(0.5, inset / std::max(rim.length(), 1e-300));
    points.push_back({glm::mix(rim.ends[0], rim.ends[1], share), rim.ranges[0]});
    points.push_back({glm::mix(rim.ends[1], rim.ends[0], share), rim.ranges[1]});
  }
  return points;
}

/// Without the shortest stretches that the shelf does not meet, which would be tongues too thin to be cut:
/// an upright wall leads from the shelf to the part there.
std::vector<RimSegment> without_tongues(const std::vector<RimSegment>& rims, const ShelfPlane& shelf) {
  const auto missed = [&](const RimSegment& rim) { return !shelf.meets({rim}, k_plane_slack); };
  std::map<std::pair<double, double>, std::uint32_t> first_at;
  UnionFind joined(rims.size());
  for (std::uint32_t k = 0; k < rims.size(); ++k) {
    if (!missed(rims[k])) continue;
    for (const glm::dvec2& end : rims[k].ends)
      joined.join(k, first_at.try_emplace({end.x, end.y}, k).first->second);
  }
  std::vector<double> lengths(rims.size(), 0.0);
  for (std::uint32_t k = 0; k < rims.size(); ++k) lengths[joined.find(k)] += rims[k].length();
  std::vector<RimSegment> kept;
  for (std::uint32_t k = 0; k < rims.size(); ++k) {
    if (!missed(rims[k]) || lengths[joined.find(k)] > k_tongue) kept.push_back(rims[k]);
  }
  return kept;
}

/// Twice the area by the length around: the width of a slot, half of that of a square.
double width_of(const std::vector<RimSegment>& rims) {
  double twice_area = 0.0, around = 0.0;
  for (const RimSegment& rim : rims) {
    const auto& [a, b] = rim.ends;
    twice_area += a.x * b.y - a.y * b.x;
    around += rim.length();
  }
  return around > 0.0 ? std::abs(twice_area) / around : 0.0;
}

}  // namespace

RegionRims outline_rims(const Sheets& sheets, const OutlinePlane& plane) {
  const auto ranges = segment_ranges(sheets);
  RegionRims regions(plane.mesh.region_count());
  for (const PlaneMesh::Triangle& t : plane.mesh.triangles()) {
    if (t.inside) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      if (t.fixed[k] != PlaneMesh::k_outline) continue;
      const std::uint32_t from = t.corners[k], to = t.corners[(k + 1) % 3];
      const PlanePoint a = plane.column_of[from], b = plane.column_of[to];
      const auto found = ranges.find(Sheets::edge_key(a, b));
      if (found == ranges.end()) continue;
      EndRanges at = found->second;
      if (a > b) std::swap(at[0], at[1]);
      for (HeightRange& range : at) {
        if (range.empty()) range.low = range.high = range.middle();
      }
      regions[t.region].push_back({{plane.mesh.points()[from], plane.mesh.points()[to]}, at});
    }
  }
  return regions;
}

void keep_walls(const RimWishes& wishes, std::vector<RimSegment>& rims) {
  if (wishes.walls.empty()) return;
  const double reach = k_wall_reach * wishes.tolerance;
  const auto by_hand = wall_ranges(points_within(rims, 3.0 * reach), wishes.walls, reach);
  for (std::size_t k = 0; k < by_hand.size(); ++k) {
    HeightRange& range = rims[k / 2].ranges[k % 2];
    const HeightRange both{std::max(range.low, by_hand[k].low), std::min(range.high, by_hand[k].high)};
    if (!both.empty()) range = both;
  }
}

std::vector<ShelfField> shelf_fields(const RegionRims& rims, const RimWishes& wishes, const ShelfShape& shape,
                                     const Progress& progress) {
  std::vector<ShelfField> fields;
  for (const std::vector<RimSegment>& region : rims) {
    const auto of_line =
        line_ranges(points_within(region, 0.25 * k_line_reach), wishes.line, k_line_reach, progress);
    std::vector<double> line;
    for (std::size_t k = 0; k < region.size(); ++k)
      line.push_back(0.5 * (of_line[2 * k].middle() + of_line[2 * k + 1].middle()));
    ShelfPlane shelf{.height = shelf_level(region, line, wishes.height)};
    if (!fields.empty() && !shelf.meets(region, k_plane_slack)) {
      const ShelfPlane inclined = fitted_plane(region);
      if (glm::length(inclined.tilt) <= shape.slope && inclined.meets(region, k_plane_slack))
        shelf = inclined;
    }
    const double width = width_of(region);
    const bool too_narrow = !fields.empty() && (width <= k_small_hole || !shelf.meets(region, width));
    fields.emplace_back(too_narrow ? std::vector<RimSegment>{} : without_tongues(region, shelf), shelf,
                        shape);
  }
  return fields;
}

}  // namespace moldlight
