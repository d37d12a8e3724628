// Remarks on a sweep: by how much the best is better, ties, the directions that the user gave.
#pragma once

#include <string>
#include <vector>

#include "classify/part_model.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight {

/// Sentences on the ranked candidates; none without a candidate.
[[nodiscard]] std::vector<std::string> sweep_remarks(const PartModel& model, const SweepResult& result);

}  // namespace moldlight
