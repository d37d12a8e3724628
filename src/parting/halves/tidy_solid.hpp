// Faults that rounding to single precision leaves in a closed solid, and their removal: fins without
// thickness, needles where the surface is flat, and edges in which the solid touches itself.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.hpp"
#include "mesh/triangle_mesh.hpp"
#include "parting/halves/sheets.hpp"

namespace moldlight {

/// Sine of the angle, 0.01 degrees, from which a facet that leans along a half's pull counts as undercut.
inline constexpr double k_leaning_sine = 1.7453e-4;

struct TidyQuery {
  double tolerance = 0.0;  // how far the surface may move: a few steps of rounding, in the mesh's unit
  glm::dvec3 pull{0.0};    // of a half, unit: no flip may let more of it face along the pull; 0: none
};

/// Drops pairs of facets with the same corners that face away from each other, and flips edges between facets
/// that are flat within the tolerance where that makes the least angle greater (Lawson 1977), or where less
/// of a half leans along its pull then; collapse_thin_facets() takes out what leans by rounding and cannot be
/// flipped. The solid stays closed; the result depends on nothing but the mesh.
void tidy_solid(TriangleMesh& mesh, const TidyQuery& query);

/// Pairs of facets with the same corners that face away from each other go.
void drop_fins(TriangleMesh& mesh);

/// Splits vertices so that every edge has two facets and the facets of every vertex hang together: where more
/// than two meet in an edge, those with material between them stay together, and all such pairs but one get a
/// vertex on the edge, so that no edge has more than two facets for readers that join equal vertices either.
/// Returns how many edges had more.
std::size_t split_touching(TriangleMesh& mesh);

/// Takes out facets of a half that are so thin that rounding alone makes them lean along its pull: the
/// shortest edge of each shrinks to one of its ends, where no surface moves by more than the tolerance, none
/// turns over, and no more of it leans along the pull than before. The solid stays closed and an edge that
/// had two facets keeps two; the result depends on nothing but the mesh.
void collapse_thin_facets(TriangleMesh& mesh, const TidyQuery& query);

/// Moves corners of facets that cross others (`crossed`) by a step of rounding or two, first along the pull,
/// along which nothing of what a half covers changes, where fewer facets cross then. No move lets more of the
/// half face or lean along the pull, none of a half touches the sides of the block; the mesh stays as closed
/// as it is. `tolerance` of the query is the longest move. Returns the facets that still cross others. Throws
/// Cancelled.
[[nodiscard]] std::vector<FacetIndex> uncross(TriangleMesh& mesh, const TidyQuery& query,
                                              std::vector<FacetIndex> crossed, const Progress& progress);

/// Facets as seen along z: areas of those that face along a sign, and of the others.
struct GraphTest {
  double covered = 0.0, folded = 0.0, most = 0.0;
  glm::dvec3 place{0.0};  // of the facet that is folded most
};
[[nodiscard]] GraphTest graph_test(const std::vector<glm::dvec3>& vertices,
                                   const std::vector<std::array<SheetVertex, 3>>& facets, double sign);

/// Facets whose least height is below `thinnest`, and a corner of the longest of them.
struct Needles {
  std::size_t count = 0;
  std::optional<glm::dvec3> place;
};
[[nodiscard]] Needles find_needles(const TriangleMesh& mesh, double thinnest);

/// Facets that cross others. Throws Cancelled.
[[nodiscard]] std::vector<FacetIndex> crossed_facets(const TriangleMesh& mesh, const Progress& progress);

}  // namespace moldlight
