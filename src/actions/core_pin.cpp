#include "actions/core_pin.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "mold/map_frame.hpp"

namespace moldlight {

namespace {

/// Of one sample.
std::optional<CorePin> core_pin_at(const Release& release, const UndercutSample& sample, double widest) {
  constexpr int k_turns = 16;  // of lines across the first, over half a turn
  const auto across = release.gap(glm::dvec3(sample.position), sample.normal);
  if (!across || *across > widest) return std::nullopt;
  const glm::dvec3 middle = glm::dvec3(sample.position) + 0.5 * *across * sample.normal;
  const MapFrame frame = map_frame(sample.normal);
  std::optional<CorePin> pin;
  double shortest = widest;
  for (int k = 0; k < k_turns; ++k) {
    const double angle = std::numbers::pi * k / k_turns;
    const glm::dvec3 line = std::cos(angle) * frame.x + std::sin(angle) * frame.y;
    const auto ahead = release.gap(middle, line), behind = release.gap(middle, -line);
    if (!ahead || !behind || *ahead + *behind > shortest) continue;
    shortest = *ahead + *behind;
    pin = CorePin{.width = std::max(*across, shortest), .axis = glm::cross(sample.normal, line)};
  }
  return pin;
}

}  // namespace

std::optional<CorePin> core_pin_of(const Release& release, std::span<const UndercutSample> samples,
                                   double widest) {
  std::vector<std::pair<CorePin, double>> pins;
  double area = 0.0, of_pins = 0.0;
  for (const UndercutSample& sample : samples) {
    area += sample.area;
    const auto pin = core_pin_at(release, sample, widest);
    if (!pin) continue;
    of_pins += sample.area;
    pins.emplace_back(*pin, sample.area);
  }
  if (pins.empty() || of_pins <= 0.5 * area) return std::nullopt;
  std::ranges::stable_sort(pins, {}, [](const auto& pin) { return pin.first.width; });
  auto median = pins.begin();
  for (double gone = median->second; gone < 0.5 * of_pins; gone += median->second) ++median;
  return median->first;
}

}  // namespace moldlight
