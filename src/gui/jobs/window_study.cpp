#include "gui/jobs/window_study.hpp"

#include <memory>
#include <utility>

namespace moldlight::gui {

Study asked_study(const AppState& state) {
  Questions questions;
  questions.query = state.settings;
  questions.with_actions = true;
  questions.actions = state.settings.actions;
  questions.mold = state.settings.mold;
  questions.required_draft_deg = state.settings.required_draft.deg;
  return Study(state.model, std::move(questions));
}

Study measured_study(const AppState& state) {
  Study study = asked_study(state);
  SplitRegions regions{*state.figures.shown};
  regions.result.split = state.figures.split;
  study.keep(std::make_shared<const SplitRegions>(std::move(regions)));
  return study;
}

}  // namespace moldlight::gui
