#include "gui/figure_keeper.hpp"

#include <limits>

namespace moldlight::gui {

namespace {

constexpr double k_rest_s = 0.15;  // for which the settings must rest before they are measured

}  // namespace

void FigureKeeper::update(const AppState& state, Figures& figures, double now_s, bool resting) {
  wake_s_ = std::numeric_limits<double>::infinity();
  if (!state.model) {
    if (wanted_) measurer_.cancel();
    wanted_.reset();
    figures = {};
    return;
  }
  if (model_ != state.model || wanted_ != state.settings.method) {
    if (model_ != state.model) figures = {};
    model_ = state.model;
    wanted_ = state.settings.method;
    changed_s_ = now_s;
    requested_ = false;
    measurer_.cancel();
    figures.stale = true;
    figures.error.clear();
  }
  if (!requested_ && resting && now_s >= changed_s_ + k_rest_s) {
    measurer_.request(model_, *wanted_);
    requested_ = true;
  }
  if (!requested_ && resting) wake_s_ = changed_s_ + k_rest_s;
  if (auto outcome = measurer_.take()) {
    figures.shown = std::move(outcome->classification);
    figures.error = std::move(outcome->error);
    figures.stale = false;
    ++figures.revision;
  }
  figures.measuring = requested_ && measurer_.busy();
}

}  // namespace moldlight::gui
