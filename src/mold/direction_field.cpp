#include "mold/direction_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "base/check.hpp"

namespace moldlight {

namespace {

/// Squared sine of 0.2 degrees: closer than that a value is simply taken.
constexpr double k_nearest = 1.2e-5;
/// Cells beyond the rim on each side, so that the rim lies between cells as every other place does.
constexpr int k_margin = 2;
/// Directions of an even set are this many of their spacings in reach of a place.
constexpr double k_reach_spacings = 1.7, k_least_reach_deg = 4.0, k_greatest_reach_deg = 24.0;

// Evenly spaced; lightness falls from 96 to 14.
constexpr std::array<Colour, 7> k_stops = {{{0xFD, 0xF4, 0xE3},
                                            {0xFA, 0xD2, 0xA6},
                                            {0xF4, 0xA2, 0x72},
                                            {0xE2, 0x6A, 0x55},
                                            {0xB7, 0x3A, 0x4F},
                                            {0x75, 0x1F, 0x46},
                                            {0x36, 0x12, 0x2E}}};

}  // namespace

glm::dvec2 equal_area_point(const glm::dvec3& direction) {
  const double z = std::clamp(direction.z, -1.0, 1.0);
  const double across = std::hypot(direction.x, direction.y);
  if (across <= 0.0) return z >= 0.0 ? glm::dvec2(0.0) : glm::dvec2(std::sqrt(2.0), 0.0);
  return glm::dvec2(direction.x, direction.y) * (std::sqrt(1.0 - z) / across);
}

glm::dvec3 equal_area_direction(const glm::dvec2& point) {
  const double squared = std::min(glm::dot(point, point), 2.0);
  return glm::normalize(glm::dvec3(point * std::sqrt(2.0 - squared), 1.0 - squared));
}

double even_set_reach_deg(int directions) {
  const double spacing_rad = std::sqrt(2.0 * glm::pi<double>() * 1.155 / std::max(directions, 1));
  return std::clamp(k_reach_spacings * glm::degrees(spacing_rad), k_least_reach_deg, k_greatest_reach_deg);
}

DirectionField::DirectionField(double reach_deg, int cells)
    : cells_(cells + 2 * k_margin), span_(2.0 * cells_ / cells), reach_(glm::radians(reach_deg)) {
  CHECK(cells >= 2 && reach_deg > 0.0 && reach_deg <= 90.0);
  for (int y = 0; y < cells_; ++y) {
    for (int x = 0; x < cells_; ++x) {
      directions_.push_back(
          equal_area_direction(((glm::dvec2(x, y) + 0.5) / static_cast<double>(cells_) - 0.5) * span_));
    }
  }
  grid_.resize(directions_.size());
}

void DirectionField::add(const glm::dvec3& direction, double value) {
  empty_ = false;
  for (std::size_t k = 0; k < grid_.size(); ++k) {
    const double cosine = glm::dot(directions_[k], direction);
    const double squared_sine = std::max(1.0 - cosine * cosine, 0.0);
    const double far = squared_sine + k_nearest;
    const double weight = 1.0 / (far * far * far);
    grid_[k].weights += weight;
    grid_[k].weighted += weight * value;
    grid_[k].nearest = std::min(grid_[k].nearest, squared_sine);
  }
}

DirectionField::Reading DirectionField::reading(int x, int y) const {
  const Cell& cell = grid_[static_cast<std::size_t>(y * cells_ + x)];
  const double angle = std::asin(std::sqrt(std::clamp(cell.nearest, 0.0, 1.0)));
  const double near = std::clamp(2.0 * (1.0 - angle / reach_), 0.0, 1.0);
  return {cell.weighted / cell.weights, near * near * (3.0 - 2.0 * near)};
}

DirectionField::Reading DirectionField::at(const glm::dvec3& direction) const {
  if (empty_) return {};
  const glm::dvec2 point = equal_area_point(direction.z < 0.0 ? -direction : direction);
  const glm::dvec2 place =
      glm::clamp((point / span_ + 0.5) * static_cast<double>(cells_) - 0.5, 0.0, cells_ - 1.001);
  const int x = static_cast<int>(place.x), y = static_cast<int>(place.y);
  const glm::dvec2 f = place - glm::dvec2(x, y);
  Reading mean;
  for (int k = 0; k < 4; ++k) {
    const Reading corner = reading(x + k % 2, y + k / 2);
    const double share = (k % 2 != 0 ? f.x : 1.0 - f.x) * (k / 2 != 0 ? f.y : 1.0 - f.y);
    mean.value += share * corner.value;
    mean.cover += share * corner.cover;
  }
  return mean;
}

double undercut_scale(double area, double worst) {
  return worst > 0.0 ? std::sqrt(std::clamp(area / worst, 0.0, 1.0)) : 0.0;
}

Colour undercut_scale_colour(double place) {
  const double at = std::clamp(place, 0.0, 1.0) * (k_stops.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(at), k_stops.size() - 2);
  const double f = at - static_cast<double>(k);
  const auto mix = [f](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + f * (b - a)));
  };
  const Colour &a = k_stops[k], &b = k_stops[k + 1];
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

}  // namespace moldlight
