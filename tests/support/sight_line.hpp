// What a pixel of a picture looks along.
#pragma once

#include <glm/geometric.hpp>

#include "render/camera.hpp"

namespace moldlight::test {

/// A line of sight; `direction` is a unit vector away from the viewer.
struct SightLine {
  glm::dvec3 origin{0.0}, direction{0, 0, -1};
};

[[nodiscard]] inline SightLine sight_line(const Camera& camera, const glm::ivec2& size,
                                          const glm::dvec2& pixel) {
  const glm::dvec2 at = pixel_length(camera, size) * (pixel - 0.5 * glm::dvec2(size));
  const glm::dvec3 aside = at.x * camera.right() - at.y * camera.up();
  if (camera.projection == Projection::orthographic) return {camera.eye() + aside, -camera.toward_viewer()};
  return {camera.eye(), glm::normalize(aside - camera.eye_distance() * camera.toward_viewer())};
}

}  // namespace moldlight::test
