#include "pieces/piece_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "mold/direction.hpp"

namespace moldlight {

std::string pull_words(const glm::dvec3& direction) {
  constexpr double k_whole_deg = 1e-6;
  const NearestAxis axis = nearest_axis(direction);
  const bool between_two = std::ranges::min(std::array{std::abs(direction.x), std::abs(direction.y),
                                                       std::abs(direction.z)}) < k_whole_deg;
  if (axis.is_met() || !between_two || std::abs(axis.angle_deg - std::round(axis.angle_deg)) > k_whole_deg)
    return direction_words(direction);
  return fmt::format("{:.0f}° off {} (towards {})", axis.angle_deg, axis.name,
                     lean_text(axis.axis, direction));
}

std::string piece_name(std::size_t direction) { return fmt::format("piece_{}", direction + 1); }

}  // namespace moldlight
