// What the window knows of side actions: which undercut is looked at, how far the search is, what it found.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "actions/side_action.hpp"
#include "gui/jobs/job.hpp"

namespace moldlight::gui {

/// What the user does beside the settings; panels edit a copy of it.
struct ActionChoices {
  std::optional<std::size_t> chosen;  // undercut of the plan whose action is shown
  std::optional<glm::dvec3> wish;  // direction given to its action by hand, until a plan has answered; unit
};

/// A plan outlives changes of the actions' settings until another one is there, but not its undercuts.
struct ActionsState {
  std::shared_ptr<const ActionPlan> plan;
  bool awaited = false;              // there will be another one
  std::optional<JobStatus> running;  // the search for it
  std::uint64_t revision = 0;        // rises with every plan
  std::string error;                 // why there is none
};

/// Whether the plan is of the present settings.
[[nodiscard]] inline bool is_settled(const ActionsState& actions) { return actions.plan && !actions.awaited; }

}  // namespace moldlight::gui
