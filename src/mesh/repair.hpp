// Mending a part on request, step by step and with an account of each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "mesh/part.hpp"

namespace moldlight {

/// Weld: vertices of open edges that nearly coincide become one; no facet comes or goes. Full: also duplicate
/// facets and facets without area go, winding is made consistent, small holes are filled. Unite: what full
/// does, before and after mend_part() (mold/exact/united_bodies.hpp) makes bodies that overlap one solid.
enum class RepairLevel : std::uint8_t { none, weld, full, unite };

struct RepairOptions {
  RepairLevel level = RepairLevel::none;
  double weld_tolerance = 0.0;  // in the part's unit; 0: k_weld_share of its diagonal
  double largest_hole = 0.1;    // side of a square, as share of the diagonal; holes up to its area are filled
  std::size_t hole_edges = 2000;  // and up to so many edges

  bool operator==(const RepairOptions&) const = default;
};

/// Far above the rounding of single precision, far below the features of molded parts.
inline constexpr double k_weld_share = 2e-6;

struct RepairReport {
  double weld_tolerance = 0.0;       // in the part's unit
  std::size_t welded_vertices = 0;   // that became another one
  std::size_t collapsed_facets = 0;  // dropped: two equal corners
  std::size_t flattened_facets = 0;  // without area: merged into the facet across their longest edge
  std::size_t duplicate_facets = 0;  // dropped
  std::size_t turned_facets = 0;     // for consistent winding
  std::size_t filled_holes = 0;
  std::size_t added_facets = 0;  // in these
  double filled_area = 0.0;      // of these, the part's unit squared
  std::size_t open_edges_before = 0, open_edges_after = 0;

  /// One sentence for each thing done, and one for what is left open.
  [[nodiscard]] std::vector<std::string> sentences(const std::string& unit) const;
};

/// Mends the part's mesh and keeps its bodies, facet sources and file facets in step; the sentences go to
/// part.repairs. Facets that fill holes are the last of their body and have k_no_facet as file facet and
/// source. Throws Cancelled, as those below do that have a progress.
RepairReport repair_part(Part& part, const RepairOptions& options, const Progress& progress = Progress());

/// Joins the facets of a part that was cut where its facets cross, along the cuts; returns how many edges are
/// open.
std::size_t close_cuts(Part& part, const Progress& progress);

/// A mesh that changes, and which facet of the start each of its facets comes from.
struct MeshInRepair {
  TriangleMesh mesh;
  std::vector<FacetIndex> origin;   // k_no_facet for a facet that fills a hole
  std::vector<std::uint32_t> body;  // of each facet
};

/// Vertices of open edges that lie within `tolerance` of an earlier one become it. Returns how many did.
std::size_t weld_near_vertices(TriangleMesh& mesh, double tolerance, const Progress& progress);

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
FilledHoles fill_holes(MeshInRepair& state, double largest_area, std::size_t most_edges,
                       const Progress& progress);

[[nodiscard]] std::size_t count_open_edges(const TriangleMesh& mesh);

}  // namespace moldlight
