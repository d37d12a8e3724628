// What there is to say of one side action in a line, beside its kind and travel.
#pragma once

#include <string>

#include "actions/side_action.hpp"

namespace moldlight {

/// A lifter's stroke, a thread's pitch, a ring's strain, the sector in which it may turn; `unit`: of lengths.
[[nodiscard]] std::string detail_text(const SideAction& action, const std::string& unit);
/// " · with 2, 3": the other undercuts that it releases, counted from 1; nothing where there is none.
[[nodiscard]] std::string shared_text(const SideAction& action, std::size_t undercut);
/// " · and lifter": what releases the rest of an undercut that `first` does not release whole.
[[nodiscard]] std::string others_text(const ActionPlan& plan, std::size_t undercut, const SideAction& first);
/// " · meets the slide of 3": the actions that it would meet, by the undercuts that they release.
[[nodiscard]] std::string meets_text(const ActionPlan& plan, const SideAction& action);

}  // namespace moldlight
