#include "gui/view/presentation.hpp"

#include <algorithm>
#include <utility>

#include <glm/trigonometric.hpp>

#include "base/check.hpp"

namespace moldlight::gui {

namespace {

constexpr double k_flight_s = 1.2;      // of the camera, at an act's beginning, before the mold moves
constexpr double k_opening_rest = 0.6;  // seconds after it has moved
constexpr double k_turn_deg_s = 4.0;    // about the upright axis all the time, so that depth is seen

/// Slow first and last.
double smooth(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace

Presentation::Presentation(std::vector<Act> acts) : acts_(std::move(acts)) { CHECK(!acts_.empty()); }

double Presentation::length_s() const {
  double sum = 0.0;
  for (const Act& act : acts_) sum += act.length_s;
  return sum;
}

double Presentation::opens_s() const {
  double start = 0.0;
  for (const Act& act : acts_) {
    if (act.open > 0.0) return start;
    start += act.length_s;
  }
  return start;
}

Moment Presentation::at(double time_s) const {
  const Act* former = &acts_.front();
  double since_s = std::clamp(time_s, 0.0, length_s());
  const double turn = glm::radians(k_turn_deg_s) * (since_s - 0.5 * length_s());
  const Act* act = former;
  for (const Act& each : acts_) {
    act = &each;
    if (since_s < each.length_s || &each == &acts_.back()) break;
    since_s -= each.length_s;
    former = &each;
  }
  const double opening_s = std::max(act->length_s - k_flight_s - k_opening_rest, 1e-3);
  const double before = act == former ? 0.0 : former->open;
  const double opened = std::clamp((since_s - k_flight_s) / opening_s, 0.0, 1.0);
  const double flown = smooth(since_s / k_flight_s);
  const Camera camera = interpolated(former->camera, act->camera, flown);
  return {.camera = orbited(camera, {turn, 0.0}, {0, 0, 1}, camera.target),
          .open = before + (act->open - before) * opened,
          .floor = former->floor + (act->floor - former->floor) * flown,
          .caption = act->caption};
}

}  // namespace moldlight::gui
