// The table of options of what pictures show of a part.
#pragma once

#include <span>

#include "classify/option.hpp"
#include "render/view_settings.hpp"

namespace moldlight {

[[nodiscard]] std::span<const Option<LookSettings>> look_options();

}  // namespace moldlight
