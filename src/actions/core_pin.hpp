// Holes that a thin pin of steel forms.
#pragma once

#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "actions/release.hpp"

namespace moldlight {

/// The pin that forms a hole, or as much of one as its samples say.
struct CorePin {
  double width = 0.0;    // across, where it is wider
  double length = 0.0;   // of the hole
  glm::dvec3 axis{0.0};  // unit, either way along it
};

/// A pin longer than so many widths bends, which is said.
inline constexpr double k_slender_pin = 8.0;

/// The pin that forms most of what the samples stand for, if it is no wider than `widest`: the median of the
/// steel before them that has the part all round it; none for a slot or an open recess. Unit frame, its
/// length is not asked for.
[[nodiscard]] std::optional<CorePin> core_pin_of(const Release& release,
                                                 std::span<const UndercutSample> samples, double widest);

}  // namespace moldlight
