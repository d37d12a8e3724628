// Where the parting arrows stand: beside the part, along the direction.
#pragma once

#include <span>

#include <glm/vec3.hpp>

namespace moldlight {

/// Unit frame.
struct PartingArrow {
  glm::dvec3 tail{0.0}, tip{0.0};
  double shaft_radius = 0.0, head_radius = 0.0, head_length = 0.0;
};

/// The arrow that points along `toward` (unit) from above the part, of which `extremes` are the outermost
/// points; an opened mold moves it out by `opened`.
[[nodiscard]] PartingArrow parting_arrow(std::span<const glm::vec3> extremes, const glm::dvec3& toward,
                                         double opened);

}  // namespace moldlight
