#include "parting/part_sheets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtx/exterior_product.hpp>

#include "mesh/union_find.hpp"

namespace moldlight {

namespace {

/// Least height of the triangle as seen along z.
double seen_width(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec2 p(b - a), q(c - a), r(c - b);
  const double longest = std::sqrt(std::max({glm::dot(p, p), glm::dot(q, q), glm::dot(r, r)}));
  return longest > 0.0 ? std::abs(p.x * q.y - p.y * q.x) / longest : 0.0;
}

bool is_upright(const SplitPiece& piece, const Sheets& sheets, const SheetTolerance& attempt) {
  return seen_width(sheets.vertices[piece.corners[0]], sheets.vertices[piece.corners[1]],
                    sheets.vertices[piece.corners[2]]) < std::max(attempt.upright * attempt.tolerance, 1e-14);
}

Sheet sheet_of(const SplitPiece& piece, const Sheets& sheets) {
  const glm::dvec3 &a = sheets.vertices[piece.corners[0]], &b = sheets.vertices[piece.corners[1]],
                   &c = sheets.vertices[piece.corners[2]];
  const bool up = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0.0;
  return piece.region == Region::core && up      ? Sheet::upper
         : piece.region == Region::cavity && !up ? Sheet::lower
                                                 : Sheet::hidden;
}

/// Facets lean by rounding where they are less wide than this as seen along the direction, in diagonals of
/// the part, and edges and facets less than this from upright, as a tangent. The wider one of what is
/// upright.
constexpr double k_widest = 1e-5, k_most_lean = 2e-3, k_upright = 1e-10;
constexpr double k_farthest = 2.0 * k_widest;
constexpr int k_most_rounds = 200;

class Straightener {
 public:
  Straightener(const TriangleMesh& mesh, const SheetFrame& frame)
      : mesh_(mesh), frame_(frame), columns_(mesh.vertices.size()) {
    for (const glm::dvec3& vertex : mesh.vertices) at_.push_back(frame.in_mold(vertex));
  }

  std::optional<TriangleMesh> run() {
    if (!find_walls()) return std::nullopt;
    do {
      stand_edges();
      for (int round = 0; round < k_most_rounds && flatten() > 0.01 * k_upright; ++round) {
      }
    } while (leave_far());
    TriangleMesh moved = mesh_;
    for (std::uint32_t v = 0; v < at_.size(); ++v) {
      if (const glm::dvec2 way = way_of(v); way != glm::dvec2(0.0))
        moved.vertices[v] += frame_.diagonal * frame_.frame.to_part(glm::dvec3(way, 0.0));
    }
    return moved;
  }

 private:
  using Corners = std::array<std::uint32_t, 3>;

  /// Whether any of them leans.
  bool find_walls() {
    bool any = false;
    for (FacetIndex facet = 0; facet < mesh_.facets.size(); ++facet) {
      Corners corners{};
      for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh_.facets[facet][k];
      const glm::dvec3 normal =
          glm::cross(at_[corners[1]] - at_[corners[0]], at_[corners[2]] - at_[corners[0]]);
      double longest = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
        longest = std::max(longest,
                           glm::distance(glm::dvec2(at_[corners[k]]), glm::dvec2(at_[corners[(k + 1) % 3]])));
      const double width = longest > 0.0 ? std::abs(normal.z) / longest : 0.0;
      if (width > k_widest || std::abs(normal.z) > k_most_lean * glm::length(normal)) continue;
      walls_.push_back(corners);
      any = any || width > k_upright;
    }
    return any;
  }

  [[nodiscard]] glm::dvec2 way_of(std::uint32_t v) { return place_[columns_.find(v)] - glm::dvec2(at_[v]); }

  /// Walls with corners that moved too far stay as they are; whether there were some.
  bool leave_far() {
    std::vector<char> far(at_.size(), 0);
    for (std::uint32_t v = 0; v < at_.size(); ++v) {
      if (glm::length(way_of(v)) > k_farthest) far[columns_.find(v)] = 1;
    }
    return std::erase_if(walls_, [&](const Corners& wall) {
             return std::ranges::any_of(wall, [&](std::uint32_t v) { return far[columns_.find(v)] != 0; });
           }) > 0;
  }

  /// Ends of edges of walls that are upright but for rounding stand above each other, in their middle.
  void stand_edges() {
    columns_ = UnionFind(at_.size());
    place_.clear();
    for (const glm::dvec3& at : at_) place_.emplace_back(at);
    for (const Corners& wall : walls_) {
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 way = at_[wall[(k + 1) % 3]] - at_[wall[k]];
        const double lean = glm::length(glm::dvec2(way));
        if (lean <= k_widest && lean <= k_most_lean * std::abs(way.z))
          columns_.join(wall[k], wall[(k + 1) % 3]);
      }
    }
    std::vector<double> members(at_.size(), 0.0);
    std::vector<glm::dvec2> sums(at_.size(), glm::dvec2(0.0));
    for (std::uint32_t v = 0; v < at_.size(); ++v) {
      const std::uint32_t column = columns_.find(v);
      sums[column] += glm::dvec2(at_[v]);
      ++members[column];
    }
    for (std::uint32_t v = 0; v < at_.size(); ++v) {
      if (members[v] > 1.0) place_[v] = sums[v] / members[v];
    }
  }

  /// Moves the corners of each wall as little as puts them in one line, as seen along the direction; returns
  /// how far the worst one was from it.
  double flatten() {
    double worst = 0.0;
    for (const Corners& wall : walls_) {
      Corners c{};
      for (std::size_t k = 0; k < 3; ++k) c[k] = columns_.find(wall[k]);
      if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
      // The longest side, and what is beside it.
      for (int turn = 0; turn < 2; ++turn) {
        if (glm::distance(place_[c[0]], place_[c[1]]) >=
            std::max(glm::distance(place_[c[1]], place_[c[2]]), glm::distance(place_[c[2]], place_[c[0]])))
          break;
        std::rotate(c.begin(), c.begin() + 1, c.end());
      }
      const glm::dvec2 along = place_[c[1]] - place_[c[0]], away = place_[c[2]] - place_[c[0]];
      const double length = glm::length(along);
      if (length <= 0.0) continue;
      const double off = glm::cross(along, away) / length;
      worst = std::max(worst, std::abs(off));
      const double share = std::clamp(glm::dot(away, along) / (length * length), 0.0, 1.0);
      const glm::dvec2 step = off / (1.0 + share * share + (1.0 - share) * (1.0 - share)) *
                              glm::dvec2(-along.y, along.x) / length;
      place_[c[2]] -= step;
      place_[c[0]] += (1.0 - share) * step;
      place_[c[1]] += share * step;
    }
    return worst;
  }

  const TriangleMesh& mesh_;
  const SheetFrame& frame_;
  std::vector<glm::dvec3> at_;
  std::vector<glm::dvec2> place_;  // of columns
  UnionFind columns_;
  std::vector<Corners> walls_;
};

}  // namespace

PartSheets part_sheets(const SplitMesh& split, FacetIndex beside, const SheetFrame& frame,
                       const SheetTolerance& attempt, const WallCaps* caps) {
  PartSheets found;
  Sheets& sheets = found.sheets;
  for (const glm::dvec3& vertex : split.vertices) sheets.vertices.push_back(frame.in_mold(vertex));
  std::map<std::pair<VertexIndex, double>, SheetVertex> ends;
  const auto end_at = [&](VertexIndex vertex, double height) {
    const auto [entry, is_new] =
        ends.try_emplace({vertex, height}, static_cast<SheetVertex>(sheets.vertices.size()));
    if (is_new) sheets.vertices.emplace_back(glm::dvec2(sheets.vertices[vertex]), height);
    return entry->second;
  };
  for (const SplitPiece& piece : split.pieces) {
    if (is_upright(piece, sheets, attempt)) continue;
    const Sheet sheet = sheet_of(piece, sheets);
    const auto& [a, b, c] = piece.corners;
    const std::array<glm::dvec3, 3> at = {sheets.vertices[a], sheets.vertices[b], sheets.vertices[c]};
    const bool is_part = piece.facet < beside;
    if (const auto end = is_part && caps != nullptr ? caps->height(piece.facet, sheet, at) : std::nullopt) {
      const double area = 0.5 * std::abs(glm::cross(glm::dvec2(at[1] - at[0]), glm::dvec2(at[2] - at[0])));
      found.added += area * std::abs((at[0].z + at[1].z + at[2].z) / 3.0 - *end);
      sheets.facets.push_back({{end_at(a, *end), end_at(b, *end), end_at(c, *end)}, sheet});
      continue;
    }
    if (is_part || sheet != Sheet::hidden) sheets.facets.push_back({piece.corners, sheet});
    if (!is_part && sheet != Sheet::hidden) sheets.facets.push_back({piece.corners, Sheet::beside});
  }
  sheets.column_of.assign(sheets.vertices.size(), k_no_plane_point);
  return found;
}

HandWalls hand_walls(const SplitMesh& split, const Sheets& sheets, const std::vector<FacetWish>& assigned,
                     const SheetTolerance& attempt) {
  HandWalls found;
  double most = 0.0;
  for (const SplitPiece& piece : split.pieces) {
    if (piece.facet >= assigned.size() || assigned[piece.facet] == FacetWish::none) continue;
    const bool core = assigned[piece.facet] == FacetWish::core;
    const glm::dvec3 &a = sheets.vertices[piece.corners[0]], &b = sheets.vertices[piece.corners[1]],
                     &c = sheets.vertices[piece.corners[2]];
    const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
    found.assigned_area += area;
    if (is_upright(piece, sheets, attempt)) {
      found.walls.push_back({{a, b, c}, core});
      found.released.push_back(piece.region == Region::both ||
                               piece.region == (core ? Region::core : Region::cavity));
      continue;
    }
    if (sheet_of(piece, sheets) == (core ? Sheet::upper : Sheet::lower)) continue;
    found.leaning_area += area;
    if (area <= most) continue;
    most = area;
    found.leaning_at = (a + b + c) / 3.0;
  }
  return found;
}

std::optional<MoldFault> residual(const Sheets& sheets, double diagonal) {
  double length = 0.0, longest = 0.0;
  glm::dvec3 place(0.0);
  for (const SegmentEdges& segment :
       sheets.by_segment(sheets.ends(Sheets::bit(Sheet::upper) | Sheets::bit(Sheet::lower)))) {
    int sum = 0;
    for (const SegmentEdge& edge : segment.edges) sum += edge.sign;
    if (sum == 0) continue;
    const double run = glm::distance(sheets.columns[segment.a], sheets.columns[segment.b]);
    length += run;
    if (run <= longest) continue;
    longest = run;
    place = 0.5 * (sheets.vertices[segment.edges[0].a] + sheets.vertices[segment.edges[0].b]);
  }
  if (length <= 0.0) return std::nullopt;
  return MoldFault{fmt::format("the outline from above and the outline from below differ over {:.3g} of "
                               "their length: bodies overlap or touch there, or the surface is folded",
                               length * diagonal),
                   k_mend_surface, place};
}

std::optional<TriangleMesh> with_upright_walls(const TriangleMesh& mesh, const SheetFrame& frame) {
  return Straightener(mesh, frame).run();
}

}  // namespace moldlight
