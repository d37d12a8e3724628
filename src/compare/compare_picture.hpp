// A picture of two revisions side by side, seen from one side, with what differs lit.
#pragma once

#include "base/image.hpp"
#include "classify/still_picture.hpp"
#include "compare/comparison.hpp"

namespace moldlight {

enum class Revision : std::uint8_t { former, fresh };

/// What is lit on one of the parts, a thin plate on each bit of surface: what is gone of the former or new on
/// the new part, and what is of another region; named so by their labels. None where nothing differs.
[[nodiscard]] std::vector<StillBody> lit_bodies(const Comparison& comparison, Revision revision);
/// Orientation of a camera from where most of what is lit is seen.
[[nodiscard]] glm::dquat lit_seen_from(const Comparison& comparison);

/// A on the left with what is gone, B on the right with what is new, both with surface that is of another
/// region; from where most of that is seen unless the settings say otherwise. Throws as StillPainter does.
[[nodiscard]] Image comparison_picture(const gl::Context& context, const Comparison& comparison,
                                       StillSettings settings, const Progress& progress);

}  // namespace moldlight
