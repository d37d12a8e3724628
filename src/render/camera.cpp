#include "render/camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "base/check.hpp"

namespace moldlight {

namespace {

constexpr double k_nearest_share = 0.01;  // of the eye's distance: the perspective's near plane
constexpr double k_pole_gap_rad = 1e-3;   // a turntable stops this far from looking along its axis
constexpr double k_min_height = 1e-5, k_max_height = 20.0;

double half_tangent(const Camera& camera) { return std::tan(0.5 * glm::radians(camera.fov_deg)); }

double aspect(const glm::ivec2& size) { return static_cast<double>(size.x) / size.y; }

Camera turned(Camera camera, const glm::dquat& turn, const glm::dvec3& pivot) {
  camera.orientation = glm::normalize(turn * camera.orientation);
  camera.target = pivot + turn * (camera.target - pivot);
  return camera;
}

}  // namespace

double Camera::eye_distance() const {
  if (projection == Projection::perspective) return 0.5 * height / half_tangent(*this);
  return 2.0 * k_scene_radius + glm::length(target);
}

glm::dmat4 view_matrix(const Camera& camera) {
  const glm::dmat4 turn = glm::mat4_cast(glm::conjugate(camera.orientation));
  return glm::translate(turn, -camera.eye());
}

DepthRange depth_range(const Camera& camera) {
  const double to_origin = glm::dot(camera.eye(), camera.toward_viewer());
  const DepthRange range{to_origin - k_scene_radius, to_origin + k_scene_radius};
  if (camera.projection == Projection::orthographic) return range;
  const double nearest = k_nearest_share * camera.eye_distance();
  return {std::max(range.near, nearest), std::max(range.far, 2.0 * nearest)};
}

glm::dmat4 projection_matrix(const Camera& camera, const glm::ivec2& size, const glm::dvec2& shift_px) {
  CHECK(size.x > 0 && size.y > 0);
  const auto [near, far] = depth_range(camera);
  const double shift_x = 2.0 * shift_px.x / size.x, shift_y = -2.0 * shift_px.y / size.y;
  glm::dmat4 projection(0.0);
  if (camera.projection == Projection::orthographic) {
    projection = glm::ortho(-0.5 * camera.height * aspect(size), 0.5 * camera.height * aspect(size),
                            -0.5 * camera.height, 0.5 * camera.height, near, far);
    projection[3][0] += shift_x;
    projection[3][1] += shift_y;
  } else {
    projection = glm::perspective(glm::radians(camera.fov_deg), aspect(size), near, far);
    projection[2][0] -= shift_x;
    projection[2][1] -= shift_y;
  }
  return projection;
}

std::optional<glm::dvec2> project(const Camera& camera, const glm::ivec2& size, const glm::dvec3& point) {
  const glm::dvec3 from_target = point - camera.target;
  double scale = 1.0 / pixel_length(camera, size);
  if (camera.projection == Projection::perspective) {
    const double distance = camera.eye_distance();
    const double depth = distance - glm::dot(from_target, camera.toward_viewer());
    if (depth <= k_nearest_share * distance) return std::nullopt;
    scale *= distance / depth;
  }
  return glm::dvec2(0.5 * size.x + scale * glm::dot(from_target, camera.right()),
                    0.5 * size.y - scale * glm::dot(from_target, camera.up()));
}

double pixel_length(const Camera& camera, const glm::ivec2& size) { return camera.height / size.y; }

glm::dquat looking_along(const glm::dvec3& forward, const glm::dvec3& up) {
  const glm::dvec3 back = -glm::normalize(forward);
  glm::dvec3 right = glm::cross(up, back);
  if (glm::length(right) < 1e-6 * glm::length(up))
    right = glm::cross(std::abs(back.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1), back);
  right = glm::normalize(right);
  return glm::normalize(glm::quat_cast(glm::dmat3(right, glm::cross(back, right), back)));
}

glm::dquat standard_orientation(StandardView view) {
  struct Look {
    glm::dvec3 forward, up;
  };
  static const std::array<Look, 7> k_looks = {{{{0, 1, 0}, {0, 0, 1}},
                                               {{0, -1, 0}, {0, 0, 1}},
                                               {{1, 0, 0}, {0, 0, 1}},
                                               {{-1, 0, 0}, {0, 0, 1}},
                                               {{0, 0, -1}, {0, 1, 0}},
                                               {{0, 0, 1}, {0, -1, 0}},
                                               {{-1, 1, -1}, {0, 0, 1}}}};
  const Look& look = k_looks[static_cast<std::size_t>(view)];
  return looking_along(look.forward, look.up);
}

Camera fitted(Camera camera, std::span<const glm::vec3> points, const glm::ivec2& size, double fill) {
  CHECK(fill > 0.0 && fill <= 1.0);
  if (points.empty()) return camera;
  const glm::dquat to_picture = glm::conjugate(camera.orientation);
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const glm::vec3& point : points) {
    const glm::dvec3 seen = to_picture * glm::dvec3(point);
    low = glm::min(low, seen);
    high = glm::max(high, seen);
  }
  const glm::dvec3 middle = 0.5 * (low + high), extent = high - low;
  camera.target = camera.orientation * middle;
  camera.height = std::max(extent.y, extent.x / aspect(size)) / fill;
  if (camera.projection == Projection::perspective) {
    const double tangent = half_tangent(camera) * fill;
    double distance = 0.0;
    for (const glm::vec3& point : points) {
      const glm::dvec3 seen = to_picture * glm::dvec3(point) - middle;
      distance =
          std::max(distance, seen.z + std::max(std::abs(seen.y), std::abs(seen.x) / aspect(size)) / tangent);
    }
    camera.height = 2.0 * half_tangent(camera) * distance;
  }
  camera.height = std::clamp(camera.height, k_min_height, k_max_height);
  return camera;
}

Camera orbited(Camera camera, const glm::dvec2& turn_rad, const glm::dvec3& axis, const glm::dvec3& pivot) {
  // Angle between the axis and the line to the viewer: the pitch may not carry it past the poles.
  const double polar = std::acos(std::clamp(glm::dot(camera.toward_viewer(), axis), -1.0, 1.0));
  const bool upright = glm::dot(camera.up(), axis) >= 0.0;
  const double wanted = upright ? polar - turn_rad.y : polar + turn_rad.y;
  const double reached = std::clamp(wanted, k_pole_gap_rad, glm::pi<double>() - k_pole_gap_rad);
  const double pitch = upright ? polar - reached : reached - polar;
  camera = turned(camera, glm::angleAxis(-pitch, camera.right()), pivot);
  return turned(camera, glm::angleAxis(upright ? -turn_rad.x : turn_rad.x, axis), pivot);
}

Camera panned(Camera camera, const glm::dvec2& by_px, const glm::ivec2& size) {
  const double length = pixel_length(camera, size);
  camera.target += length * (by_px.y * camera.up() - by_px.x * camera.right());
  return camera;
}

Camera zoomed(Camera camera, double factor, const glm::dvec2& pixel, const glm::ivec2& size) {
  CHECK(factor > 0.0);
  const double height = std::clamp(camera.height / factor, k_min_height, k_max_height);
  const glm::dvec2 under = pixel_length(camera, size) * (pixel - 0.5 * glm::dvec2(size));
  const double kept = 1.0 - height / camera.height;
  camera.target += kept * (under.x * camera.right() - under.y * camera.up());
  camera.height = height;
  return camera;
}

Camera interpolated(const Camera& from, const Camera& to, double t) {
  Camera camera = to;
  camera.target = glm::mix(from.target, to.target, t);
  camera.orientation = glm::slerp(from.orientation, to.orientation, t);
  camera.height = from.height * std::pow(to.height / from.height, t);
  camera.fov_deg = glm::mix(from.fov_deg, to.fov_deg, t);
  return camera;
}

}  // namespace moldlight
