// Proving: what a sweep found is compared with bounds over whole cells of directions, and what was missed
// joins it.
#pragma once

#include <vector>

#include "sweep/contender.hpp"
#include "sweep/descent.hpp"
#include "sweep/sweep_result.hpp"
#include "sweep/sweep_settings.hpp"

namespace moldlight {

/// Proves what the settings ask for, all of it within their limit of time, and puts it into the result. What
/// is proved is the undercut, whatever the objective. Directions found on the way with less undercut than all
/// others, measured and polished, join the contenders. Does nothing where none of these is measured; once
/// the clock says to stop, what is open stays open, and when the sweep is cancelled a proof may be missing.
/// `descent`: of what is found where a proof is open.
void prove_sweep(const Descent& descent, const SweepSettings& settings, std::vector<Contender>& contenders,
                 SweepResult& result);

/// Says of the proofs whether they hold, by the directions that the result lists.
void judge_proofs(SweepResult& result);

}  // namespace moldlight
