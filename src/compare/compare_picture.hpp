// A picture of two revisions side by side, seen from one side, with what differs lit.
#pragma once

#include "base/image.hpp"
#include "classify/still_picture.hpp"
#include "compare/comparison.hpp"

namespace moldlight {

/// A on the left with what is gone, B on the right with what is new, both with surface that is of another
/// region; from where most of that is seen unless the settings say otherwise. Throws as StillPainter does.
[[nodiscard]] Image comparison_picture(const gl::Context& context, const Comparison& comparison,
                                       StillSettings settings, const Progress& progress);

}  // namespace moldlight
