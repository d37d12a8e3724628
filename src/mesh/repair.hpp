// Mending a part on request, step by step and with an account of each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

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
/// source.
RepairReport repair_part(Part& part, const RepairOptions& options);

/// Joins the facets of a part that was cut where its facets cross, along the cuts; returns how many edges are
/// open.
std::size_t close_cuts(Part& part);

}  // namespace moldlight
