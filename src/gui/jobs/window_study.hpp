// The window's part and settings as a study, so that what runs in the background asks what every outlet asks.
#pragma once

#include "gui/app_state.hpp"
#include "study/study.hpp"

namespace moldlight::gui {

/// The part with the present questions, side actions among them, and no answers.
[[nodiscard]] Study asked_study(const AppState& state);
/// The same with the regions that were measured, which must be there.
[[nodiscard]] Study measured_study(const AppState& state);

}  // namespace moldlight::gui
