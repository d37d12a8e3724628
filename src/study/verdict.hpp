// The verdict on a part and a direction: what everything that shows a result says of it first.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actions/side_action.hpp"
#include "actions/verdict_state.hpp"
#include "classify/classification.hpp"
#include "classify/json.hpp"
#include "classify/part_model.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight {

/// Areas are in the part's unit squared.
struct Verdict {
  VerdictState state = VerdictState::unknown;
  std::string sentence;       // with a full stop
  std::size_t undercuts = 0;  // that count: those of the list of side actions
  double undercut_area = 0.0;
  double unreleased_area = 0.0;
  std::size_t specks = 0;  // too small or too shallow to count
  double speck_area = 0.0;
  ActionCounts actions{};
  std::vector<std::string> reasons;  // what else there is to say, a sentence each

  /// Nothing to be done about the part: the one state that is shown with a tick.
  [[nodiscard]] bool good() const { return state == VerdictState::two_plate; }
  bool operator==(const Verdict&) const = default;
};

/// What a verdict is made of.
struct VerdictFacts {
  const PartModel& model;
  const Classification& regions;
  UndercutTotals undercuts;
  std::optional<ActionTotals> actions;  // none where they were not asked for
  const ActionPlan* plan = nullptr;     // that the actions are of, where it is at hand
};
[[nodiscard]] Verdict verdict_of(const VerdictFacts& facts);
/// The same of a plan of side actions.
[[nodiscard]] Verdict verdict_of(const PartModel& model, const Classification& regions,
                                 const ActionPlan& plan);
/// Of a direction that a sweep lists; none where the sweep ended before its undercuts were counted.
[[nodiscard]] std::optional<Verdict> verdict_of(const PartModel& model, const SweepCandidate& candidate);

/// {"state", "sentence", "undercuts", "undercut_area", "unreleased_area", "specks": {"number", "area"},
/// "actions": {"slide": 2}, "reasons"}.
[[nodiscard]] Json verdict_json(const Verdict& verdict);

}  // namespace moldlight
