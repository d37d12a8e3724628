// Proving: what a sweep found is compared with bounds over whole cells of directions, and what was missed
// joins it.
#pragma once

#include <vector>

#include "sweep/contender.hpp"
#include "sweep/polish.hpp"
#include "sweep/sweep_result.hpp"
#include "sweep/sweep_settings.hpp"

namespace moldlight {

struct Proving {
  Polishing polishing;  // of what is found where a proof is open
  const SweepSettings& settings;
  int jobs;  // threads
};

/// Proves what the settings ask for, all of it within their limit of time, and puts it into the result. What
/// is proved is the undercut, whatever the objective. Directions found on the way with less undercut than all
/// others, measured and polished, join the contenders. Does nothing where none of these is measured; once
/// the clock says to stop, what is open stays open, and when the sweep is cancelled a proof may be missing.
void prove_sweep(const Proving& proving, std::vector<Contender>& contenders, SweepResult& result);

/// Says of the proofs whether they hold, by the directions that the result lists.
void judge_proofs(SweepResult& result);

}  // namespace moldlight
