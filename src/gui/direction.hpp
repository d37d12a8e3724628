// Parting directions as people write and nudge them.
#pragma once

#include <string>

#include <glm/vec3.hpp>

namespace moldlight::gui {

/// Azimuth from +x towards +y in (-180, 180], elevation above the xy plane in [-90, 90]; degrees.
struct Angles {
  double azimuth_deg = 0.0, elevation_deg = 0.0;
};
/// At a pole, where any azimuth would do, it is 0.
[[nodiscard]] Angles angles_of(const glm::dvec3& direction);
[[nodiscard]] glm::dvec3 direction_of(const Angles& angles);

/// The direction turned by an angle towards `toward`, or on beyond it: what an arrow key does with the
/// screen's right or up. A direction that runs along `toward` already turns to the side of `aside`.
[[nodiscard]] glm::dvec3 nudged(const glm::dvec3& direction, const glm::dvec3& toward,
                                const glm::dvec3& aside, double angle_deg);

/// Unit length; components that are within 1e-12 of 0 or of +-1 become just that, so that "straight up" is.
[[nodiscard]] glm::dvec3 tidy(const glm::dvec3& direction);

/// "0.36, 0.48, 0.80".
[[nodiscard]] std::string direction_text(const glm::dvec3& direction);

}  // namespace moldlight::gui
