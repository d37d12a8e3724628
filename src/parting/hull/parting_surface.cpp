#include "parting/hull/parting_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "parting/hull/outline_plane.hpp"
#include "parting/hull/segment_cuts.hpp"

namespace moldlight {

namespace {

constexpr int k_most_surface_rounds = 8;
/// Of the edges over one segment each is compared with so many that follow by height.
constexpr std::size_t k_most_compared = 64;
/// How far in the plane the line, which may be a little off the surface, is from the outline, in diagonals of
/// the part.
constexpr double k_line_reach = 1.5e-4;
/// Ramps are somewhat less steep than they may be, and no shorter than a share of their segment.
constexpr double k_ramp_slope = 0.99, k_least_ramp = 0.02;

/// Between what heights the surface has to stay at the outline, so that the halves touch nowhere else.
std::unordered_map<Column, HeightRange> outline_ranges(const Sheets& sheets) {
  std::unordered_map<Column, HeightRange> ranges;
  for (const SheetEdge& edge : sheets.ends(Sheets::bit(Sheet::lower))) {
    for (const SheetVertex v : {edge.from, edge.to}) {
      HeightRange& range = ranges[sheets.column_of[v]];
      range.low = std::max(range.low, sheets.vertices[v].z);
    }
  }
  for (const SheetEdge& edge : sheets.ends(Sheets::bit(Sheet::upper))) {
    for (const SheetVertex v : {edge.from, edge.to}) {
      HeightRange& range = ranges[sheets.column_of[v]];
      range.high = std::min(range.high, sheets.vertices[v].z);
    }
  }
  return ranges;
}

/// One a point of the plane; no range inside.
std::vector<OutlinePoint> outline_points(const Sheets& sheets, const OutlinePlane& plane) {
  const auto ranges = outline_ranges(sheets);
  std::vector<OutlinePoint> points;
  for (std::size_t point = 0; point < plane.column_of.size(); ++point) {
    points.push_back({plane.mesh.points()[point], {}});
    if (const auto found = ranges.find(plane.column_of[point]); found != ranges.end())
      points.back().part = found->second;
  }
  return points;
}

HeightWishes wishes_at(const std::vector<OutlinePoint>& outline, const SurfaceWish& wish,
                       const Progress& progress) {
  HeightWishes wishes{.height = wish.height,
                      .slope = wish.slope,
                      .line = line_ranges(outline, wish.line, k_line_reach, progress),
                      .hand = wall_ranges(outline, wish.walls, k_wall_reach * wish.tolerance),
                      .part = part_ranges(outline)};
  if (wish.line.empty() && wish.walls.empty()) return wishes;
  // All of the outline has its height then, so that shut-offs are level where it is.
  for (std::size_t point = 0; point < outline.size(); ++point) {
    if (!outline[point].on_outline()) continue;
    auto& [low, high] = wishes.line[point];
    if (!std::isfinite(low)) low = high = wish.height;
    for (const HeightRange& range : {wishes.hand[point], wishes.part[point]}) {
      low = std::max(range.low, std::min(low, range.high));
      high = std::max(range.low, std::min(high, range.high));
    }
  }
  return wishes;
}

/// Where the surface may be level again beside points of the outline between which wishes differ, so that it
/// climbs no longer way than it has to.
std::vector<SegmentCut> ramp_ends(Sheets& sheets, const OutlinePlane& plane, const SurfaceWish& wish,
                                  const Progress& progress) {
  const HeightWishes wishes = wishes_at(outline_points(sheets, plane), wish, progress);
  const auto height_at = [&](std::uint32_t point) {
    double z = wishes.height;
    for (const auto* ranges : {&wishes.line, &wishes.hand, &wishes.part}) {
      const auto [low, high] = (*ranges)[point];
      z = low <= high ? std::clamp(z, low, high) : 0.5 * (low + high);
    }
    return z;
  };
  std::vector<SegmentCut> cuts;
  std::set<std::array<std::uint32_t, 2>> done;
  for (const PlaneMesh::Triangle& t : plane.mesh.triangles()) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t.corners[k], t.corners[(k + 1) % 3]);
      if (t.fixed[k] != PlaneMesh::k_outline || !done.insert({a, b}).second) continue;
      const glm::dvec2 &from = plane.mesh.points()[a], &to = plane.mesh.points()[b];
      const double share =
          std::abs(height_at(a) - height_at(b)) / (k_ramp_slope * wish.slope) / glm::distance(from, to);
      if (share <= k_least_ramp || share >= 1.0 - k_least_ramp) continue;
      for (const double at : {share, 1.0 - share})
        cuts.push_back({plane.column_of[a], plane.column_of[b], sheets.add_column(glm::mix(from, to, at))});
    }
  }
  return cuts;
}

/// A frustum by which the upper half reaches into the lower one.
struct Cone {
  glm::dvec2 centre{0.0};
  double foot = 0.0, top = 0.0, depth = 0.0;  // radii, height

  /// How much lower the surface is at a point.
  [[nodiscard]] double depth_at(const glm::dvec2& at) const {
    return depth * std::clamp((foot - glm::distance(at, centre)) / (foot - top), 0.0, 1.0);
  }
};

/// In the rectangle's corners, clear of the part; one is smaller, so that the halves fit in one way only.
std::vector<Cone> register_cones(const SurfaceWish& wish) {
  constexpr double k_foot = 0.36, k_top = 0.16, k_smaller = 0.8, k_least_slope = 0.9;
  std::vector<Cone> cones;
  if (wish.cone_margin <= 0.0) return cones;
  const double m = wish.cone_margin;
  for (int k = 0; k < 4; ++k) {
    const double size = k == 0 ? k_smaller * m : m;
    const glm::dvec2 centre(k % 2 == 0 ? wish.low.x + 0.5 * m : wish.high.x - 0.5 * m,
                            k / 2 == 0 ? wish.low.y + 0.5 * m : wish.high.y - 0.5 * m);
    cones.push_back(
        {centre, k_foot * size, k_top * size, k_least_slope * wish.slope * (k_foot - k_top) * size});
  }
  return cones;
}

/// Both circles of each cone as segments of the mesh.
void add_circles(PlaneMesh& mesh, const std::vector<Cone>& cones) {
  constexpr int k_sides = 48;
  for (const Cone& cone : cones) {
    for (const double radius : {cone.foot, cone.top}) {
      std::array<std::uint32_t, k_sides> points{};
      for (int k = 0; k < k_sides; ++k) {
        const double turn = 2.0 * std::numbers::pi * k / k_sides;
        points[static_cast<std::size_t>(k)] =
            mesh.add_point(on_grid(cone.centre + radius * glm::dvec2(std::cos(turn), std::sin(turn))));
      }
      for (std::size_t k = 0; k < k_sides; ++k)
        static_cast<void>(mesh.add_segment(points[k], points[(k + 1) % k_sides], PlaneMesh::k_rim));
    }
  }
}

/// Vertices of the sheet at the points, and its facets.
void add_sheet(Sheets& sheets, const OutlinePlane& plane, const std::vector<double>& z, double tolerance) {
  std::unordered_map<Column, std::vector<SheetVertex>> standing;
  for (const Column column : plane.column_of) {
    if (column != k_no_column) standing[column];
  }
  for (SheetVertex v = 0; v < sheets.vertices.size(); ++v) {
    if (const auto found = standing.find(sheets.column_of[v]); found != standing.end())
      found->second.push_back(v);
  }
  std::vector<SheetVertex> vertex(plane.mesh.points().size(), PlaneMesh::k_none);
  const auto vertex_at = [&](std::uint32_t point) {
    if (vertex[point] != PlaneMesh::k_none) return vertex[point];
    const Column column = plane.column_of[point];
    if (column == k_no_column) {
      sheets.vertices.emplace_back(plane.mesh.points()[point].x, plane.mesh.points()[point].y, z[point]);
      sheets.column_of.push_back(k_no_column);
      return vertex[point] = static_cast<SheetVertex>(sheets.vertices.size() - 1);
    }
    SheetVertex nearest = PlaneMesh::k_none;
    for (const SheetVertex v : standing[column]) {
      const double away = std::abs(sheets.vertices[v].z - z[point]);
      if (away <= tolerance &&
          (nearest == PlaneMesh::k_none || away < std::abs(sheets.vertices[nearest].z - z[point])))
        nearest = v;
    }
    return vertex[point] = nearest != PlaneMesh::k_none ? nearest : sheets.add_vertex(column, z[point]);
  };
  for (const PlaneMesh::Triangle& t : plane.mesh.triangles()) {
    if (t.inside) continue;
    sheets.facets.push_back(
        {{vertex_at(t.corners[0]), vertex_at(t.corners[1]), vertex_at(t.corners[2])}, Sheet::parting});
  }
}

/// Where edges over a segment change their order; edges of hidden surface and of what is seen do not meet in
/// one body, but a column too many does no harm.
std::vector<SegmentCut> find_crossings(Sheets& sheets, double tolerance) {
  std::vector<SheetEdge> edges;
  for (const Sheet sheet : {Sheet::upper, Sheet::lower, Sheet::hidden, Sheet::parting}) {
    const auto more = sheets.ends(Sheets::bit(sheet));
    edges.insert(edges.end(), more.begin(), more.end());
  }
  std::vector<SegmentCut> cuts;
  for (SegmentEdges& segment : sheets.by_segment(edges)) {
    std::ranges::sort(segment.edges, {}, [&](const SegmentEdge& edge) {
      return std::tuple(sheets.vertices[edge.a].z + sheets.vertices[edge.b].z, edge.a, edge.b);
    });
    bool found = false;
    for (std::size_t i = 0; i < segment.edges.size() && !found; ++i) {
      const std::size_t last = std::min(segment.edges.size(), i + 1 + k_most_compared);
      for (std::size_t j = i + 1; j < last && !found; ++j) {
        const SegmentEdge &p = segment.edges[i], &q = segment.edges[j];
        const double at_a = sheets.vertices[p.a].z - sheets.vertices[q.a].z,
                     at_b = sheets.vertices[p.b].z - sheets.vertices[q.b].z;
        if (at_a * at_b >= 0.0 || std::min(std::abs(at_a), std::abs(at_b)) <= tolerance) continue;
        const double share = at_a / (at_a - at_b);
        cuts.push_back(
            {segment.a, segment.b,
             sheets.add_column(glm::mix(sheets.columns[segment.a], sheets.columns[segment.b], share))});
        found = true;
      }
    }
  }
  return cuts;
}

}  // namespace

std::optional<MoldFault> add_parting_surface(Sheets& sheets, const SurfaceWish& wish, ForcedSlope& forced,
                                             const Progress& progress) {
  const auto go_on = [&] { progress.report(k_halves_stage, 0.0); };
  OutlinePlane plane(wish.low, wish.high);
  const OutlinePlane empty = plane;
  if (auto fault = lay_outline(sheets, wish.tolerance, wish.height, plane)) return fault;
  if (const std::vector<SegmentCut> ramps = ramp_ends(sheets, plane, wish, progress); !ramps.empty()) {
    cut_segments(sheets, ramps);
    sheets.weld_columns(wish.tolerance);
    plane = empty;
    if (auto fault = lay_outline(sheets, wish.tolerance, wish.height, plane)) return fault;
  }
  go_on();
  const std::vector<Cone> cones = register_cones(wish);
  add_circles(plane.mesh, cones);
  refine_outside(sheets, wish.tolerance, plane);
  go_on();
  const std::vector<OutlinePoint> outline = outline_points(sheets, plane);
  const MeetingHeights found = meeting_heights(plane.mesh, wishes_at(outline, wish, progress), k_narrow);
  go_on();
  forced = found.forced;
  std::vector<double> z = found.z;
  for (std::size_t point = 0; point < z.size(); ++point) {
    for (const Cone& cone : cones) z[point] -= cone.depth_at(plane.mesh.points()[point]);
  }
  add_sheet(sheets, plane, z, wish.tolerance);
  for (int round = 0; round < k_most_surface_rounds; ++round) {
    go_on();
    const std::vector<SegmentCut> crossings = find_crossings(sheets, wish.tolerance);
    if (crossings.empty()) break;
    cut_segments(sheets, crossings);
    sheets.weld_columns(wish.tolerance);
  }
  return std::nullopt;
}

}  // namespace moldlight
