// The histogram of draft on a picture of the part.
#pragma once

#include "base/image.hpp"
#include "classify/still_picture.hpp"
#include "parting/draft/draft_check.hpp"

namespace moldlight {

/// Draws the card with the histogram, -5 to 10 degrees, into the lower right corner of a still picture; a
/// picture that is too small for it, or that has no legend, stays as it is.
[[nodiscard]] Image with_draft_histogram(const Image& picture, const PartModel& model,
                                         const DraftCheck& check, const StillSettings& settings);

}  // namespace moldlight
