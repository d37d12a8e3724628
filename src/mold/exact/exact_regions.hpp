// The regions of a part for a parting direction, computed: every facet is cut where visibility along the
// direction may change (under the contour edges: Priyadarshi & Gupta 2006, theorem 1), and each cell is
// labelled by one test inside it.
#pragma once

#include <limits>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "base/progress.hpp"
#include "mold/exact/exact_part.hpp"
#include "mold/exact/split_mesh.hpp"
#include "mold/region.hpp"

namespace moldlight {

struct ExactQuery {
  glm::dvec3 direction{0, 0, 1};  // unit
  double tau_deg = 1.0;           // [0, 90)
  double lateral = 0.0;           // lateral tolerance in the unit frame, >= 0
  bool operator==(const ExactQuery&) const = default;
};

/// Areas in model units squared.
struct ExactAreas {
  FacetFractions facet_fractions;  // a row a facet, sum 1; 0 for a facet without area
  RegionValues areas;
  double near_vertical_area = 0.0;
  /// Projected area of the surface that faces along +d (up) and is accessible along +d, and the same for -d;
  /// at tau = 0, whatever the query's tau. Each is the area of the part's shadow if the mesh is closed.
  double projected_core = 0.0, projected_cavity = 0.0;
  double projected_doubt =
      0.0;  // at most so much is missing from each: projected area of what is all but edge-on
  /// Facets that so much crosses that they were not cut along all of it but sampled: a point for each cell.
  /// The error is twice the standard deviation of each region's area.
  std::size_t sampled_facets = 0;
  double sampling_error = 0.0;
  /// Of more than one facet in a hundred.
  [[nodiscard]] bool mostly_sampled() const { return 100 * sampled_facets > facet_fractions.size(); }
};

struct ExactSplit {
  ExactAreas areas;
  SplitMesh mesh;

  /// Whether lines between the regions say something: not where facets are mostly sampled, nor where they are
  /// in more pieces than most_pieces() are.
  [[nodiscard]] bool has_lines(double effort) const {
    return !areas.mostly_sampled() && mesh.pieces.size() <= most_pieces(areas.facet_fractions.size(), effort);
  }
};

/// All use all cores of the calling thread's TBB arena; the result is the same to the bit for any number of
/// threads. Throw Cancelled.
[[nodiscard]] ExactAreas exact_areas(const ExactPart& part, const ExactQuery& query,
                                     const Progress& progress);
[[nodiscard]] ExactSplit exact_split(const ExactPart& part, const ExactQuery& query,
                                     const Progress& progress);

/// The mesh of exact_split() around these facets, each once: theirs are its pieces, in the same order and
/// with the same corners; what is not beside them is of the region `both`.
[[nodiscard]] SplitMesh exact_split_around(const ExactPart& part, const ExactQuery& query,
                                           std::span<const FacetIndex> facets, const Progress& progress);

/// When a direction is hopeless: its undercut area is certain to be above `undercut` (model units squared).
struct UndercutLimit {
  double undercut = std::numeric_limits<double>::infinity();
  std::span<const FacetIndex> first;  // facets looked at first, each once: those likely to be undercut
};

/// exact_areas() to the bit; nothing as soon as the undercut facets seen are above the limit.
[[nodiscard]] std::optional<ExactAreas> exact_areas_within(const ExactPart& part, const ExactQuery& query,
                                                           const UndercutLimit& limit,
                                                           const Progress& progress);

}  // namespace moldlight
