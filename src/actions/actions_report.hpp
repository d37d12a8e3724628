// The report on side actions: a table for people, JSON and CSV for programs.
#pragma once

#include <span>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "actions/design_change.hpp"
#include "actions/side_action.hpp"

namespace moldlight {

/// What a report is about.
struct ActionsReport {
  const PartModel& model;
  const Classification& result;
  const ActionSettings& settings;
  const ActionPlan& plan;
  std::span<const DesignChange> changes = {};  // of each undercut; empty where they were not looked for
};

/// Schema `moldlight.actions/2`. Lengths and areas are in the part's unit, angles in degrees; what does not
/// apply or is without end is null. Undercuts are numbered from 1, the largest first.
[[nodiscard]] nlohmann::ordered_json actions_json(const ActionsReport& report);

/// How far a pull may turn, "-1.20 to 3.00°"; a thread's pitch, a ring's strain.
[[nodiscard]] std::string freedom_text(const SideAction& action, const std::string& unit);
/// What frees an undercut without an action, or gives its lifter room: "widen the mouth from 1 to 6 mm, for a
/// lifter, or cut back by 2.4 mm, or open 47.9 mm² towards core at 1, 2, 3, through 1.5 to 2 mm"; "-" for
/// nothing. The changes were looked for. `with_places`: where the window is, too.
[[nodiscard]] std::string change_text(const ActionsReport& report, std::size_t undercut,
                                      bool with_places = true);
/// "68 mm² · depth 2 mm · travel 5 mm · free -1.0 to 1.0° · with 3", without what is not known.
[[nodiscard]] std::string undercut_items(const PartModel& model, const ActionPlan& plan,
                                         std::size_t undercut);
/// The same of its action alone, in lines: its direction, what it meets, its body.
[[nodiscard]] std::string undercut_details(const PartModel& model, const ActionPlan& plan,
                                           std::size_t undercut);
/// Pairs of slides, or of lifters, that would meet, named as their rows are counted, in a paragraph; empty
/// where there are none.
[[nodiscard]] std::string meetings_text(const ActionPlan& plan);
/// Core pins that are too slender, likewise.
[[nodiscard]] std::string pins_notice(const PartModel& model, const ActionPlan& plan);
/// "1, 4, 5" for these numbers, which count from 0.
[[nodiscard]] std::string numbers_text(const std::vector<std::size_t>& numbers);
/// Actions that cannot be built, likewise; those of one kind and reason together.
[[nodiscard]] std::string rejected_text(const PartModel& model, const ActionPlan& plan);

/// Of an action's body in the mold's sequence: "clear", "0.57 mm deep in the part at rest"; "-" without one.
[[nodiscard]] std::string clear_text(const SideAction& action, const ActionPlan& plan,
                                     const std::string& unit);

/// A line an undercut, with the action that releases it; a heading line names the options.
[[nodiscard]] std::string actions_csv(const ActionsReport& report);

}  // namespace moldlight
