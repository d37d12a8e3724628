// The verdict on what the window has measured, made anew only where that has changed: finding the place of a
// fault walks over the whole mesh, which no frame has time for.
#pragma once

#include "gui/app_state.hpp"

namespace moldlight::gui {

class VerdictKeeper {
 public:
  /// Call it every frame, after figures and side actions were updated.
  void update(AppState& state);

 private:
  /// What a verdict is made of.
  struct Inputs {
    std::shared_ptr<const PartModel> model;
    std::uint64_t figures = 0;
    std::shared_ptr<const ActionPlan> plan;  // none while it is not settled
    bool operator==(const Inputs&) const = default;
  };
  std::optional<Inputs> made_of_;
};

}  // namespace moldlight::gui
