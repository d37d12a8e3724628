// The window's few movements: flights of the camera and of the direction, the mold's opening, a glow. All are
// functions of time.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec3.hpp>

#include "render/camera.hpp"

namespace moldlight::gui {

inline constexpr double k_motion_s = 0.22;

/// Fast first, then slow: t and the result in [0, 1].
[[nodiscard]] inline double eased(double t) {
  const double left = 1.0 - std::clamp(t, 0.0, 1.0);
  return 1.0 - left * left * left;
}

/// Between two unit directions, the shorter way along the great circle; t in [0, 1].
[[nodiscard]] inline glm::dvec3 interpolated(const glm::dvec3& from, const glm::dvec3& to, double t) {
  glm::dvec3 aside = to - glm::dot(to, from) * from;
  if (glm::length(aside) < 1e-9) {
    // Half a turn: any way is the shortest.
    aside = glm::cross(from, std::abs(from.z) > 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1));
  }
  const double angle = t * std::atan2(glm::length(glm::cross(from, to)), glm::dot(from, to));
  return std::cos(angle) * from + std::sin(angle) * glm::normalize(aside);
}

/// A camera, or a direction, on its way to another one.
template <typename Value>
class Flight {
 public:
  void start(const Value& from, const Value& to, double now_s) { course_ = {{from, to, now_s}}; }
  void stop() { course_.reset(); }
  [[nodiscard]] bool flying() const { return course_.has_value(); }
  /// Where it is now; the flight ends with the time, at the target to the bit.
  [[nodiscard]] Value at(double now_s) {
    const double t = (now_s - course_->start_s) / k_motion_s;
    const Value value = t >= 1.0 ? course_->to : interpolated(course_->from, course_->to, eased(t));
    if (t >= 1.0) stop();
    return value;
  }

 private:
  struct Course {
    Value from, to;
    double start_s = 0.0;
  };
  std::optional<Course> course_;
};

/// How far the mold is open: what a hand moves at once, closing quickly, opening as a shot that can be
/// watched.
class Opening {
 public:
  /// The whole way.
  static constexpr double k_shot_s = 4.0;

  /// Sets where it goes; `at_once` for a target that a hand moves.
  void aim(double target, double now_s, bool at_once) {
    if (target == to_) return;
    from_ = at_once ? target : at(now_s);
    to_ = target;
    start_s_ = now_s;
  }
  [[nodiscard]] double at(double now_s) const {
    if (!moving(now_s)) return to_;
    const double t = (now_s - start_s_) / length_s();
    return from_ + (to_ - from_) * (opens() ? t : eased(t));
  }
  [[nodiscard]] bool moving(double now_s) const { return from_ != to_ && now_s - start_s_ < length_s(); }

 private:
  [[nodiscard]] bool opens() const { return to_ > from_; }
  [[nodiscard]] double length_s() const { return opens() ? k_shot_s * (to_ - from_) : k_motion_s; }

  double from_ = 0.0, to_ = 0.0, start_s_ = -std::numeric_limits<double>::infinity();
};

/// What goes out and comes back, again and again.
class Loop {
 public:
  void start(double now_s) { start_s_ = now_s; }
  /// [0, 1], from 0 on.
  [[nodiscard]] double at(double now_s) const {
    return 0.5 - 0.5 * std::cos(2.0 * glm::pi<double>() * (now_s - start_s_) / k_period_s);
  }

  /// Between frames of what moves slowly.
  static constexpr double k_frame_s = 1.0 / 30.0;

 private:
  static constexpr double k_period_s = 3.2;
  double start_s_ = 0.0;
};

/// The pulse of the undercut's colour when an undercut appears.
class UndercutGlow {
 public:
  /// To be called for every result.
  void see(bool has_undercut, double now_s, bool motion) {
    if (has_undercut && !had_undercut_ && motion) start_s_ = now_s;
    had_undercut_ = has_undercut;
  }
  /// [0, 1]; 0 where it does not glow.
  [[nodiscard]] double at(double now_s) const {
    const double t = (now_s - start_s_) / k_glow_s;
    return t < 0.0 || t >= 1.0 ? 0.0 : std::sin(t * glm::pi<double>());
  }

 private:
  static constexpr double k_glow_s = 0.7;

  bool had_undercut_ = true;  // none is known yet: the first undercut does not appear
  double start_s_ = -1e9;
};

}  // namespace moldlight::gui
