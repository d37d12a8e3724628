// How far areas by exact regions may be off: by rounding, and by what is wrong with the mesh.
#pragma once

#include <vector>

#include "mesh/adjacency.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/health.hpp"
#include "mold/exact/exact_regions.hpp"
#include "mold/region.hpp"

namespace moldlight {

/// Facets of which at least half is undercut, or as much as a 1000th of the part's area (of a coarse mesh's
/// large facets), connected across shared edges. Undercuts of less than a 100,000th of the part's area are
/// left out.
struct FacetUndercuts {
  std::size_t count = 0;
  std::vector<FacetIndex> of_facet;  // undercut number, largest undercut first; k_no_facet outside
  std::vector<double> areas;         // area of each, model units squared
};
[[nodiscard]] FacetUndercuts facet_undercuts(const FacetFractions& facet_fractions,
                                             const FacetGeometry& geometry, const Adjacency& adjacency);

// Rounding, in the unit frame (diagonal 1) with u = 2^-53. A vertex that was moved there and turned is off by
// at most 8 u; cuts nearer to each other than 1e-13 are one, and a region is known with a tolerance of 1e-12.
// The last is far above the others: e = 1e-12 is how far a border of regions may be off, seen along the
// direction. On a facet that makes at most e / s, where s is |n . d| of an up or down facet; what bounds a
// region of a near-vertical facet is taken to cross it at half a degree at least, so s = 0.01. Borders
// on a facet are taken to be no longer than its perimeter p, and facets of one region have none. A facet's
// area, a difference of products of its edges, is off by at most 4 u p^2, and a sum of N areas by N u times
// their total.

/// What depends on the part alone. Model units squared.
struct PartErrors {
  double facets =
      0.0;  // rounding of the facets' areas and their sum: 4 u times the sum of p^2, N u times the area
  double shadow_gap =
      0.0;  // bound of the rounding in the difference of the projected areas: facets + e times the sum of p
  /// Surface that is missing or turned inside out, as far as its rim says: the sum over the chains of open
  /// edges, and of edges between facets that are wound in opposite ways, of the area of the flat face that
  /// has the same rim (half the length of the sum of p_i x p_i+1).
  double faulty_area = 0.0;
};
[[nodiscard]] PartErrors part_errors(const TriangleMesh& mesh, const FacetGeometry& geometry,
                                     const HealthReport& health, const UnitFrame& frame);

/// Bound of the rounding in the area of any region: that of the facets, and the sum over the facets of
/// several regions of e p / s, none more than the facet's area. Model units squared.
[[nodiscard]] double rounding_bound(const ExactPart& part, const ExactQuery& query, const ExactAreas& areas,
                                    const PartErrors& errors);

/// What the mesh leaves in doubt of the undercut area, an estimate; 0 for a closed part without crossings.
/// The sum of: the faulty area, whose region is not known; the difference of the two projected areas, if it
/// is no rounding, through which one side looks into the part where it should meet surface; and, where bodies
/// overlap, the undercuts that hang together with a facet which another one crosses, as surface inside the
/// material is an undercut that is none. At most the part's area. Model units squared.
[[nodiscard]] double mesh_doubt(const ExactPart& part, const ExactAreas& areas, const Adjacency& adjacency,
                                const PartErrors& errors);

}  // namespace moldlight
