// The sources of candidate directions, one function each. All are deterministic; none merges what it finds
// with others.
#pragma once

#include <span>
#include <vector>

#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "sweep/candidates/candidate.hpp"

namespace moldlight {

/// Facet area by the line along its normal, in cells of a tenth of a degree: what the searches over normals
/// run on.
struct NormalCell {
  glm::dvec3 normal{0};  // unit, area-weighted mean, on the half-sphere of half_sphere()
  double area = 0.0;     // of facets with this normal or the opposite one
};

/// Cells with area, largest first.
[[nodiscard]] std::vector<NormalCell> normal_histogram(const FacetGeometry& geometry);

/// Area-weighted mean line of the cells within `radius_deg` of `normal`, and their area.
[[nodiscard]] NormalCell mean_normal(const std::vector<NormalCell>& cells, const glm::dvec3& normal,
                                     double radius_deg);

/// x, y, z.
[[nodiscard]] std::vector<Candidate> coordinate_axis_candidates();

/// Axes of the surface's second moments; those that are not determined (equal moments) are left out.
[[nodiscard]] std::vector<Candidate> principal_axis_candidates(const TriangleMesh& mesh,
                                                               const FacetGeometry& geometry);

/// Normals that much area shares, at most `most` of them. `total_area` is that of all cells.
[[nodiscard]] std::vector<Candidate> plane_candidates(const std::vector<NormalCell>& cells, double total_area,
                                                      std::size_t most);

/// A patch of a cylinder or cone: its normals have the same angle to one axis.
struct CurvedPatch {
  glm::dvec3 axis{0, 0, 1};  // unit, least-variance direction of the normals
  double area = 0.0;
  bool full_turn = false;  // the normals go most of the way round
};

/// Patches that turn by 60 degrees at least, each facet in one patch at most. Facets that lie in one plane
/// are one strip of a patch; neighbouring strips are up to 40 degrees apart. Slices of a bent pipe are none.
[[nodiscard]] std::vector<CurvedPatch> curved_patches(const FacetGeometry& geometry,
                                                      const Adjacency& adjacency);

/// Axes of cylinders, cones and holes, full turns first, at most `most` of them.
[[nodiscard]] std::vector<Candidate> revolution_candidates(const FacetGeometry& geometry,
                                                           const Adjacency& adjacency, std::size_t most);

/// Directions perpendicular to much facet area: every normal votes for its great circle of directions; the
/// best are refined to the least-squares perpendicular of the facets within a shrinking band. At most `most`
/// of them.
[[nodiscard]] std::vector<Candidate> perpendicular_candidates(const std::vector<NormalCell>& cells,
                                                              double total_area, std::size_t most);

/// Normals of the largest facets of the convex hull, at most `most`; none for a part without volume.
/// Throws Cancelled.
[[nodiscard]] std::vector<Candidate> hull_candidates(const TriangleMesh& mesh, std::size_t most,
                                                     const Progress& progress);

/// Canonical directions, which the shape of a part names and a mold maker tries first: the file's axes;
/// normals of planes and axes of round walls, put together within a tenth of a degree, the largest first, as
/// far as they are a hundredth of the surface; principal axes where there are none. At most twelve. Of two
/// within 3 degrees the one for which more of the surface speaks is canonical. Axes of the file for which
/// none does are among them, but not canonical where the part is turned. All others turn with the part and do
/// not depend on the order of its facets.
[[nodiscard]] std::vector<Candidate> canonical_candidates(const PartModel& model);

/// `count` directions of even density with z > 0 (Fibonacci lattice), the same in every run.
[[nodiscard]] std::vector<glm::dvec3> fibonacci_half_sphere(std::size_t count);
[[nodiscard]] std::vector<Candidate> uniform_candidates(std::size_t count);

/// Directions as given, of any length but zero; their sense is kept.
[[nodiscard]] std::vector<Candidate> user_candidates(std::span<const glm::dvec3> directions);

}  // namespace moldlight
