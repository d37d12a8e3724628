// The options of the method and of how a part is read: the tables behind the flags of every command, the
// settings JSON and the window.
#pragma once

#include <span>

#include "classify/option.hpp"
#include "classify/settings.hpp"
#include "io/read_options.hpp"
#include "render/view_settings.hpp"

namespace moldlight {

[[nodiscard]] std::span<const Option<MethodSettings>> method_options();

/// Limits, unit, body, repair, CAD tessellation.
[[nodiscard]] std::span<const Option<ReadOptions>> reading_options();

/// Checks what no single option can: throws UsageError for settings that contradict each other.
void validate(const MethodSettings& settings);

/// The same for a part of this diagonal, in model units: lengths that are greater make no sense.
void validate(const MethodSettings& settings, double diagonal);

[[nodiscard]] std::span<const Option<LookSettings>> look_options();

}  // namespace moldlight
