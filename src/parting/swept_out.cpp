#include "parting/swept_out.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/facet_geometry.hpp"
#include "mesh/health.hpp"
#include "mold/exact/exact_regions.hpp"
#include "parting/halves/bodies.hpp"
#include "parting/halves/depth_columns.hpp"
#include "parting/part_sheets.hpp"

namespace moldlight {

namespace {

constexpr double k_in_end = 1e-6;      // off the blank's end
constexpr double k_most_lost = 5e-10;  // of the volume, in cubes of the diagonal
constexpr unsigned k_seen = Sheets::bit(Sheet::upper), k_end = Sheets::bit(Sheet::beside),
                   k_rest = Sheets::bit(Sheet::hidden) | Sheets::bit(Sheet::lower);

/// Of the body, all but what lies in the blank's ends, turned inside out: what is seen along the way from
/// outside is what can leave along it.
struct Hollow {
  TriangleMesh walls, end;
};

Hollow hollow_of(const TriangleMesh& body, const SlideBlank& blank) {
  const auto lies_in = [&](const glm::dvec3& at, std::size_t side) {
    const auto& place = blank.sides[side];
    return place && std::abs(at[static_cast<int>(side)] - *place) < k_in_end;
  };
  std::array<glm::dvec3, 2> low, high;
  low.fill(glm::dvec3(INFINITY));
  high.fill(glm::dvec3(-INFINITY));
  for (const glm::dvec3& vertex : blank.mesh.vertices) {
    for (const std::size_t side : {0, 1}) {
      if (!lies_in(vertex, side)) continue;
      low[side] = glm::min(low[side], vertex - k_in_end);
      high[side] = glm::max(high[side], vertex + k_in_end);
    }
  }
  Hollow hollow;
  hollow.walls.vertices = hollow.end.vertices = body.vertices;
  for (const auto& facet : body.facets) {
    const auto in_end = [&](std::size_t side) {
      return std::ranges::all_of(facet, [&](VertexIndex corner) {
        const glm::dvec3& at = body.vertices[corner];
        return lies_in(at, side) && glm::all(glm::lessThanEqual(low[side], at)) &&
               glm::all(glm::lessThanEqual(at, high[side]));
      });
    };
    if (in_end(0) || in_end(1)) {
      hollow.end.facets.push_back(facet);
    } else {
      hollow.walls.facets.push_back({facet[0], facet[2], facet[1]});
    }
  }
  return hollow;
}

void add_end(const TriangleMesh& end, const SheetFrame& frame, Sheets& sheets) {
  std::map<VertexIndex, SheetVertex> number;
  for (const auto& facet : end.facets) {
    SheetFacet added{.corners = {}, .sheet = Sheet::beside};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [entry, fresh] =
          number.try_emplace(facet[k], static_cast<SheetVertex>(sheets.vertices.size()));
      if (fresh) {
        sheets.vertices.push_back(frame.in_mold(end.vertices[facet[k]]));
        sheets.column_of.push_back(k_no_plane_point);
      }
      added.corners[k] = entry->second;
    }
    sheets.facets.push_back(added);
  }
}

/// Closed, in the frame of the body; nothing where it is not.
std::optional<TriangleMesh> closed_body(const Sheets& sheets, const BodySheets& bounds,
                                        const SheetFrame& frame) {
  std::vector<std::array<SheetVertex, 3>> facets;
  if (close_upright(sheets, bounds, facets) || check_body(sheets.vertices, facets).open_edges > 0)
    return std::nullopt;
  TriangleMesh mesh = body_mesh(sheets.vertices, facets);
  for (glm::dvec3& vertex : mesh.vertices) vertex = frame.in_part(vertex);
  return mesh;
}

}  // namespace

std::optional<SweptOut> swept_out(const TriangleMesh& body, const SlideBlank& blank, const glm::dvec3& way,
                                  const Progress& progress) {
  const Hollow hollow = hollow_of(body, blank);
  if (hollow.end.facets.empty()) return std::nullopt;
  const WayFrame axes = frame_along(way);
  const SheetFrame frame{
      .frame = {axes.across, axes.up, axes.way}, .centre = glm::dvec3(0.0), .diagonal = 1.0};
  const TriangleMesh& walls = hollow.walls;
  const FacetGeometry geometry = facet_geometry(walls);
  const ExactPart part(walls, geometry, unit_frame(bounds(walls)), progress, 1.0, {.in_front = false});
  const SplitMesh split =
      exact_split(part, {.direction = way, .tau_deg = 0.0, .lateral = 0.0}, progress).mesh;
  const double whole = signed_volume(body);
  for (const SheetTolerance& attempt : k_sheet_attempts) {
    Sheets sheets =
        part_sheets(split, static_cast<FacetIndex>(walls.facets.size()), frame, attempt, {}).sheets;
    add_end(hollow.end, frame, sheets);
    if (sheets.align_ends(attempt.tolerance)) continue;
    auto moved = closed_body(sheets, {.sheets = k_seen | k_end, .turned = k_seen}, frame);
    const auto rest = closed_body(sheets, {.sheets = k_rest, .turned = k_rest}, frame);
    if (!moved || !rest || moved->facets.empty()) continue;
    if (std::abs(signed_volume(*moved) + signed_volume(*rest) - whole) > k_most_lost) continue;
    SweptOut swept{.moved = std::move(*moved), .left = {}};
    for (const auto& facets : connected_bodies(rest->vertices.size(), rest->facets))
      swept.left.push_back(body_mesh(rest->vertices, facets));
    return swept;
  }
  return std::nullopt;
}

}  // namespace moldlight
