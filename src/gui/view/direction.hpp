// Parting directions as people write, nudge and grab them: on the direction ball they are points of a disc,
// seen as the camera sees the part.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/camera.hpp"

namespace moldlight::gui {

/// Azimuth from +x towards +y in (-180, 180], elevation above the xy plane in [-90, 90]; degrees.
struct Angles {
  double azimuth_deg = 0.0, elevation_deg = 0.0;
};
/// Of a unit direction. At a pole, where any azimuth would do, it is 0.
[[nodiscard]] Angles angles_of(const glm::dvec3& direction);
[[nodiscard]] glm::dvec3 direction_of(const Angles& angles);

/// The unit direction turned by an angle towards `toward`, or on beyond it: what an arrow key does with the
/// screen's right or up. A direction that runs along `toward` already turns to the side of `aside`.
[[nodiscard]] glm::dvec3 nudged(const glm::dvec3& direction, const glm::dvec3& toward,
                                const glm::dvec3& aside, double angle_deg);

/// Unit length; components that are within 1e-12 of 0 or of +-1 become just that, so that "straight up" is.
[[nodiscard]] glm::dvec3 tidy(const glm::dvec3& direction);

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
