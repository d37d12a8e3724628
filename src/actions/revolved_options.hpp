// Threads and rings among undercuts.
#pragma once

#include <vector>

#include "actions/side_action.hpp"
#include "actions/undercut_part.hpp"

namespace moldlight {

struct RevolvedContext {
  const PartModel& model;
  const SplitMesh& split;
  const Undercuts& undercuts;
  const ExactQuery& query;
  const ActionSettings& settings;
  const Progress& progress;
};

struct RevolvedOptions {
  std::vector<ActionOption> options;
  std::vector<RejectedAction> rejected;  // rings that would be stretched by more than is permitted
};

/// Threads and rings among what no pull releases: all of it together, as the turns of a thread are undercuts
/// of their own, then each. What a pull would release goes with a thread as well if it lies about as far from
/// the axis, faces it alike and gets away by the same turning. Throws Cancelled.
[[nodiscard]] RevolvedOptions revolved_options(const RevolvedContext& context,
                                               const std::vector<UndercutPart>& undercut_parts);

}  // namespace moldlight
