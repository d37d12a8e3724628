// The direction ball's geometry: directions as points of a disc, seen as the camera sees the part.
#pragma once

#include <glm/vec2.hpp>

#include "render/camera.hpp"

namespace moldlight::gui {

/// A direction on the ball: `at` in the unit disc, x to the right, y up; `front`: on the viewer's side.
struct BallPoint {
  glm::dvec2 at{0.0};
  bool front = true;
};
[[nodiscard]] BallPoint ball_point(const Camera& camera, const glm::dvec3& direction);

/// The direction under a point of the ball. Beyond the rim it goes on over the ball's other side, so that a
/// drag can run all the way round.
[[nodiscard]] glm::dvec3 ball_direction(const Camera& camera, const BallPoint& point);

}  // namespace moldlight::gui
