// Points spread evenly over some facets of a part.
#pragma once

#include <algorithm>
#include <cstdint>

#include <glm/vec3.hpp>

#include "mold/scan/scan_part.hpp"
#include "mold/surface_samples.hpp"

namespace moldlight {

/// Goes through facets once and gives about `count` points on them, one for each equal piece of their area in
/// the order of the visits; so small facets share a point. The same visits give the same points.
class EvenSamples {
 public:
  /// `area`: of all facets that will be visited, unit frame squared.
  EvenSamples(const ScanPart& part, double area, double count)
      : part_(part), spacing_(area / std::max(count, 1.0)), area_left_(0.5 * spacing_) {}

  /// Calls visit(position) for each point on the facet, unit frame.
  template <typename Visit>
  void on_facet(FacetIndex facet, const Visit& visit) {
    double area = static_cast<double>(part_.areas()[facet]);
    if (area > area_left_) {
      const auto& corners = part_.facets()[facet];
      const glm::vec3 a = part_.position(corners[0]);
      const glm::vec3 ab = part_.position(corners[1]) - a, ac = part_.position(corners[2]) - a;
      for (; area > area_left_; area_left_ = spacing_) {
        area -= area_left_;
        const TrianglePlace place = triangle_place(number_++);
        visit(a + static_cast<float>(place.u) * ab + static_cast<float>(place.v) * ac);
      }
    }
    area_left_ -= area;
  }

 private:
  const ScanPart& part_;
  double spacing_;
  double area_left_;  // up to the next point
  std::uint64_t number_ = 0;
};

}  // namespace moldlight
