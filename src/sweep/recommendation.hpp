// What a sweep recommends: the first of the directions that it lists, with the side of it that is the core.
#pragma once

#include <span>

#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight {

/// The first of them, which side of it is the core, and why. The part shrinks onto the half that forms more
/// of its inner walls, stays on it when the mold opens, and is ejected there. Where both form as much, the
/// core is the half that forms more of the surface alone. Throws Cancelled.
[[nodiscard]] Recommendation recommendation(const PartModel& model, const MethodSettings& method,
                                            std::span<const SweepCandidate> candidates,
                                            const Progress& progress);

}  // namespace moldlight
