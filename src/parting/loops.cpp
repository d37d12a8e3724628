#include "parting/loops.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/symmetric_eigen.hpp"
#include "mesh/union_find.hpp"
#include "mold/map_frame.hpp"
#include "parting/line_smoothing.hpp"

namespace moldlight {

namespace {

constexpr double k_steep_sine = 0.9;

/// A loop as a walk over edges of the mesh.
struct Walk {
  std::vector<VertexIndex> vertices;
  std::vector<std::uint32_t> edges;  // edge k runs from vertex k
};

/// The borders of one side, each run through with that side on the left, turning inside it.
std::vector<Walk> walks_around(const Assignment& a, MoldSide side) {
  std::vector<std::uint8_t> used(3 * a.sides.size(), 0);
  const auto is_border = [&](PieceIndex piece, std::size_t k) {
    const PieceIndex across = a.edges.across(piece, k);
    return across == k_no_piece || a.sides[across] != side;
  };
  std::vector<Walk> walks;
  for (PieceIndex first = 0; first < a.sides.size(); ++first) {
    if (a.sides[first] != side) continue;
    for (std::size_t first_side = 0; first_side < 3; ++first_side) {
      if (used[3 * first + first_side] != 0 || !is_border(first, first_side)) continue;
      Walk walk;
      PieceIndex piece = first;
      std::size_t k = first_side;
      while (used[3 * piece + k] == 0) {
        used[3 * piece + k] = 1;
        walk.vertices.push_back(a.mesh.pieces[piece].corners[k]);
        walk.edges.push_back(a.edges.of_piece[piece][k]);
        k = (k + 1) % 3;
        while (!is_border(piece, k)) {
          const PieceIndex across = a.edges.across(piece, k);
          const std::size_t across_side = a.edges.side_across(piece, k);
          piece = across;
          k = (across_side + 1) % 3;
        }
      }
      walks.push_back(std::move(walk));
    }
  }
  return walks;
}

/// Sets of pieces joined across edges that `joins` lets through.
template <typename Joins>
UnionFind pieces_joined(const Assignment& a, const Joins& joins) {
  UnionFind sets(a.sides.size());
  for (const PieceEdge& edge : a.edges.edges) {
    if (edge.right != k_no_piece && joins(edge)) sets.join(edge.left, edge.right);
  }
  return sets;
}

/// Corners (3 piece + k) joined around their vertex across edges that `joins` lets through.
template <typename Joins>
UnionFind corners_joined(const Assignment& a, const Joins& joins) {
  UnionFind sets(3 * a.sides.size());
  for (const PieceEdge& edge : a.edges.edges) {
    if (edge.right == k_no_piece || !joins(edge)) continue;
    const std::uint32_t left = 3 * edge.left, right = 3 * edge.right;
    sets.join(left + edge.left_side, right + (edge.right_side + 1U) % 3U);
    sets.join(left + (edge.left_side + 1U) % 3U, right + edge.right_side);
  }
  return sets;
}

EulerCheck euler_check(const Assignment& a) {
  EulerCheck check;
  const auto within = [&](const PieceEdge& edge) { return a.sides[edge.left] == a.sides[edge.right]; };
  const auto any = [](const PieceEdge&) { return true; };
  UnionFind of_side = corners_joined(a, within), of_part = corners_joined(a, any);
  std::array<std::int64_t, k_side_count> characteristic{};
  std::vector<std::uint8_t> on_border(3 * a.sides.size(), 0);
  std::int64_t border_edges = 0;
  for (const PieceEdge& edge : a.edges.edges) {
    --check.part;
    --characteristic[static_cast<std::size_t>(a.sides[edge.left])];
    if (edge.right == k_no_piece || within(edge)) continue;
    --characteristic[static_cast<std::size_t>(a.sides[edge.right])];
    ++border_edges;
    const std::uint32_t corner = 3 * edge.left;
    on_border[of_part.find(corner + edge.left_side)] = 1;
    on_border[of_part.find(corner + (edge.left_side + 1U) % 3U)] = 1;
  }
  std::int64_t border_vertices = 0;
  for (std::uint32_t corner = 0; corner < 3 * a.sides.size(); ++corner) {
    const auto side = static_cast<std::size_t>(a.sides[corner / 3]);
    if (of_side.find(corner) == corner) ++characteristic[side];
    if (of_part.find(corner) == corner) ++check.part;
    border_vertices += on_border[corner];
  }
  for (PieceIndex piece = 0; piece < a.sides.size(); ++piece) {
    ++characteristic[static_cast<std::size_t>(a.sides[piece])];
    ++check.part;
  }
  check.core = characteristic[0];
  check.cavity = characteristic[1];
  check.action = characteristic[2];
  check.touching = border_edges - border_vertices;
  UnionFind bodies = pieces_joined(a, any), sides = pieces_joined(a, within);
  for (PieceIndex piece = 0; piece < a.sides.size(); ++piece) {
    check.bodies += bodies.find(piece) == piece ? 1 : 0;
    if (sides.find(piece) != piece) continue;
    check.core_pieces += a.sides[piece] == MoldSide::core ? 1 : 0;
    check.cavity_pieces += a.sides[piece] == MoldSide::cavity ? 1 : 0;
    check.action_pieces += a.sides[piece] == MoldSide::action ? 1 : 0;
  }
  check.genus = static_cast<std::int64_t>(check.bodies) - check.part / 2;
  check.expected_loops = static_cast<std::size_t>(
      std::max<std::int64_t>(0, check.genus + static_cast<std::int64_t>(check.bodies)));
  return check;
}

void measure_corners(const std::vector<glm::dvec3>& points, PartingLoop& loop) {
  // Edges of rounding length have no direction.
  std::vector<glm::dvec3> kept;
  for (const glm::dvec3& point : points) {
    if (kept.empty() || glm::distance(kept.back(), point) > 1e-6 * loop.length) kept.push_back(point);
  }
  while (kept.size() > 1 && glm::distance(kept.back(), kept.front()) <= 1e-6 * loop.length) kept.pop_back();
  if (kept.size() < 3) return;
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const glm::dvec3 &before = kept[k == 0 ? kept.size() - 1 : k - 1], &at = kept[k],
                     &after = kept[(k + 1) % kept.size()];
    const double cosine = glm::dot(glm::normalize(before - at), glm::normalize(after - at));
    loop.sharpest_deg = std::min(loop.sharpest_deg, glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0))));
  }
}

/// Greatest distance from the plane through the centre of the edges, across the least of their moments.
double flatness_of(const std::vector<glm::dvec3>& points, double length) {
  if (length <= 0.0) return 0.0;
  glm::dvec3 centre(0.0);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const glm::dvec3& next = points[(k + 1) % points.size()];
    centre += glm::distance(points[k], next) * 0.5 * (points[k] + next);
  }
  centre /= length;
  glm::dmat3 moments(0.0);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const glm::dvec3 &a = points[k], &b = points[(k + 1) % points.size()];
    for (const glm::dvec3& p : {a - centre, b - centre, 0.5 * (a + b) - centre})
      moments += glm::distance(a, b) * glm::outerProduct(p, p);
  }
  const glm::dvec3 normal = symmetric_eigen<3>(moments).vectors[0];
  double greatest = 0.0;
  for (const glm::dvec3& point : points)
    greatest = std::max(greatest, std::abs(glm::dot(point - centre, normal)));
  return greatest;
}

/// Draft of a piece, either way, in degrees.
double draft_deg(const Assignment& a, PieceIndex piece) {
  const glm::dvec3 normal = twice_piece_area(a.mesh, piece);
  const double size = glm::length(normal);
  if (size <= 0.0) return 0.0;
  return glm::degrees(std::asin(std::min(1.0, std::abs(glm::dot(normal, a.direction)) / size)));
}

/// Points of the walk, and what smoothing does to them.
void smooth(const Assignment& a, const LineSmoother& smoother, const Walk& walk, PartingLoop& loop) {
  loop.points = smoother.smoothed({walk.vertices, walk.edges});
  const auto moved = [&](std::size_t k) { return loop.points[k] != a.mesh.vertices[walk.vertices[k]]; };
  for (std::size_t k = 0; k < loop.points.size(); ++k) {
    const std::size_t next = (k + 1) % loop.points.size();
    loop.moved += moved(k) ? 1 : 0;
    if (!moved(k) && !moved(next)) continue;
    const glm::dvec3 before = a.mesh.vertices[walk.vertices[next]] - a.mesh.vertices[walk.vertices[k]],
                     after = loop.points[next] - loop.points[k];
    loop.smoothed_length += glm::length(before) - glm::length(after);
    loop.smoothed_climb += std::abs(glm::dot(before, a.direction)) - std::abs(glm::dot(after, a.direction));
  }
}

PartingLoop measured(const Assignment& a, const LineSmoother& smoother, Walk walk, MoldSide side) {
  const glm::dvec3& d = a.direction;
  const MapFrame frame = map_frame(d);
  PartingLoop loop;
  smooth(a, smoother, walk, loop);
  const std::vector<glm::dvec3>& points = loop.points;
  std::vector<std::uint8_t> breaks;
  for (const std::size_t of_edge : walk.edges) {
    const PieceEdge& edge = a.edges.edges[of_edge];
    const bool open = edge.right == k_no_piece;
    const MoldSide left = a.sides[edge.left], other = open           ? MoldSide::action
                                                      : left == side ? a.sides[edge.right]
                                                                     : left;
    breaks.push_back(side != MoldSide::action && other == MoldSide::action ? 1 : 0);
  }
  if (std::ranges::find(breaks, 0) == breaks.end()) {
    loop.kind = LoopKind::action;
    std::ranges::fill(breaks, std::uint8_t{0});
  }
  loop.low = INFINITY;
  loop.high = -INFINITY;
  double crease = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const glm::dvec3 &from = points[k], &to = points[(k + 1) % points.size()];
    const double length = glm::distance(from, to), climb = std::abs(glm::dot(to - from, d));
    const PieceEdge& edge = a.edges.edges[walk.edges[k]];
    loop.length += length;
    if (a.crease[walk.edges[k]] != 0) crease += length;
    const glm::dvec3 across = from - points[0], next = to - points[0];
    loop.area += 0.5 * (glm::dot(across, frame.x) * glm::dot(next, frame.y) -
                        glm::dot(across, frame.y) * glm::dot(next, frame.x));
    if (breaks[k] != 0) {
      loop.break_length += length;
      if (breaks[(k + 1) % breaks.size()] == 0) ++loop.breaks;
      continue;
    }
    for (const glm::dvec3& end : {from, to}) {
      loop.low = std::min(loop.low, glm::dot(end, d));
      loop.high = std::max(loop.high, glm::dot(end, d));
    }
    loop.up_and_down += climb;
    if (climb > k_steep_sine * length) {
      loop.steep_length += length;
      loop.steep_draft_deg = std::max(loop.steep_draft_deg, draft_deg(a, edge.left));
      if (edge.right != k_no_piece)
        loop.steep_draft_deg = std::max(loop.steep_draft_deg, draft_deg(a, edge.right));
    }
    if (length > 0.0)
      loop.steepest_deg = std::max(loop.steepest_deg, glm::degrees(std::asin(std::min(1.0, climb / length))));
  }
  loop.on_crease = loop.length > 0.0 ? crease / loop.length : 0.0;
  loop.flatness = flatness_of(points, loop.length);
  measure_corners(points, loop);
  loop.vertices = std::move(walk.vertices);
  return loop;
}

}  // namespace

std::int64_t EulerCheck::twice_handles(MoldSide side) const {
  const std::size_t pieces = side == MoldSide::core     ? core_pieces
                             : side == MoldSide::cavity ? cavity_pieces
                                                        : action_pieces;
  const std::int64_t characteristic = side == MoldSide::core     ? core
                                      : side == MoldSide::cavity ? cavity
                                                                 : action;
  return 2 * static_cast<std::int64_t>(pieces) - characteristic - borders[static_cast<std::size_t>(side)];
}

bool EulerCheck::accounted() const {
  std::int64_t around = 0, twice = 0;
  for (const MoldSide side : k_mold_sides) {
    const std::int64_t handles = twice_handles(side);
    if (handles < 0 || handles % 2 != 0) return false;
    twice += handles;
    around += borders[static_cast<std::size_t>(side)];
  }
  const auto whole = [](std::size_t count) { return static_cast<std::int64_t>(count); };
  const std::int64_t more = whole(core_pieces + cavity_pieces + action_pieces) - 2 * whole(bodies);
  return around == 2 * (genus + whole(bodies)) + 2 * more - twice - touching;
}

std::string_view loop_name(LoopKind kind) {
  switch (kind) {
    case LoopKind::outer:
      return "outer";
    case LoopKind::shut_off:
      return "shut-off";
    case LoopKind::action:
      break;
  }
  return "action";
}

bool is_tiny(const PartingLoop& loop, double lateral_tolerance) {
  constexpr double k_short = 8.0;  // tolerances
  return loop.length <= std::numbers::pi * lateral_tolerance ||
         (loop.length <= k_short * lateral_tolerance && loop.climb() <= lateral_tolerance &&
          std::abs(loop.area) <= lateral_tolerance * lateral_tolerance);
}

PartingLine parting_line(const Assignment& a) {
  PartingLine line;
  line.euler = euler_check(a);
  const LineSmoother smoother(a);
  UnionFind bodies = pieces_joined(a, [](const PieceEdge&) { return true; });
  std::map<std::uint32_t, std::uint32_t> body_numbers;
  const auto add = [&](MoldSide side, bool actions_only) {
    for (Walk& walk : walks_around(a, side)) {
      ++line.euler.borders[static_cast<std::size_t>(side)];
      const std::uint32_t root = bodies.find(a.edges.edges[walk.edges.front()].left);
      PartingLoop loop = measured(a, smoother, std::move(walk), side);
      if (actions_only && loop.kind != LoopKind::action) continue;
      loop.body =
          body_numbers.try_emplace(root, static_cast<std::uint32_t>(body_numbers.size())).first->second;
      line.loops.push_back(std::move(loop));
    }
  };
  add(MoldSide::core, false);
  add(MoldSide::cavity, true);
  line.euler.borders[static_cast<std::size_t>(MoldSide::action)] =
      static_cast<std::int64_t>(walks_around(a, MoldSide::action).size());
  std::map<std::uint32_t, PartingLoop*> outer;
  for (PartingLoop& loop : line.loops) {
    if (loop.kind == LoopKind::action) continue;
    loop.kind = LoopKind::shut_off;
    PartingLoop*& greatest = outer[loop.body];
    if (greatest == nullptr || std::abs(loop.area) > std::abs(greatest->area)) greatest = &loop;
  }
  for (const auto& [body, loop] : outer) loop->kind = LoopKind::outer;
  for (PartingLoop& loop : line.loops) loop.tiny = is_tiny(loop, a.lateral);
  std::ranges::stable_sort(line.loops, [](const PartingLoop& x, const PartingLoop& y) {
    return x.kind != y.kind ? x.kind < y.kind : x.length > y.length;
  });
  line.low = line.outer_low = INFINITY;
  line.high = line.outer_high = -INFINITY;
  for (const PartingLoop& loop : line.loops) {
    if (loop.kind == LoopKind::action) continue;
    ++line.euler.loops;
    line.length += loop.length;
    line.smoothed_length += loop.smoothed_length;
    line.smoothed_climb += loop.smoothed_climb;
    line.low = std::min(line.low, loop.low);
    line.high = std::max(line.high, loop.high);
    if (loop.kind != LoopKind::outer) continue;
    line.outer_low = std::min(line.outer_low, loop.low);
    line.outer_high = std::max(line.outer_high, loop.high);
  }
  if (line.euler.loops == 0) line.low = line.high = line.outer_low = line.outer_high = 0.0;
  return line;
}

}  // namespace moldlight
