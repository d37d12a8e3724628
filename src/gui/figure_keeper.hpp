// Keeps the legend's figures up with the settings: measures in the background once they rest.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "gui/app_state.hpp"
#include "gui/jobs/measurer.hpp"

namespace moldlight::gui {

class FigureKeeper {
 public:
  FigureKeeper(Measurer::MakeContext make_context, std::function<void()> wake)
      : measurer_(std::move(make_context), std::move(wake)) {}

  /// Call it every frame. `resting`: no drag is under way.
  void update(const AppState& state, Figures& figures, double now_s, bool resting);
  /// When update() wants to be called next without any input; infinity for not at all.
  [[nodiscard]] double wake_s() const { return wake_s_; }

 private:
  Measurer measurer_;
  std::shared_ptr<const PartModel> model_;
  std::optional<MethodSettings> wanted_;
  double changed_s_ = 0.0;
  double wake_s_ = 0.0;
  bool requested_ = false;
};

}  // namespace moldlight::gui
