// Closed bodies from sheets: what is upright follows from where the sheets end.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "mesh/triangle_mesh.hpp"
#include "parting/halves/sheets.hpp"

namespace moldlight {

/// Sheets that a body is bounded by.
struct BodySheets {
  unsigned sheets = 0;  // a bit each
  unsigned turned = 0;  // of these, those that are turned over
  // Over the sides of this rectangle it stays open.
  glm::dvec2 low{-INFINITY}, high{INFINITY};
};

/// The sheets and the only upright surface that has their ends: on every segment, from below upwards, as many
/// walls as the ends below it leave open. A place where the ends over a segment do not sum up to nothing;
/// none where they do everywhere.
[[nodiscard]] std::optional<glm::dvec3> close_upright(const Sheets& sheets, const BodySheets& body,
                                                      std::vector<std::array<SheetVertex, 3>>& facets);

struct BlockHeights {
  double low = 0.0, high = 0.0;
};
/// Adds the walls from where a half ends, at the sides of a rectangle, up to `high` (or down to `low`) and
/// the lid there.
void add_block(Sheets& sheets, const BlockHeights& heights, bool up,
               std::vector<std::array<SheetVertex, 3>>& facets);

/// What is wrong with a body's facets as a surface, and what it holds.
struct BodyCheck {
  std::size_t open_edges = 0;         // run through more often one way than the other
  std::size_t nonmanifold_edges = 0;  // used by more than two facets
  std::optional<glm::dvec3> open_at;  // the middle of an open edge
  double volume = 0.0;
};
[[nodiscard]] BodyCheck check_body(const std::vector<glm::dvec3>& vertices,
                                   const std::vector<std::array<SheetVertex, 3>>& facets);

/// The facets with the vertices that they use alone.
[[nodiscard]] TriangleMesh body_mesh(const std::vector<glm::dvec3>& vertices,
                                     const std::vector<std::array<SheetVertex, 3>>& facets);

/// The facets of each body of them, which shares no vertex with the others. `vertices`: how many there are.
[[nodiscard]] std::vector<std::vector<std::array<SheetVertex, 3>>> connected_bodies(
    std::size_t vertices, const std::vector<std::array<SheetVertex, 3>>& facets);

/// Whether one of the facets' corners is nearer than that to a place.
[[nodiscard]] bool has_corner(const std::vector<glm::dvec3>& vertices,
                              const std::vector<std::array<SheetVertex, 3>>& facets, const glm::dvec3& place,
                              double near);

/// A half, with its block, that has these bodies of hidden sheets, too: what the sheets hide is its own.
/// Nothing where it does not close.
[[nodiscard]] std::optional<TriangleMesh> half_with_bodies(
    Sheets sheets, const std::vector<std::vector<std::array<SheetVertex, 3>>>& bodies, bool up,
    const BodySheets& half, const BlockHeights& block);

/// Where the halves touch on upright surface, and how much.
struct ContactWall {
  glm::dvec3 place{0.0};
  double height = 0.0, area = 0.0;
};
/// Walls that core and cavity have in common, joined where their columns are, the largest first.
[[nodiscard]] std::vector<ContactWall> contact_walls(const Sheets& sheets, double tolerance);

}  // namespace moldlight
