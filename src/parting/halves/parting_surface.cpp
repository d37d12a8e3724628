#include "parting/halves/parting_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "parting/halves/outline_plane.hpp"
#include "parting/halves/outline_rims.hpp"

namespace moldlight {

namespace {

constexpr int k_most_surface_rounds = 8;
/// Of the edges over one segment each is compared with so many that follow by height.
constexpr std::size_t k_most_compared = 64;

/// Between what heights the surface has to stay at the outline, so that the halves touch nowhere else.
std::unordered_map<PlanePoint, HeightRange> outline_ranges(const Sheets& sheets) {
  std::unordered_map<PlanePoint, HeightRange> ranges;
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

/// One a point of the plane; all heights where it is not on the outline.
std::vector<HeightRange> point_ranges(const Sheets& sheets, const OutlinePlane& plane) {
  const auto ranges = outline_ranges(sheets);
  std::vector<HeightRange> of_points;
  for (const PlanePoint column : plane.column_of) {
    const auto found = ranges.find(column);
    of_points.push_back(found == ranges.end() ? HeightRange{} : found->second);
  }
  return of_points;
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
std::vector<Cone> register_cones(const SurfaceWish& wish, const PartingSurface& surface) {
  constexpr double k_foot = 0.36, k_top = 0.16, k_smaller = 0.8, k_least_slope = 0.9;
  std::vector<Cone> cones;
  if (wish.cone_margin <= 0.0) return cones;
  const double m = wish.cone_margin;
  for (int k = 0; k < 4; ++k) {
    const double size = k == 0 ? k_smaller * m : m;
    const glm::dvec2 centre(k % 2 == 0 ? surface.low.x + 0.5 * m : surface.high.x - 0.5 * m,
                            k / 2 == 0 ? surface.low.y + 0.5 * m : surface.high.y - 0.5 * m);
    cones.push_back(
        {centre, k_foot * size, k_top * size, k_least_slope * wish.shape.slope * (k_foot - k_top) * size});
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

/// One a point; of one where regions touch, the first region's.
std::vector<double> heights_at(const PlaneMesh& mesh, const std::vector<ShelfField>& fields) {
  std::vector<double> z(mesh.points().size(), NAN);
  for (const PlaneMesh::Triangle& t : mesh.triangles()) {
    if (t.inside) continue;
    for (const std::uint32_t point : t.corners) {
      if (std::isnan(z[point])) z[point] = fields[t.region].at(mesh.points()[point]);
    }
  }
  return z;
}

/// What is level or a step beside the part stays so: where the outline forces some surface to be too steep,
/// no slope of what is around it mends that.
void hold_ground(const PlaneMesh& mesh, const std::vector<ShelfField>& fields, const std::vector<double>& z,
                 std::vector<HeightRange>& ranges) {
  constexpr double k_same_height = 1e-7;
  std::vector<std::uint8_t> leaves(z.size(), 0);
  for (const PlaneMesh::Triangle& t : mesh.triangles()) {
    if (t.inside) continue;
    for (const std::uint32_t point : t.corners) {
      if (std::abs(z[point] - fields[t.region].ground(mesh.points()[point])) > k_same_height)
        leaves[point] = 1;
    }
  }
  for (std::size_t point = 0; point < z.size(); ++point) {
    HeightRange& range = ranges[point];
    if (leaves[point] == 0 && std::isfinite(z[point]) && std::isinf(range.low) && std::isinf(range.high))
      range.low = range.high = z[point];
  }
}

/// Vertices of the sheet at the points, and its facets.
class SheetBuilder {
 public:
  SheetBuilder(Sheets& sheets, const OutlinePlane& plane, double tolerance)
      : sheets_(sheets), plane_(plane), tolerance_(tolerance) {
    for (const PlanePoint column : plane.column_of) {
      if (column != k_no_plane_point) standing_[column];
    }
    for (SheetVertex v = 0; v < sheets.vertices.size(); ++v) {
      if (const auto found = standing_.find(sheets.column_of[v]); found != standing_.end())
        found->second.push_back(v);
    }
  }

  /// `z`: one a point.
  void run(const std::vector<double>& z) {
    for (const PlaneMesh::Triangle& t : plane_.mesh.triangles()) {
      if (t.inside) continue;
      SheetFacet facet{{}, Sheet::parting};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [entry, fresh] = vertex_.try_emplace(t.corners[k], 0U);
        if (fresh) entry->second = vertex_at(t.corners[k], z[t.corners[k]]);
        facet.corners[k] = entry->second;
      }
      sheets_.facets.push_back(facet);
    }
  }

 private:
  SheetVertex vertex_at(std::uint32_t point, double z) {
    const PlanePoint column = plane_.column_of[point];
    if (column == k_no_plane_point) {
      sheets_.vertices.emplace_back(plane_.mesh.points()[point], z);
      sheets_.column_of.push_back(k_no_plane_point);
      return static_cast<SheetVertex>(sheets_.vertices.size() - 1);
    }
    std::optional<SheetVertex> nearest;
    for (const SheetVertex v : standing_[column]) {
      const double away = std::abs(sheets_.vertices[v].z - z);
      if (away <= tolerance_ && (!nearest || away < std::abs(sheets_.vertices[*nearest].z - z))) nearest = v;
    }
    return nearest ? *nearest : sheets_.add_vertex(column, z);
  }

  Sheets& sheets_;
  const OutlinePlane& plane_;
  double tolerance_;
  std::unordered_map<PlanePoint, std::vector<SheetVertex>> standing_;
  std::unordered_map<std::uint32_t, SheetVertex> vertex_;  // by point
};

/// Where edges over a segment change their order; edges of hidden surface and of what is seen do not meet in
/// one body, but a column too many does no harm.
std::vector<SegmentCut> find_crossings(Sheets& sheets, double tolerance) {
  std::vector<SheetEdge> edges;
  for (const Sheet sheet : {Sheet::upper, Sheet::lower, Sheet::hidden, Sheet::beside, Sheet::parting}) {
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

std::optional<MoldFault> add_parting_surface(Sheets& sheets, const SurfaceWish& wish, PartingSurface& surface,
                                             const Progress& progress) {
  const auto go_on = [&] { progress.report(k_halves_stage, 0.0); };
  surface.low = wish.low;
  surface.high = wish.high;
  const RimWishes wishes{wish.height, wish.walls, wish.line, wish.tolerance};
  OutlinePlane plane(surface.low, surface.high);
  if (auto fault = lay_outline(sheets, wish.tolerance, wish.height, plane)) return fault;
  RegionRims rims = outline_rims(sheets, plane);
  for (std::vector<RimSegment>& region : rims) keep_walls(wishes, region);
  std::vector<ShelfField> fields = shelf_fields(rims, wishes, wish.shape, progress);
  const LevelOutside level = level_outside(rims[0], fields[0]);
  if (wish.grows) {
    surface.low = on_grid(glm::min(wish.low, level.low));
    surface.high = on_grid(glm::max(wish.high, level.high));
  }
  if (surface.low != wish.low || surface.high != wish.high) {
    plane = OutlinePlane(surface.low, surface.high);
    if (auto fault = lay_outline(sheets, wish.tolerance, wish.height, plane)) return fault;
    rims = outline_rims(sheets, plane);
    for (std::vector<RimSegment>& region : rims) keep_walls(wishes, region);
    fields = shelf_fields(rims, wishes, wish.shape, progress);
  }
  go_on();
  const std::vector<Cone> cones = register_cones(wish, surface);
  add_circles(plane.mesh, cones);
  lay_shelf(sheets, fields, wish.tolerance, plane);
  go_on();
  plane.column_of.resize(plane.mesh.points().size(), k_no_plane_point);
  std::vector<HeightRange> ranges = point_ranges(sheets, plane);
  surface.forced = forced_slope(plane.mesh, ranges, wish.shape.slope);
  std::vector<double> z = heights_at(plane.mesh, fields);
  if (surface.forced.tangent > 0.0) hold_ground(plane.mesh, fields, z, ranges);
  keep_slope(plane.mesh, ranges, {wish.shape.slope, k_narrow, surface.forced.tangent > 0.0}, z);
  for (std::size_t point = 0; point < z.size(); ++point) {
    for (const Cone& cone : cones) z[point] -= cone.depth_at(plane.mesh.points()[point]);
  }
  SheetBuilder(sheets, plane, wish.tolerance).run(z);
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
