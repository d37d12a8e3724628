// The report on a comparison: a table for people, JSON for programs.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "compare/comparison.hpp"

namespace moldlight {

/// Schema `moldlight.compare/1`. Lengths and areas are in A's unit.
[[nodiscard]] nlohmann::ordered_json compare_json(const Comparison& comparison);

/// At most 80 columns but for names and the verdict.
[[nodiscard]] std::string compare_table(const Comparison& comparison);

}  // namespace moldlight
