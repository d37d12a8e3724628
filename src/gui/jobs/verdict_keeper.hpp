// The verdict on what the window has measured, and the cards of recommended directions beside it, made anew
// only where that has changed: finding the place of a fault walks over the whole mesh, which no frame has
// time for.
#pragma once

#include <array>

#include "gui/app_state.hpp"

namespace moldlight::gui {

class VerdictKeeper {
 public:
  /// Call it every frame, after figures, side actions, mold and sweep were updated. While a direction moves
  /// the cards stay.
  void update(AppState& state);

 private:
  /// What a verdict is made of.
  struct Inputs {
    std::shared_ptr<const PartModel> model;
    std::uint64_t figures = 0;
    std::shared_ptr<const ActionPlan> plan;  // none while it is not settled
    bool operator==(const Inputs&) const = default;
  };
  void update_cards(AppState& state);

  std::optional<Inputs> made_of_;
  /// The sweep's result, plan and parting line; of these none while they are not settled.
  std::array<std::shared_ptr<const void>, 3> cards_made_of_;
};

}  // namespace moldlight::gui
