// What the window knows of side actions: which undercut is looked at, how far the search is, what it found.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "actions/side_action.hpp"
#include "actions/to_be_free.hpp"
#include "base/job.hpp"
#include "render/view_body.hpp"

namespace moldlight::gui {

/// What the user does beside the settings; panels edit a copy of it.
struct ActionChoices {
  std::optional<std::size_t> chosen;  // undercut of the plan whose action is shown
  std::optional<glm::dvec3> wish;  // direction given to its action by hand, until a plan has answered; unit
};

/// The solids that a plan's actions move.
struct ActionBodies {
  std::vector<ViewBody> bodies;
  std::vector<std::size_t> actions;  // of each
};

/// A plan outlives changes of the actions' settings until another one is there, but not its undercuts.
struct ActionsState {
  std::shared_ptr<const ActionPlan> plan;
  std::shared_ptr<const ActionBodies> bodies;            // of the plan
  std::shared_ptr<const std::vector<ToBeFree>> changes;  // of its undercuts; null until they are known
  bool awaited = false;                                  // there will be another one
  bool changes_awaited = false;                          // they are looked for
  std::optional<JobStatus> running;                      // the search for it
  std::uint64_t revision = 0;                            // rises with every plan
  std::string error;                                     // why there is none
};

/// Whether the plan is of the present settings.
[[nodiscard]] inline bool is_settled(const ActionsState& actions) { return actions.plan && !actions.awaited; }

}  // namespace moldlight::gui
