#include "parting/hull/parting_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <queue>
#include <tuple>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "parting/hull/plane_mesh.hpp"

namespace moldlight {

namespace {

constexpr int k_most_rounds = 8;
/// Of the edges over one segment each is compared with so many that follow by height.
constexpr std::size_t k_most_compared = 64;
constexpr double k_least_segment = 4e-3;  // of the part's diagonal: shorter ones are not halved
/// Slopes tried for the edges, as shares of the greatest allowed: facets are steeper than their edges.
constexpr double k_slope_shares[] = {1.0, 0.85, 0.7, 0.55, 0.4};

struct Outline {
  std::vector<std::array<Column, 2>> segments;
};

/// The segments at which the upper sheet ends as a whole.
std::optional<MoldFault> find_outline(const Sheets& sheets, Outline& outline) {
  for (const SegmentEdges& segment : sheets.by_segment(sheets.ends(Sheets::bit(Sheet::upper)))) {
    int sum = 0;
    for (const SegmentEdge& edge : segment.edges) sum += edge.sign;
    if (sum == 0) continue;
    if (std::abs(sum) > 1)
      return MoldFault{"what is seen from above lies over itself", k_mend_surface,
                       sheets.vertices[segment.edges.front().a]};
    outline.segments.push_back({segment.a, segment.b});
  }
  if (outline.segments.empty())
    return MoldFault{"the part is too thin to be seen along the direction, so that it has no outline",
                     "choose a direction across the part's faces, not along them"};
  return std::nullopt;
}

/// The plane mesh with the outline's points and segments; columns by point.
struct Plane {
  PlaneMesh mesh;
  std::vector<Column> column_of;  // of each point; k_no_column: none
};

/// Cuts where a point or a segment stands in the way of another; empty where the mesh was made.
std::vector<SegmentCut> triangulate(Sheets& sheets, const Outline& outline, Plane& plane) {
  std::unordered_map<Column, std::uint32_t> point_of;
  const auto point = [&](Column column) {
    const auto [entry, fresh] = point_of.try_emplace(column, 0);
    if (fresh) {
      entry->second = plane.mesh.add_point(sheets.columns[column]);
      plane.column_of.resize(plane.mesh.points().size(), k_no_column);
      plane.column_of[entry->second] = column;
    }
    return entry->second;
  };
  // Neighbours one after the other, so that each is found near the last.
  std::vector<std::array<Column, 2>> segments = outline.segments;
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
      const Column c = plane.column_of[obstacle->segment[0]], d = plane.column_of[obstacle->segment[1]];
      if (c == k_no_column || d == k_no_column) continue;
      const glm::dvec2 &pa = sheets.columns[a], &pb = sheets.columns[b], &pc = sheets.columns[c],
                       &pd = sheets.columns[d];
      const glm::dvec2 r = pb - pa, s = pd - pc;
      const double t = ((pc.x - pa.x) * s.y - (pc.y - pa.y) * s.x) / (r.x * s.y - r.y * s.x);
      const Column at = sheets.add_column(pa + t * r);
      cuts.push_back({a, b, at});
      cuts.push_back({c, d, at});
    }
  }
  return cuts;
}

struct HeightRange {
  double low = -INFINITY, high = INFINITY;
};

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

/// For every point the least of `from` + `slope` times the way along edges outside.
std::vector<double> spread(const PlaneMesh& mesh, const std::vector<std::vector<std::uint32_t>>& around,
                           std::vector<double> value, double slope) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::uint32_t k = 0; k < value.size(); ++k) {
    if (std::isfinite(value[k])) queue.emplace(value[k], k);
  }
  while (!queue.empty()) {
    const auto [at, point] = queue.top();
    queue.pop();
    if (at > value[point]) continue;
    for (const std::uint32_t other : around[point]) {
      const double reached = at + slope * glm::distance(mesh.points()[point], mesh.points()[other]);
      if (reached >= value[other]) continue;
      value[other] = reached;
      queue.emplace(reached, other);
    }
  }
  return value;
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

/// Area of the facets outside that are steeper than the tangent, and the heights that give it.
struct Heights {
  std::vector<double> z;
  double too_steep = INFINITY;
};

Heights heights_at(const PlaneMesh& mesh, const std::vector<std::vector<std::uint32_t>>& around,
                   const std::vector<HeightRange>& ranges, const SurfaceWish& wish, double share) {
  std::vector<double> from_low, from_high;
  for (const HeightRange& range : ranges) {
    from_low.push_back(-range.low);
    from_high.push_back(range.high);
  }
  const double slope = share * wish.slope;
  const std::vector<double> low = spread(mesh, around, std::move(from_low), slope),
                            high = spread(mesh, around, std::move(from_high), slope);
  Heights heights{.z = std::vector<double>(low.size()), .too_steep = 0.0};
  for (std::size_t k = 0; k < low.size(); ++k) {
    const double least = -low[k], greatest = high[k];
    heights.z[k] = least <= greatest ? std::clamp(wish.height, least, greatest) : 0.5 * (least + greatest);
  }
  for (const PlaneMesh::Triangle& t : mesh.triangles()) {
    if (t.inside) continue;
    const auto corner = [&](std::size_t k) {
      return glm::dvec3(mesh.points()[t.corners[k]], heights.z[t.corners[k]]);
    };
    const glm::dvec3 normal = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
    if (glm::length(glm::dvec2(normal)) > 1.000001 * wish.slope * normal.z)
      heights.too_steep += 0.5 * glm::length(normal);
  }
  return heights;
}

/// Vertices of the sheet at the points, and its facets.
void add_sheet(Sheets& sheets, const Plane& plane, const std::vector<double>& z, double tolerance) {
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

void cut_segments(Sheets& sheets, std::vector<SegmentCut> cuts) {
  std::unordered_map<std::uint64_t, std::vector<Column>> on_segment;
  for (const SegmentCut& cut : cuts) on_segment[Sheets::edge_key(cut.a, cut.b)].push_back(cut.at);
  Sheets::OnEdges on_edges;
  for (const Sheet sheet : {Sheet::upper, Sheet::lower, Sheet::hidden, Sheet::parting}) {
    for (const SheetEdge& edge : sheets.ends(Sheets::bit(sheet))) {
      const auto [low, high] = std::minmax(edge.from, edge.to);
      const auto found = on_segment.find(Sheets::edge_key(sheets.column_of[low], sheets.column_of[high]));
      if (sheets.column_of[low] == k_no_column || sheets.column_of[high] == k_no_column ||
          found == on_segment.end() || on_edges.contains(Sheets::edge_key(low, high)))
        continue;
      const glm::dvec2 a(sheets.vertices[low]), b(sheets.vertices[high]);
      std::vector<std::pair<double, Column>> places;
      for (const Column column : found->second)
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

std::optional<MoldFault> add_parting_surface(Sheets& sheets, const SurfaceWish& wish) {
  std::optional<Plane> plane;
  for (int round = 0;; ++round) {
    Outline outline;
    if (const auto fault = find_outline(sheets, outline)) return fault;
    plane.emplace(Plane{.mesh = PlaneMesh(wish.low, wish.high), .column_of = {}});
    plane->column_of.resize(4, k_no_column);
    std::vector<SegmentCut> cuts = triangulate(sheets, outline, *plane);
    if (cuts.empty()) break;
    if (round == k_most_rounds) {
      const glm::dvec2& at = sheets.columns[cuts.front().at];
      return MoldFault{"the outline crosses itself", k_mend_surface, glm::dvec3(at, wish.height)};
    }
    cut_segments(sheets, std::move(cuts));
    sheets.weld_columns(wish.tolerance);
  }
  PlaneMesh& mesh = plane->mesh;
  const std::vector<Cone> cones = register_cones(wish);
  add_circles(mesh, cones);
  mesh.find_inside();
  const std::size_t before = mesh.points().size();
  mesh.refine({.least_angle_deg = 20.0, .least_segment = k_least_segment, .most_points = 2000 + 12 * before});

  // Halves of the outline's segments are columns, too.
  std::vector<SegmentCut> cuts;
  plane->column_of.resize(mesh.points().size(), k_no_column);
  std::vector<std::vector<std::uint32_t>> around(mesh.points().size());
  std::map<std::array<std::uint32_t, 2>, bool> outline_sides;
  for (const PlaneMesh::Triangle& t : mesh.triangles()) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t.corners[k], b = t.corners[(k + 1) % 3];
      if (!t.inside) {
        around[a].push_back(b);
        around[b].push_back(a);
      }
      if (t.fixed[k] == PlaneMesh::k_outline) outline_sides[{std::min(a, b), std::max(a, b)}] = true;
    }
  }
  {
    // Chains of new points between two that had a column.
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> next;
    for (const auto& [ends, unused] : outline_sides) {
      for (const auto& [from, to] : {std::pair{ends[0], ends[1]}, std::pair{ends[1], ends[0]}}) {
        if (from >= before || to >= before) next[from].push_back(to);
      }
    }
    for (const auto& [ends, unused] : outline_sides) {
      for (auto [from, to] : {std::pair{ends[0], ends[1]}, std::pair{ends[1], ends[0]}}) {
        if (from >= before || to < before) continue;
        const Column first = plane->column_of[from];
        std::vector<std::uint32_t> chain;
        while (to >= before) {
          chain.push_back(to);
          const auto& ways = next.at(to);
          const std::uint32_t onward = ways[0] == from ? ways[1] : ways[0];
          from = to;
          to = onward;
        }
        const Column last = plane->column_of[to];
        if (first > last) continue;  // it comes from the other end, too
        for (const std::uint32_t point : chain) {
          plane->column_of[point] = sheets.add_column(mesh.points()[point]);
          cuts.push_back({first, last, plane->column_of[point]});
        }
      }
    }
  }
  if (!cuts.empty()) {
    cut_segments(sheets, std::move(cuts));
    sheets.weld_columns(wish.tolerance);
  }

  const auto ranges_by_column = outline_ranges(sheets);
  std::vector<HeightRange> ranges(mesh.points().size());
  for (std::uint32_t point = 0; point < ranges.size(); ++point) {
    if (plane->column_of[point] == k_no_column) continue;
    const auto found = ranges_by_column.find(plane->column_of[point]);
    if (found != ranges_by_column.end()) ranges[point] = found->second;
  }
  for (HeightRange& range : ranges) {
    if (!std::isfinite(range.low)) range.low = -INFINITY;
  }
  Heights best;
  for (const double share : k_slope_shares) {
    Heights heights = heights_at(mesh, around, ranges, wish, share);
    if (heights.too_steep < best.too_steep) best = std::move(heights);
    if (best.too_steep <= 0.0) break;
  }
  for (std::size_t point = 0; point < best.z.size(); ++point) {
    for (const Cone& cone : cones) best.z[point] -= cone.depth_at(mesh.points()[point]);
  }
  add_sheet(sheets, *plane, best.z, wish.tolerance);
  for (int round = 0; round < k_most_rounds; ++round) {
    std::vector<SegmentCut> crossings = find_crossings(sheets, wish.tolerance);
    if (crossings.empty()) break;
    cut_segments(sheets, std::move(crossings));
    sheets.weld_columns(wish.tolerance);
  }
  return std::nullopt;
}

}  // namespace moldlight
