// The camera as a value: where it looks, how much it sees; and what a hand does to it, as pure functions.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace moldlight {

enum class Projection : std::uint8_t { orthographic, perspective };

/// All coordinates are in the unit frame. Pixels count from the upper left corner, x to the right, y down;
/// the first pixel's centre is (0.5, 0.5). z of the part is up.
struct Camera {
  glm::dvec3 target{0.0};  // the point in the middle of the picture
  glm::dquat orientation{1, 0, 0,
                         0};  // turns x (right), y (up) and z (toward the viewer) into the unit frame
  double height = 1.2;        // what the picture's height spans at the target, > 0
  Projection projection = Projection::orthographic;
  double fov_deg = 30.0;  // vertical, of the perspective, (0, 120]

  [[nodiscard]] glm::dvec3 right() const { return orientation * glm::dvec3(1, 0, 0); }
  [[nodiscard]] glm::dvec3 up() const { return orientation * glm::dvec3(0, 1, 0); }
  [[nodiscard]] glm::dvec3 toward_viewer() const { return orientation * glm::dvec3(0, 0, 1); }
  /// From the target to the eye; for the orthographic camera a distance that has the part in front of it.
  [[nodiscard]] double eye_distance() const;
  [[nodiscard]] glm::dvec3 eye() const { return target + eye_distance() * toward_viewer(); }

  bool operator==(const Camera&) const = default;
};

/// Everything that is ever drawn lies within this distance of the unit frame's origin.
inline constexpr double k_scene_radius = 2.5;

[[nodiscard]] glm::dmat4 view_matrix(const Camera& camera);
/// Distances from the eye, along the view, between which everything is drawn.
struct DepthRange {
  double near = 0.0, far = 1.0;
};
[[nodiscard]] DepthRange depth_range(const Camera& camera);
/// Clip space of GL; `size` is the picture's in pixels. `shift_px` moves the picture by a part of a pixel, y
/// down.
[[nodiscard]] glm::dmat4 projection_matrix(const Camera& camera, const glm::ivec2& size,
                                           const glm::dvec2& shift_px = glm::dvec2(0.0));
/// Pixel at which a point is seen; nothing for a point behind the eye.
[[nodiscard]] std::optional<glm::dvec2> project(const Camera& camera, const glm::ivec2& size,
                                                const glm::dvec3& point);
/// Length that a pixel spans at the target.
[[nodiscard]] double pixel_length(const Camera& camera, const glm::ivec2& size);

/// Orientation of a camera that looks along `forward` (any length but zero) with `up` upward in the picture
/// as far as possible; where both run along one line another up is chosen.
[[nodiscard]] glm::dquat looking_along(const glm::dvec3& forward, const glm::dvec3& up);

enum class StandardView : std::uint8_t { front, back, left, right, top, bottom, isometric };
/// Front looks along +y, right along -x, top along -z; isometric from the front, right and above.
[[nodiscard]] glm::dquat standard_orientation(StandardView view);

/// The same view direction, moved and zoomed so that all points fill the picture but for a margin: `fill` is
/// the share of the picture's smaller spare side that they take, (0, 1].
[[nodiscard]] Camera fitted(Camera camera, std::span<const glm::vec3> points, const glm::ivec2& size,
                            double fill = 0.86);

/// Turns about `pivot`: by x of `turn_rad` about `axis` (unit; a turntable) and by y about the picture's
/// horizontal; positive values follow the hand to the right and down. The turntable stops at its poles.
[[nodiscard]] Camera orbited(Camera camera, const glm::dvec2& turn_rad, const glm::dvec3& axis,
                             const glm::dvec3& pivot);
/// Moves the scene with the hand by `by_px`.
[[nodiscard]] Camera panned(Camera camera, const glm::dvec2& by_px, const glm::ivec2& size);
/// Magnifies by `factor` (> 0); the point of the target's plane under `pixel` stays there.
[[nodiscard]] Camera zoomed(Camera camera, double factor, const glm::dvec2& pixel, const glm::ivec2& size);
/// Between two cameras, for flights: t in [0, 1]; the projection is that of `to`.
[[nodiscard]] Camera interpolated(const Camera& from, const Camera& to, double t);

}  // namespace moldlight
