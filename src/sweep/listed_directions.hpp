// The list of a sweep: contenders with all that is known of them, in their order.
#pragma once

#include <span>
#include <vector>

#include "sweep/contender.hpp"
#include "sweep/mold_ranking.hpp"
#include "sweep/sweep_result.hpp"
#include "sweep/sweep_tools.hpp"

namespace moldlight {

/// Of each measured contender undercuts, parting line and tilt margin are found, too, as far as there is
/// time.
[[nodiscard]] std::vector<SweepCandidate> listed_by_objective(SweepTools& tools,
                                                              std::vector<Contender> listed);
/// `with_tilts`: the tilt margins, too.
[[nodiscard]] std::vector<SweepCandidate> listed_as_molds(SweepTools& tools, MoldRanking::Listed listed,
                                                          bool with_tilts);

/// Measures the axes that listed directions lean from by less than the required draft.
void measure_axes(SweepTools& tools, std::span<const Candidate> axes, std::span<SweepCandidate> candidates);

}  // namespace moldlight
