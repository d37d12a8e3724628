#include "parting/part_sheets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtx/exterior_product.hpp>

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

}  // namespace

PartSheets part_sheets(const SplitMesh& split, FacetIndex beside, const SheetFrame& frame,
                       const SheetTolerance& attempt, const SheetCaps& caps) {
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
    if (const auto end =
            is_part && caps.walls != nullptr ? caps.walls->height(piece.facet, sheet, at) : std::nullopt) {
      const double area = 0.5 * std::abs(glm::cross(glm::dvec2(at[1] - at[0]), glm::dvec2(at[2] - at[0])));
      found.added += area * std::abs((at[0].z + at[1].z + at[2].z) / 3.0 - *end);
      sheets.facets.push_back({{end_at(a, *end), end_at(b, *end), end_at(c, *end)}, sheet});
      continue;
    }
    if (is_part && caps.through != nullptr && sheet != Sheet::hidden) {
      if (const auto over = caps.through->heights(sheet, at)) {
        const std::array<SheetVertex, 3> cap = {end_at(a, (*over)[0]), end_at(b, (*over)[1]),
                                                end_at(c, (*over)[2])};
        sheets.facets.push_back({piece.corners, Sheet::hidden});
        sheets.facets.push_back({cap, sheet});
        sheets.facets.push_back({cap, Sheet::beside});
        continue;
      }
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
  return MoldFault{
      fmt::format("the outline from above and the outline from below differ over a length of "
                  "{:.3g}, in the part's unit: bodies overlap or touch there, or the surface is folded",
                  length * diagonal),
      k_mend_surface, place};
}

}  // namespace moldlight
