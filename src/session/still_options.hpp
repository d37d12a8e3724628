// The options of a still picture, for help and command line.
#pragma once

#include <span>
#include <string_view>

#include "session/option.hpp"
#include "session/still_picture.hpp"

namespace moldlight {

/// Every setting but the size.
[[nodiscard]] std::span<const Option<StillSettings>> still_options();

/// A size from "WxH" in pixels, `least` to k_most_picture_px a side; throws UsageError that names `what`.
[[nodiscard]] glm::ivec2 parse_picture_size(std::string_view text, std::string_view what,
                                            const glm::ivec2& least = glm::ivec2(k_least_picture_px));

}  // namespace moldlight
