// Whether surface is hidden along every direction of a cone at once: by one connected sheet of facets that
// face it and cover the cone.
#pragma once

#include <cstdint>
#include <vector>

#include "proof/proof_part.hpp"
#include "proof/swept_region.hpp"

namespace moldlight {

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
