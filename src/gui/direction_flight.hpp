// The parting direction on its way to another one: a function of time.
#pragma once

#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec3.hpp>

#include "gui/motion.hpp"

namespace moldlight::gui {

class DirectionFlight {
 public:
  /// Both of any length but zero. Goes the shorter way along the great circle.
  void start(const glm::dvec3& from, const glm::dvec3& to, double now_s) {
    flight_ = {{glm::normalize(from), to, now_s}};
  }
  void stop() { flight_.reset(); }
  [[nodiscard]] bool flying() const { return flight_.has_value(); }
  /// Where it is now; the flight ends with the time, at the target to the bit.
  [[nodiscard]] glm::dvec3 at(double now_s) {
    const double t = (now_s - flight_->start_s) / k_motion_s;
    const glm::dvec3 from = flight_->from, target = flight_->to;
    if (t >= 1.0) {
      flight_.reset();
      return target;
    }
    const glm::dvec3 to = glm::normalize(target);
    glm::dvec3 aside = to - glm::dot(to, from) * from;
    if (glm::length(aside) < 1e-9) {
      // Half a turn: any way is the shortest.
      aside = glm::cross(from, std::abs(from.z) > 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1));
    }
    const double angle = eased(t) * std::atan2(glm::length(glm::cross(from, to)), glm::dot(from, to));
    return std::cos(angle) * from + std::sin(angle) * glm::normalize(aside);
  }

 private:
  struct Flight {
    glm::dvec3 from{0, 0, 1}, to{0, 0, 1};
    double start_s = 0.0;
  };
  std::optional<Flight> flight_;
};

}  // namespace moldlight::gui
