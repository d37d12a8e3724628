// The steps of a repair (repair.hpp). Each leaves the facets in their order.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// A mesh that changes, and which facet of the start each of its facets comes from.
struct MeshInRepair {
  TriangleMesh mesh;
  std::vector<FacetIndex> origin;   // k_no_facet for a facet that fills a hole
  std::vector<std::uint32_t> body;  // of each facet
};

/// Vertices of open edges that lie within `tolerance` of an earlier one become it. Returns how many did.
std::size_t weld_near_vertices(TriangleMesh& mesh, double tolerance);

/// Open edges of which one runs back along another from a vertex of both, within `tolerance`, share their
/// vertices afterwards: the facet of the longer one is cut in two. Returns how often.
std::size_t match_open_edges(MeshInRepair& state, double tolerance);

/// Drops facets with two equal corners. Returns how many went.
std::size_t drop_collapsed_facets(MeshInRepair& state);

/// A facet without area whose corners differ splits the facet across its longest edge at its third corner and
/// becomes one of the halves. Returns how many could.
std::size_t flatten_facets_without_area(MeshInRepair& state);

/// Of facets with the same three corners one is left, or none where as many face each way. Returns how many
/// went.
std::size_t drop_duplicate_facets(MeshInRepair& state);

/// Turns facets so that neighbours run through their common edge in opposite senses; of two ways to do that
/// the one that keeps more area. Edges of more than two facets join nothing. Returns how many were turned.
std::size_t make_winding_consistent(TriangleMesh& mesh);

struct FilledHoles {
  std::size_t holes = 0, facets = 0;
  double area = 0.0;
};
/// Closes rings of at most `most_edges` open edges by at most `largest_area` each; facets are appended, as
/// part of the body around. Where neighbours meet in edges of different lengths, the ring between them has no
/// area.
FilledHoles fill_holes(MeshInRepair& state, double largest_area, std::size_t most_edges);

[[nodiscard]] std::size_t count_open_edges(const TriangleMesh& mesh);

}  // namespace moldlight
