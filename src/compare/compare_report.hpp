// The report on a comparison: JSON for programs.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "compare/comparison.hpp"

namespace moldlight {

/// Schema `moldlight.compare/1`. Lengths and areas are in A's unit.
[[nodiscard]] nlohmann::ordered_json compare_json(const Comparison& comparison);

}  // namespace moldlight
