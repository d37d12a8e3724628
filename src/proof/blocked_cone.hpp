// Whether surface is hidden along every direction of a cone at once: by one connected sheet of facets that
// face it and cover the cone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/adjacency.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mold/exact_rays.hpp"

namespace moldlight {

/// Everything must outlive the proof. Adjacency, geometry and rays are those of the mesh.
struct ProofPart {
  const TriangleMesh& mesh;
  const FacetGeometry& geometry;
  const Adjacency& adjacency;
  const std::vector<glm::dvec3>& positions;  // of the vertices, unit frame
  const ExactRays& rays;
};

/// Rays start within `radius` of `points` (one, or the corners of a triangle) or between them; their
/// directions are the positive combinations of `directions`, three to eight unit vectors that span a convex
/// cone counter-clockwise seen from outside, narrower than a half-space. Unit frame.
struct RayBundle {
  std::span<const glm::dvec3> points;
  double radius = 0.0;
  std::span<const glm::dvec3> directions;
  glm::dvec3 centre{0, 0, 1};  // unit, within the cone
};

/// Contains every point that a ray of the bundle meets, and a little more.
class SweptRegion {
 public:
  explicit SweptRegion(const RayBundle& bundle);

  /// True if some of the line from `a` to `b` may lie inside.
  [[nodiscard]] bool meets(const glm::dvec3& a, const glm::dvec3& b) const;

 private:
  void add(const RayBundle& bundle, const glm::dvec3& normal);
  void add_edge_planes(const RayBundle& bundle);

  struct HalfSpace {
    glm::dvec3 normal;
    double offset;
  };
  std::array<HalfSpace, 32> half_spaces_;
  std::size_t count_ = 0;
};

/// How a bundle of rays ends.
struct ConeAnswer {
  bool blocked = false;   // every ray of the bundle meets a facet that faces it
  bool hit = false;       // the middle ray does
  double distance = 0.0;  // to the first facet that it meets
};

/// One thread's room. The facets that the middle ray meets are tried one after the other, four at most: from
/// such a facet all that hang together with it over edges that the rays may meet must face all starting
/// points, and none of these edges may be a rim. Then rays of neighbouring starts and directions cannot but
/// meet the sheet, too: where one meets it inside, so do those around it; across an edge the sheet goes on.
/// Conservative: rounding and sheets of more than a few hundred facets end in "not blocked".
class BlockedCone {
 public:
  explicit BlockedCone(const ProofPart& part) : part_(part), met_(part.mesh.facets.size(), 0) {}

  [[nodiscard]] ConeAnswer ask(const RayBundle& bundle);

 private:
  [[nodiscard]] bool covered_from(FacetIndex first, const RayBundle& bundle, const SweptRegion& region);
  [[nodiscard]] bool faces(FacetIndex facet, const RayBundle& bundle) const;
  [[nodiscard]] bool truly_hit(FacetIndex facet, const glm::dvec3& origin, const glm::dvec3& direction) const;

  const ProofPart& part_;
  std::vector<std::uint32_t> met_;  // round in which a facet was last met
  std::uint32_t round_ = 0;
  std::vector<FacetIndex> sheet_;
};

}  // namespace moldlight
