// The window's few movements: camera flights, the mold's opening, a glow. All are functions of time.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "render/camera.hpp"

namespace moldlight::gui {

inline constexpr double k_motion_s = 0.22;

/// Fast first, then slow: t and the result in [0, 1].
[[nodiscard]] inline double eased(double t) {
  const double left = 1.0 - std::clamp(t, 0.0, 1.0);
  return 1.0 - left * left * left;
}

class CameraFlight {
 public:
  void start(const Camera& from, const Camera& to, double now_s) { flight_ = {{from, to, now_s}}; }
  void stop() { flight_.reset(); }
  [[nodiscard]] bool flying() const { return flight_.has_value(); }
  /// Where the camera is now; the flight ends with the time.
  [[nodiscard]] Camera at(double now_s) {
    const double t = (now_s - flight_->start_s) / k_motion_s;
    const Camera camera = t >= 1.0 ? flight_->to : interpolated(flight_->from, flight_->to, eased(t));
    if (t >= 1.0) flight_.reset();
    return camera;
  }

 private:
  struct Flight {
    Camera from, to;
    double start_s = 0.0;
  };
  std::optional<Flight> flight_;
};

/// A number that follows its target in k_motion_s.
class EasedNumber {
 public:
  /// Sets where it goes; `at_once` for a target that a hand moves.
  void aim(double target, double now_s, bool at_once) {
    if (target == to_) return;
    from_ = at_once ? target : at(now_s);
    to_ = target;
    start_s_ = now_s;
  }
  [[nodiscard]] double at(double now_s) const {
    return moving(now_s) ? from_ + (to_ - from_) * eased((now_s - start_s_) / k_motion_s) : to_;
  }
  [[nodiscard]] bool moving(double now_s) const { return from_ != to_ && now_s - start_s_ < k_motion_s; }

 private:
  double from_ = 0.0, to_ = 0.0, start_s_ = -std::numeric_limits<double>::infinity();
};

}  // namespace moldlight::gui
